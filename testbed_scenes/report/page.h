// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPORT_PAGE_H
#define BOOMERANG_TESTBED_REPORT_PAGE_H

#include <ostream>
#include <string>
#include <vector>

#include "report/numbers.h"
#include "report/pictures.h"

namespace testbed {

struct ReportPage {
    std::string title = "Boomerang: measured";
    std::string made; ///< by what and when: the last line
};

/// All pictures of a report, in the order of the page.
std::vector<Picture> AllPictures(const Numbers &numbers);

/// One HTML page with the tables and plots of these numbers: style and pictures are in it, it asks no
/// network, runs no script, is dark where the reader likes it dark, and prints on A4.
void WritePage(std::ostream &out, const Numbers &numbers, const ReportPage &page);

/// The style sheet of the page.
extern const char *const kReportStyle;

} // namespace testbed

#endif
