// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_BAD_INPUT_TABLE_H
#define BOOMERANG_TEST_BAD_INPUT_TABLE_H

#include <functional>
#include <string>
#include <vector>

/// @file
/// The tables of docs/bad-input.md as tests: what a program finds for each cell must be what the page says.

namespace bad_input {

/// One table of the page: the one behind the comment "checked: NAME".
struct Table {
    std::string name;
    std::vector<std::string> columns; ///< heads of all columns but the first
    std::vector<std::string> rows;    ///< what stands in the first column
    /// What happens in one cell. It runs in a process of its own: where that ends by a signal, the signal is
    /// the cell.
    std::function<std::string(size_t row, size_t column)> answer;
    /// Whether it does: no where answers come from programs of their own.
    bool alone = true;
};

/// The main function of a program that answers for these tables:
///
///   PROGRAM check PAGE [CASE]   every cell, or one; a case is called "table / row / column"
///   PROGRAM list                the cases
///   PROGRAM print               the tables, as the page should have them
int Main(int argc, char **argv, const std::vector<Table> &tables);

} // namespace bad_input

#endif
