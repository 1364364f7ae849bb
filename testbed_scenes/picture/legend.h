// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_LEGEND_H
#define BOOMERANG_TESTBED_LEGEND_H

#include <functional>
#include <string>
#include <vector>

#include "picture/picture.h"
#include "picture/world_view.h"

namespace testbed {

/// What is in a picture, with a sample of each: rows of entries below it.
class Legend {
public:
    /// Lays the entries out in rows of this width (of the page). One of a series explains what the whole
    /// series holds, without counts. A kinetic world has words of its own.
    Legend(Canvas &canvas, const WorldView &world, const PictureOptions &options, std::string title,
           double width, double unit);

    double Height() const;
    /// Its upper left corner at `top`, on the page.
    void Draw(bmr_vec2 top) const;

private:
    struct Entry {
        std::string text;
        double sample; ///< width that the sample takes
        /// Draws the sample in a box of the sample's width whose left end's middle this is.
        std::function<void(bmr_vec2 left)> draw;
        double left = 0.0;
        int row = 0;
    };
    void AddBodies();
    void AddProofs();
    void AddScale();
    void AddOthers();
    void Add(const std::string &text, double sample, std::function<void(bmr_vec2)> draw);
    void AddLine(const std::string &text, const Pen &pen);
    void LayOut(double width);

    Canvas &m_canvas;
    const PictureOptions &m_options;
    Contents m_contents;
    const bool m_kinetic;
    const double m_unit;
    const std::string m_title;
    std::vector<Entry> m_entries;
    int m_rows = 1;
};

/// How long something is in the world: a bar of a round length in the lower left corner of the area. What it
/// takes of the page.
Rectangle DrawScaleBar(Canvas &canvas, const Rectangle &area, double pagePerWorld, double unit, bool kinetic);

} // namespace testbed

#endif
