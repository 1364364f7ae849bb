// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURES_H
#define BOOMERANG_TESTBED_PICTURES_H

#include <ostream>
#include <string>
#include <variant>
#include <vector>

#include "drawing/plot.h"
#include "drawing/row_plot.h"
#include "report/numbers.h"

namespace testbed {

/// One plot of the report, on the page or as a file of its own.
struct Picture {
    std::string name;    ///< of its file, without an ending; unique in a report
    std::string caption; ///< what it shows and how to read it
    std::variant<Plot, RowPlot> plot;

    const std::string &Title() const;
    /// In words, for who does not see it.
    std::string Description() const;
};

/// The speed-ups and the calls saved, scene by scene; none without scenes.
std::vector<Picture> ScenePictures(const Numbers &numbers);
/// Events against D/sigma, a picture for each motion; events and work against n where there are several n.
std::vector<Picture> EventPictures(const Numbers &numbers);
/// Time of a step against bodies, where a scene was run at several sizes, and the costs from files.
std::vector<Picture> CostPictures(const Numbers &numbers);

/// Draws it as an SVG.
void WriteSvg(std::ostream &out, const Picture &picture);

/// An SVG that WriteSvg wrote, for the inside of an HTML page: its ids begin with the prefix, so that several
/// may share a page; its size is left to the style sheet; and it is one image with this description.
std::string EmbeddedSvg(const std::string &svg, const std::string &prefix, const std::string &description);

} // namespace testbed

#endif
