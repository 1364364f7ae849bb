// SPDX-License-Identifier: MIT
#ifndef AS_STOCK_ACTOR_POISON_H
#define AS_STOCK_ACTOR_POISON_H

namespace actor {

/// The block that was last given back to Box2D's allocator and is still free, or nullptr.
const void *LastFreed();

} // namespace actor

#endif
