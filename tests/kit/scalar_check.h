// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_SCALAR_CHECK_H
#define BMR_TEST_SCALAR_CHECK_H

#include "boomerang/certificate.h"

/// bmr_certificate_check_pair as it is on machines without SSE2.
bmr_check test_scalar_check_pair(const bmr_certificate *certificate, const bmr_pose *b_in_a, int owner,
                                 double margin, double *gap);

#endif
