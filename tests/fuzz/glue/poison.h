// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_FUZZ_GLUE_POISON_H
#define BOOMERANG_FUZZ_GLUE_POISON_H

namespace fuzz {

/// The block that was last given back to Box2D's allocator and is still free, or nullptr.
const void *LastFreed();

} // namespace fuzz

#endif
