// SPDX-License-Identifier: MIT
#include "drawing/series_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace testbed {
namespace {

/// A line of a file, and where it stands.
struct Line {
    const std::string &path;
    int number = 0;
    std::string text;

    [[noreturn]] void Fail(const std::string &what) const {
        throw SeriesFileError(path + ", line " + std::to_string(number) + ": " + what + ": " + text);
    }
};

/// The three fields of a line, split at its last two commas.
std::array<std::string, 3> Split(const Line &whole) {
    const std::string &line = whole.text;
    const size_t last = line.rfind(',');
    const size_t first = last == 0 || last == std::string::npos ? last : line.rfind(',', last - 1);
    if (first == std::string::npos || first == last)
        whole.Fail("not a line of series,x,y");
    return {line.substr(0, first), line.substr(first + 1, last - first - 1), line.substr(last + 1)};
}

double ReadNumber(const std::string &text, const char *name, const Line &line) {
    std::istringstream stream(text);
    double number = 0.0;
    if (!(stream >> number) || !stream.eof() || !std::isfinite(number))
        line.Fail("not a line of series,x,y");
    if (!(number > 0.0))
        line.Fail(std::string(name) + " = " + text + " has no place on a logarithmic axis");
    return number;
}

} // namespace

SeriesFile ReadSeriesFile(const std::string &path) {
    std::ifstream file(path);
    Line line = {path, 1, ""};
    if (!std::getline(file, line.text))
        throw SeriesFileError("cannot read " + path + ", or it is empty");
    SeriesFile read;
    const std::array<std::string, 3> headings = Split(line);
    read.xHeading = headings[1];
    read.yHeading = headings[2];
    for (++line.number; std::getline(file, line.text); ++line.number) {
        const std::array<std::string, 3> fields = Split(line);
        auto found = std::find_if(read.series.begin(), read.series.end(),
                                  [&fields](const PlotSeries &series) { return series.name == fields[0]; });
        if (found == read.series.end())
            found = read.series.insert(read.series.end(), {fields[0], {}, ink::Series(read.series.size())});
        found->points.push_back({ReadNumber(fields[1], "x", line), ReadNumber(fields[2], "y", line)});
    }
    return read;
}

} // namespace testbed
