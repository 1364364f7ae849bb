// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_NUMBER_TEXT_H
#define BOOMERANG_TESTBED_NUMBER_TEXT_H

#include <optional>
#include <string>

namespace testbed {

/// A number with so many decimals, "-" for none.
std::string Fixed(std::optional<double> number, int decimals);

} // namespace testbed

#endif
