// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_STRUCTURE_NAMED_H
#define BMR_TEST_STRUCTURE_NAMED_H

#include <stdio.h>
#include <stdlib.h>

#include "boomerang/kds.h"

/// The structure of a name. A test that misspells it ends with core's own sentence.
static inline const bmr_kds_info *test_structure(const char *name) {
    const bmr_kds_info *info = NULL;
    if (bmr_kds_find(name, &info) != BMR_OK) {
        char text[1024];
        bmr_kds_describe_unknown(name, text, sizeof text);
        fprintf(stderr, "%s\n", text);
        abort();
    }
    return info;
}

#endif
