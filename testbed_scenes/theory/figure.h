// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FIGURE_H
#define BOOMERANG_TESTBED_FIGURE_H

#include <string>
#include <vector>

#include "boomerang/hierarchy.h"
#include "drawing/canvas.h"
#include "theory/course.h"

namespace testbed {

/// A figure of the paper, or one that explains what the paper leaves out, drawn from the real structures.
struct FigureInfo {
    const char *name;    ///< of its file
    const char *title;   ///< one line
    const char *section; ///< where it belongs in the paper
    double width, height;
    void (*draw)(Canvas &canvas);
};

/// All figures, in the order of the paper.
const std::vector<FigureInfo> &AllFigures();

// One file of figures/ each.
void DrawBoomerangs(Canvas &canvas);
void DrawDudley(Canvas &canvas);
void DrawMixedInsertion(Canvas &canvas);
void DrawMixedFull(Canvas &canvas);
void DrawMixedEvents(Canvas &canvas);
void DrawInflated(Canvas &canvas);
void DrawWindow(Canvas &canvas);
void DrawPointEvents(Canvas &canvas);
void DrawPairEvents(Canvas &canvas);
void DrawFreeDirection(Canvas &canvas);
void DrawCoarseLine(Canvas &canvas);
void DrawGrowth(Canvas &canvas);

/// The corners of the envelope P_level, counter-clockwise.
std::vector<bmr_vec2> Envelope(const bmr_hierarchy *hierarchy, uint32_t level);
/// The smallest rectangle around the points, widened by `margin` of its larger side.
Rectangle Around(const std::vector<bmr_vec2> &points, double margin);
/// The points taken from a pose's frame outwards.
std::vector<bmr_vec2> Placed(const std::vector<bmr_vec2> &points, const bmr_pose &pose);
/// An entry of a legend: what a line of this kind means.
void DrawKey(Canvas &canvas, bmr_vec2 at, const Pen &pen, const std::string &text, double size = 10.5);
/// The line of a proof in the frame of the page, which is A's; B is at `pose`.
void DrawLine(Canvas &canvas, const bmr_kds_proof &proof, const bmr_pose &pose, const Pen &pen);
/// Points of an ellipse with these half axes, the first at the parameter `turn`.
std::vector<bmr_vec2> EllipsePoints(size_t count, double a, double b, double turn);

} // namespace testbed

#endif
