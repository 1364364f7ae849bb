// SPDX-License-Identifier: MIT
// A game that measures in decimetres. (Box2D's other lengths, as b2_linearSlop, follow.)
#ifndef B2_USER_SETTINGS_H
#define B2_USER_SETTINGS_H

#include "../common_user_data.h"

#if !defined(b2_lengthUnitsPerMeter)
#    define b2_lengthUnitsPerMeter 10.0f
#endif

inline void *b2Alloc(int32 size) {
    return b2Alloc_Default(size);
}
inline void b2Free(void *memory) {
    b2Free_Default(memory);
}

#endif
