// SPDX-License-Identifier: MIT
// A game that gives Box2D its memory itself: a header stands before each block, so that neither malloc's free
// takes such a block, nor b2Free one of malloc's. b2Free ends the process at a block that is not its own.
#ifndef B2_USER_SETTINGS_H
#define B2_USER_SETTINGS_H

#include "../common_user_data.h"

#define b2_lengthUnitsPerMeter 1.0f

#define BOX2D_BUILDS_ALLOCATOR

/// Blocks that were handed out so far. Defined by Box2D's library (settings/allocator/allocator.cpp), as the
/// two below are.
extern B2_API unsigned long box2dBlocks;
B2_API void *b2AllocOwn(int32 size);
B2_API void b2FreeOwn(void *memory);

inline void *b2Alloc(int32 size) {
    return b2AllocOwn(size);
}
inline void b2Free(void *memory) {
    b2FreeOwn(memory);
}

#endif
