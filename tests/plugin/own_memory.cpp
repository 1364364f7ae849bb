// SPDX-License-Identifier: MIT
// The memory of a game that takes two of Box2D's functions for its own, and so has one b2Alloc_Default and
// Box2D's library another.
#include <cstdlib>

#include <box2d/b2_settings.h>

void *b2Alloc_Default(int32 size) {
    return std::malloc(static_cast<std::size_t>(size));
}

void b2Free_Default(void *memory) {
    std::free(memory);
}
