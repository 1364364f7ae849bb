// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BAD_INPUT_ARGUMENTS_H
#define BOOMERANG_TEST_BAD_INPUT_ARGUMENTS_H

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "error_name.h"
#include "table.h"

namespace bad_input {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// One call with one bad argument; the row is "`call`: what is bad about it".
struct Argument {
    std::string row;
    std::function<std::string()> call;
};

inline std::string Said(bmr_error error) {
    return NameOf(error);
}
inline std::string Said(bool answer) {
    return answer ? "true" : "false";
}

/// A value that the answers name where it is not finite.
inline std::string Said(double value) {
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value > 0.0 ? "infinite" : "minus infinity";
    return "finite";
}

/// A table with one column of answers.
inline Table ArgumentTable(const std::string &name, const std::vector<Argument> &arguments) {
    Table table = {name, {"answer"}, {}, {}};
    for (const Argument &argument : arguments)
        table.rows.push_back(argument.row);
    table.answer = [arguments](size_t row, size_t) { return arguments[row].call(); };
    return table;
}

} // namespace bad_input

#endif
