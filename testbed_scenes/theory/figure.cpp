// SPDX-License-Identifier: MIT
#include "theory/figure.h"

#include <algorithm>
#include <cmath>

namespace testbed {

const std::vector<FigureInfo> &AllFigures() {
    static const std::vector<FigureInfo> figures = {
        {"boomerangs", "A boomerang hierarchy: envelopes, apexes and heights", "section 3", 640, 420,
         DrawBoomerangs},
        {"dudley", "Dudley's construction: a circle of radius 2D and its outward normals", "section 3", 900,
         480, DrawDudley},
        {"mixed-insertion", "Inserting an edge into the mixed hierarchy", "section 4", 640, 360,
         DrawMixedInsertion},
        {"mixed-full", "A full mixed hierarchy: two polygons, the cut order, a point's cell", "section 4",
         640, 420, DrawMixedFull},
        {"mixed-events", "A page turn, a collapse and an expansion under rotation", "section 4", 560, 906,
         DrawMixedEvents},
        {"point-events", "Events of a point: triangles crossed, and stab and push", "section 5", 900, 290,
         DrawPointEvents},
        {"pair-events", "Events of two polygons: stab, push and roll", "section 5", 900, 330, DrawPairEvents},
        {"inflated", "An inflated hierarchy and its connecting edges", "section 6", 640, 460, DrawInflated},
        {"window", "Rotational hysteresis: a window of three corners and its cone", "section 6", 640, 440,
         DrawWindow},
        {"free-direction", "A free direction, its bracket and its window", "section 7", 640, 340,
         DrawFreeDirection},
        {"coarse-line", "The coarse line, and the trees over both bodies' edges", "section 7", 640, 430,
         DrawCoarseLine},
        {"growth", "Events against D/sigma: Table 1 measured", "table 1", 900, 380, DrawGrowth},
    };
    return figures;
}

std::vector<bmr_vec2> Envelope(const bmr_hierarchy *hierarchy, uint32_t level) {
    std::vector<bmr_vec2> corners;
    const bmr_edge first = 0;
    bmr_edge edge = first;
    do {
        const bmr_corner corner = bmr_hierarchy_corner_after(hierarchy, edge, level);
        corners.push_back(bmr_hierarchy_corner_point(hierarchy, corner));
        edge = corner.after;
    } while (edge != first);
    return corners;
}

Rectangle Around(const std::vector<bmr_vec2> &points, double margin) {
    Rectangle box = NoRectangle();
    for (const bmr_vec2 &point : points)
        Grow(&box, point);
    return Widened(box, margin);
}

std::vector<bmr_vec2> Placed(const std::vector<bmr_vec2> &points, const bmr_pose &pose) {
    std::vector<bmr_vec2> placed;
    placed.reserve(points.size());
    for (const bmr_vec2 &point : points)
        placed.push_back(bmr_transform(&pose, point));
    return placed;
}

void DrawKey(Canvas &canvas, bmr_vec2 at, const Pen &pen, const std::string &text, double size) {
    canvas.Segment(at, bmr_vec2_make(at.x + 22.0, at.y), pen);
    canvas.Text(bmr_vec2_make(at.x + 28.0, at.y - 4.0), 0.0, 0.0, text, size);
}

void DrawLine(Canvas &canvas, const bmr_kds_proof &proof, const bmr_pose &pose, const Pen &pen) {
    const bmr_pose owner = proof.owner == 0 ? bmr_pose_identity() : pose;
    const bmr_vec2 normal = bmr_rotate(&owner, proof.line.normal);
    canvas.Line(normal, proof.line.offset + bmr_dot(normal, owner.position), pen);
}

std::vector<bmr_vec2> EllipsePoints(size_t count, double a, double b, double turn) {
    std::vector<bmr_vec2> points;
    for (size_t i = 0; i < count; ++i) {
        const double angle = turn + 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
        points.push_back(bmr_vec2_make(a * std::cos(angle), b * std::sin(angle)));
    }
    return points;
}

} // namespace testbed
