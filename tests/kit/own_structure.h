// SPDX-License-Identifier: MIT
#ifndef TEST_OWN_STRUCTURE_H
#define TEST_OWN_STRUCTURE_H

#include "boomerang/kds.h"

#ifdef __cplusplus
extern "C" {
#endif

/// That of core/examples/own_structure.c.
const bmr_kds_info *test_own_structure(void);

#ifdef __cplusplus
}
#endif
#endif
