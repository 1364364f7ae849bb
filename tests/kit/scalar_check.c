// SPDX-License-Identifier: MIT
// The header chooses by this macro, file by file.
#undef __SSE2__
#include "boomerang/certificate.h"

bmr_check test_scalar_check_pair(const bmr_certificate *certificate, const bmr_pose *b_in_a, int owner,
                                 double margin, double *gap);

bmr_check test_scalar_check_pair(const bmr_certificate *certificate, const bmr_pose *b_in_a, int owner,
                                 double margin, double *gap) {
    return bmr_certificate_check_pair(certificate, b_in_a, owner, margin, gap);
}
