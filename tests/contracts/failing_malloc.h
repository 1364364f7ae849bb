// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_CONTRACTS_FAILING_MALLOC_H
#define BOOMERANG_TEST_CONTRACTS_FAILING_MALLOC_H

#include <cstdint>

/// @file
/// Memory that fails for the code it is linked with.

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
