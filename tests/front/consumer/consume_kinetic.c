// SPDX-License-Identifier: MIT
#include <stdio.h>

#include <boomerang/kinetic.h>

int main(void) {
    bmr_simulation_def def = bmr_default_simulation_def();
    const bmr_error error = bmr_kds_find("lazy-dudley", &def.structure);
    const bmr_motion_piece piece = bmr_piece_rest(bmr_pose_identity());
    bmr_motion *motion = NULL;
    const bmr_error made = bmr_motion_create(&piece, NULL, &motion);
    printf("%s, %s\n", bmr_error_describe(error), bmr_error_describe(made));
    bmr_motion_destroy(motion);
    return error == BMR_OK && made == BMR_OK ? 0 : 1;
}
