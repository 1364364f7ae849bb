// SPDX-License-Identifier: MIT
// The shared library is the glue as it stands; this file makes it a library and pins down what its header
// promises.
#include "boomerang/box2d.h"

static_assert(sizeof(bmr_pair) == 64, "a pair is one cache line");
