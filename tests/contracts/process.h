// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_PROCESS_H
#define BOOMERANG_TEST_CONTRACTS_PROCESS_H

#include <string>
#include <vector>

namespace contracts {

/// What a program printed, and how it ended.
struct Ended {
    std::string output, errors;
    int status = 0; ///< of exit
    int signal = 0; ///< that ended it; 0: none
};

/// Runs a program to its end, at most two minutes; `environment` are settings "NAME=VALUE" in front of ours.
Ended RunProgram(const std::vector<std::string> &command, const std::vector<std::string> &environment = {});

} // namespace contracts

#endif
