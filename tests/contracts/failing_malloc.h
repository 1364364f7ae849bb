// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_FAILING_MALLOC_H
#define BOOMERANG_TEST_CONTRACTS_FAILING_MALLOC_H

#include <cstdint>

/// @file
/// Memory that fails for the code it is linked with. By the environment, or by these where the test is in the
/// same program:
///
///   BOOMERANG_TEST_FAIL_AT=N     allocation N, counted from 0, fails
///   BOOMERANG_TEST_FAIL_FROM=N   that one and all after it
///   BOOMERANG_TEST_REPORT=1      at the end a line on stderr: how many were asked for, failed, and are still
///   out

namespace failing_malloc {

/// Allocation `number` from now on fails; UINT64_MAX: none.
void FailAt(uint64_t number);
/// Since then.
uint64_t Asked();
uint64_t Failed();
/// Blocks that are out now.
int64_t Out();

} // namespace failing_malloc

#endif
