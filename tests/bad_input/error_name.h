// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BAD_INPUT_ERROR_NAME_H
#define BOOMERANG_TEST_BAD_INPUT_ERROR_NAME_H

#include <string>

#include "boomerang/error.h"

namespace bad_input {

/// The code as the page writes it: without BMR_ and ERROR_.
inline std::string NameOf(bmr_error error) {
    static const char *const names[] = {"OK",
                                        "NULL_ARGUMENT",
                                        "NO_POINTS",
                                        "TOO_MANY_POINTS",
                                        "NOT_FINITE",
                                        "OUT_OF_RANGE",
                                        "NO_MEMORY",
                                        "NOT_CONVEX",
                                        "TABLE_TOO_SMALL",
                                        "INVALID_STRUCTURE",
                                        "FALSE_CERTIFICATE",
                                        "STALLED",
                                        "UNSUPPORTED",
                                        "TOO_FEW_POINTS",
                                        "TOO_CLOSE",
                                        "NEGATIVE",
                                        "CORNER_TOO_LARGE",
                                        "TOO_LARGE",
                                        "WRONG_HIERARCHY",
                                        "UNKNOWN_NAME",
                                        "REPEATED_POINT",
                                        "CROSSING_EDGES",
                                        "OVERLAPPING_EDGES",
                                        "HOLE_OUTSIDE",
                                        "WORLD_LOCKED",
                                        "FAR_FROM_ORIGIN"};
    static_assert(sizeof names / sizeof *names == BMR_ERROR_COUNT, "one name for each code");
    return error >= BMR_OK && error < BMR_ERROR_COUNT ? names[error] : "no code at all";
}

} // namespace bad_input

#endif
