// SPDX-License-Identifier: MIT
#include "drawing/series_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace testbed {
namespace {

/// The three fields of a line, split at its last two commas.
std::array<std::string, 3> Split(const std::string &line) {
    const size_t last = line.rfind(',');
    const size_t first = last == 0 || last == std::string::npos ? last : line.rfind(',', last - 1);
    if (first == std::string::npos || first == last)
        throw SeriesFileError("not a line of series,x,y: " + line);
    return {line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)};
}

double ReadNumber(const std::string &text, const std::string &line) {
    std::istringstream stream(text);
    double number = 0.0;
    if (!(stream >> number) || !stream.eof() || !std::isfinite(number))
        throw SeriesFileError("not a line of series,x,y: " + line);
    return number;
}

} // namespace

SeriesFile ReadSeriesFile(const std::string &path) {
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line))
        throw SeriesFileError("cannot read " + path + ", or it is empty");
    SeriesFile read;
    const std::array<std::string, 3> headings = Split(line);
    read.xHeading = headings[1];
    read.yHeading = headings[2];
    while (std::getline(file, line)) {
        const std::array<std::string, 3> fields = Split(line);
        auto found = std::find_if(read.series.begin(), read.series.end(),
                                  [&fields](const PlotSeries &series) { return series.name == fields[0]; });
        if (found == read.series.end())
            found = read.series.insert(read.series.end(), {fields[0], {}, ink::Series(read.series.size())});
        found->points.push_back({ReadNumber(fields[1], line), ReadNumber(fields[2], line)});
    }
    return read;
}

} // namespace testbed
