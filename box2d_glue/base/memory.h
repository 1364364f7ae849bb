// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_MEMORY_H
#define BOOMERANG_GLUE_MEMORY_H

#include <cstddef>

namespace bmr {

/// The glue's own memory: realloc, which for big blocks moves pages and no bytes. Without memory it ends the
/// program with a sentence, as Box2D ends in its own allocations. Freed by std::free. (Shapes, outlines and
/// the recorder answer with an error instead.)
void *TakeMemory(void *block, std::size_t bytes);
[[noreturn]] void EndWithoutMemory();

} // namespace bmr

#endif
