// SPDX-License-Identifier: MIT
// The example structure, for the test that goes through all of the library's: what is copied from a page must
// stand random motions, too.
#define main own_structure_main
int own_structure_main(void);
#include "examples/own_structure.c"

const bmr_kds_info *test_own_structure(void);

const bmr_kds_info *test_own_structure(void) {
    return &own_structure;
}
