// SPDX-License-Identifier: MIT
// The same for processors without lanes: the code that is compiled there, on this one.
#include <box2d/b2_dynamic_tree.h>

#define BMR_FLOAT4_PLAIN
#include "test_glue_tree.cpp" // NOLINT(bugprone-suspicious-include): the tests are the same
