// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_MEMORY_H
#define BOOMERANG_GLUE_MEMORY_H

#include <cstddef>

namespace bmr {

/// The passes' memory: realloc, which for big blocks moves pages and no bytes. Without memory it ends the
/// program with a sentence, as Box2D ends in its own allocations. Freed by std::free.
void *TakeMemory(void *block, std::size_t bytes);

} // namespace bmr

#endif
