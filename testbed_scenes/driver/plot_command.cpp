// SPDX-License-Identifier: MIT
#include "plot_command.h"

#include <iostream>

#include "commands.h"
#include "drawing/series_file.h"
#include "drawing/whole_file.h"

namespace testbed {
namespace {

/// What the headings leave open is not worth writing at an axis.
std::string LabelOf(const std::string &option, const std::string &heading, const char *open) {
    return !option.empty() || heading == open ? option : heading;
}

SeriesFile Read(const std::string &path) {
    try {
        return ReadSeriesFile(path);
    } catch (const SeriesFileError &error) {
        throw UsageError(error.what());
    }
}

} // namespace

int Execute(const PlotCommand &command) {
    if (!IsPicturePath(command.output))
        throw UsageError("a picture ends in .svg, .png or .pdf, not so " + command.output);
    WholeFile::Check(command.output);
    constexpr double kWidth = 520.0, kHeight = 380.0, kMargin = 4.0;
    Plot plot;
    plot.title = command.title;
    const SeriesFile file = Read(command.csv);
    plot.xLabel = LabelOf(command.xLabel, file.xHeading, "x");
    plot.yLabel = LabelOf(command.yLabel, file.yHeading, "y");
    plot.series = file.series;
    Canvas canvas(command.output, kWidth, kHeight);
    DrawPlot(canvas, {kMargin, kMargin, kWidth - kMargin, kHeight - kMargin}, plot);
    canvas.Write();
    std::cout << command.output << '\n';
    return kExitOk;
}

} // namespace testbed
