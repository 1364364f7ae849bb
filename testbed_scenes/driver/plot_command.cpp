// SPDX-License-Identifier: MIT
#include "plot_command.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

#include "commands.h"
#include "drawing/plot.h"

namespace testbed {
namespace {

double ReadNumber(const std::string &text, const std::string &line) {
    std::istringstream stream(text);
    double number = 0.0;
    if (!(stream >> number) || !stream.eof() || !std::isfinite(number))
        throw UsageError("not a line of series,x,y: " + line);
    return number;
}

/// Series in the order of their first lines.
std::vector<PlotSeries> ReadSeries(const std::string &path) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) // the headings
        throw UsageError("cannot read " + path + ", or it is empty");
    std::vector<PlotSeries> all;
    while (std::getline(file, line)) {
        const size_t last = line.rfind(',');
        const size_t first = last == 0 || last == std::string::npos ? last : line.rfind(',', last - 1);
        if (first == std::string::npos || first == last)
            throw UsageError("not a line of series,x,y: " + line);
        const std::string name = line.substr(0, first);
        auto found = std::find_if(all.begin(), all.end(),
                                  [&name](const PlotSeries &series) { return series.name == name; });
        if (found == all.end())
            found = all.insert(all.end(), {name, {}, ink::Series(all.size())});
        found->points.push_back({ReadNumber(line.substr(first + 1, last - first - 1), line),
                                 ReadNumber(line.substr(last + 1), line)});
    }
    return all;
}

} // namespace

int Execute(const PlotCommand &command) {
    if (!IsPicturePath(command.output))
        throw UsageError("a picture ends in .svg, .png or .pdf, not so " + command.output);
    constexpr double kWidth = 520.0, kHeight = 380.0, kMargin = 4.0;
    Plot plot;
    plot.title = command.title;
    plot.xLabel = command.xLabel;
    plot.yLabel = command.yLabel;
    plot.series = ReadSeries(command.csv);
    Canvas canvas(command.output, kWidth, kHeight);
    DrawPlot(canvas, {kMargin, kMargin, kWidth - kMargin, kHeight - kMargin}, plot);
    canvas.Write();
    std::cout << command.output << '\n';
    return kExitOk;
}

} // namespace testbed
