// SPDX-License-Identifier: MIT
// The same for processors without SSE2's lanes: the code that is compiled there, on this one.
#include <box2d/b2_dynamic_tree.h>

#undef __SSE2__
#include "test_glue_tree_updates.cpp" // NOLINT(bugprone-suspicious-include): the tests are the same
