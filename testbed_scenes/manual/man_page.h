// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_MAN_PAGE_H
#define BOOMERANG_TESTBED_MAN_PAGE_H

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "manual/description.h"

namespace testbed {

/// What a manual page has that --help has not.
struct ManPage {
    std::string version, date;
    std::string brief; ///< for the line under NAME
    /// Headings and their paragraphs, after the commands; a paragraph "NAME\tTEXT" is an entry of a list.
    std::vector<std::pair<std::string, std::vector<std::string>>> sections;
};

/// The page in man(7)'s macros.
void WriteManPage(std::ostream &out, const CommandDescription &program, const ManPage &page);

} // namespace testbed

#endif
