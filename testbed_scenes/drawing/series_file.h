// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SERIES_FILE_H
#define BOOMERANG_TESTBED_SERIES_FILE_H

#include <stdexcept>
#include <string>
#include <vector>

#include "drawing/plot.h"

namespace testbed {

class SeriesFileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Measured numbers: a line of headings, then series,x,y; a series' name may have commas in it.
struct SeriesFile {
    std::string xHeading, yHeading; ///< "x" and "y" where the file leaves open what they are
    std::vector<PlotSeries> series; ///< in the order of their first lines, with colours
};

/// For logarithmic axes. Throws SeriesFileError, with the file and the line, on a line that is none of
/// series,x,y, and on one whose x or y is not above 0: such an axis has no place for it.
SeriesFile ReadSeriesFile(const std::string &path);

} // namespace testbed

#endif
