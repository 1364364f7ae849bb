// SPDX-License-Identifier: MIT
#ifndef BMR_KINETIC_SIMULATION_LAYOUT_H
#define BMR_KINETIC_SIMULATION_LAYOUT_H

#include <stdbool.h>
#include <stddef.h>

/// Where each array of a simulation begins in its one block: bytes from the block's own beginning.
typedef struct bmr_simulation_layout {
    size_t pair_count; ///< bodies * (bodies - 1) / 2
    size_t shapes, motions, pairs, queue;
    size_t bytes; ///< of the whole block
} bmr_simulation_layout;

/// For `bodies` >= 2. False where the block would be larger than `limit` bytes: then *layout is as it was.
/// O(1).
bool bmr_simulation_lay_out(size_t bodies, size_t limit, bmr_simulation_layout *layout);

#endif
