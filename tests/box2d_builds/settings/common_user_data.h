// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_COMMON_USER_DATA_H
#define BOX2D_BUILDS_COMMON_USER_DATA_H

#include <stdarg.h>
#include <stdint.h>

#include <box2d/b2_api.h>
#include <box2d/b2_types.h>

/// @file
/// What a game's b2_user_settings.h must define and what is the same in all of ours: as in Box2D's own
/// b2_settings.h.

struct B2_API b2BodyUserData {
    uintptr_t pointer = 0;
};
struct B2_API b2FixtureUserData {
    uintptr_t pointer = 0;
};
struct B2_API b2JointUserData {
    uintptr_t pointer = 0;
};

#define b2_maxPolygonVertices 8

B2_API void *b2Alloc_Default(int32 size);
B2_API void b2Free_Default(void *memory);
B2_API void b2Log_Default(const char *string, va_list arguments);

inline void b2Log(const char *string, ...) {
    va_list arguments;
    va_start(arguments, string);
    b2Log_Default(string, arguments);
    va_end(arguments);
}

#endif
