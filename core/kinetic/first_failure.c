// SPDX-License-Identifier: MIT
#include "kinetic/first_failure.h"

#include <float.h>
#include <math.h>

/// A condition that is still positive where it was to fail is followed for so many doublings of the
/// tolerance: 2^10 tolerances is more than the rounding of any value lasts.
#define NUDGES 10

bmr_error bmr_first_failure(const bmr_condition *conditions, size_t count, const bmr_motion *a,
                            const bmr_motion *b, double from, double to, const bmr_failure_options *options,
                            double *time, size_t *failing) {
    double first = INFINITY;
    for (size_t i = 0; i < count && first > from; i++) {
        double failure;
        const bmr_error error =
            bmr_failure_time(&conditions[i], a, b, from, fmin(to, first), options, &failure);
        if (error != BMR_OK)
            return error;
        if (failure < first) {
            first = failure;
            *failing = i;
        }
    }
    *time = first;
    return BMR_OK;
}

double bmr_repair_time(const bmr_pair_motion *motion, const bmr_condition *condition, double time,
                       double tolerance, double longest) {
    double later = time, step = fmax(tolerance, DBL_EPSILON * fabs(time));
    for (int i = 0; i <= NUDGES; i++, step *= 2.0) {
        const bmr_pose pose = bmr_pair_instant(motion, later).pose;
        if (!(bmr_condition_value(condition, &pose) > 0.0))
            return later;
        if (i > 0 && step > longest)
            break;
        later = time + step;
    }
    return later;
}
