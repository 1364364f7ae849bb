// SPDX-License-Identifier: MIT
// Included ahead of every source of the shared library: its references to Box2D are weak. With another
// libbox2d than the one it was built for it must load all the same, look at what is there, and stay out of
// the way; a reference that is not weak would end the program before its first line. (Not for the static
// glue: weak references draw nothing out of an archive.)
#ifndef BOOMERANG_INTERPOSED_WEAK_BOX2D_H
#define BOOMERANG_INTERPOSED_WEAK_BOX2D_H

#define BMR_SHARED_LIBRARY

#define BMR_FUNCTION(name) __asm__(".weak " #name);
#define BMR_DATA(name, bytes) __asm__(".weak " #name);
#define BMR_SIGN(name)
#include "interposed/box2d_symbols.inc"
#include "start/hook_list.h"
#define BMR_WEAK_HOOK(name, function, symbol, heard, result, parameters, renamed) BMR_FUNCTION(symbol)
BMR_HOOKS(BMR_WEAK_HOOK)
#undef BMR_WEAK_HOOK
#undef BMR_FUNCTION
#undef BMR_DATA
#undef BMR_SIGN

#endif
