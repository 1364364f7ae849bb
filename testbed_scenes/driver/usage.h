// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_USAGE_H
#define BOOMERANG_TESTBED_USAGE_H

#include <string>

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace testbed {

/// What is wrong with the word that should be a command, if it is none; else empty. (CLI11 alone would only
/// miss one.)
std::string ExplainCommand(const CLI::App &app, int argc, char **argv);

/// What is wrong with a command line that CLI11 would not take, in words like those of our own errors: which
/// command, which option, what it takes, and the nearest name where one is near.
std::string ExplainUsage(const CLI::App &app, const CLI::ParseError &error, int argc, char **argv);

/// For options that are seeds (CLI11 reads -1 as the largest number there is): what is wrong, or nothing.
std::string CheckSeed(const std::string &text);

} // namespace testbed

#endif
