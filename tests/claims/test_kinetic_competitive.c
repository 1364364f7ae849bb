// SPDX-License-Identifier: MIT
// Lines that the online structures use over those of the offline optimum, on the twelve families of motion:
// the figures of docs/open-question.md. BMR_TEST_SCALE=5 takes its ten seeds.
#include "checks.h"
#include "course_stage.h"
#include "kds/registry.h"
#include "kds_driver.h"
#include "test_scale.h"

#define VERTICES 64
#define RATIO 128.0
#define SEEDS 2
/// Of the optimum's cones (bmr_offline_optimum).
#define RESOLUTION 0.02

static const bmr_kds_info *const structures[] = {&bmr_kds_free_fd2, &bmr_kds_predict_adaptive};
#define STRUCTURES (sizeof structures / sizeof *structures)

/// Adds the lines that the optimum and the structures use on one motion, the first ones counted.
static void count_lines(bmr_family family, uint64_t seed, double *optimum, double lines[STRUCTURES]) {
    own_stage s =
        stage_of(outline(BMR_OUTLINE_ELLIPSE, VERTICES, seed), outline(BMR_OUTLINE_DISC, VERTICES, seed),
                 (bmr_family_def){family, RATIO, seed, 0, 0});
    bmr_optimum best;
    assert_int_equal(bmr_offline_optimum(&s.course, bmr_default_kds_def().margin, RESOLUTION, NULL, 0, &best),
                     BMR_OK);
    *optimum += (double)best.least;
    for (size_t k = 0; k < STRUCTURES; ++k) {
        const bmr_run run = plain_run_of(&s, structures[k]);
        assert_int_equal(run.counts.external, 0);
        lines[k] += (double)(1 + run.lines);
    }
}

TEST(the_best_needs_at_most_twice_the_lines_of_the_optimum) {
    double mean[STRUCTURES] = {0.0};
    const size_t seeds = test_scaled(SEEDS);
    for (int family = 0; family < BMR_FAMILY_COUNT; ++family) {
        double optimum = 0.0, lines[STRUCTURES] = {0.0};
        for (uint64_t seed = 1; seed <= seeds; ++seed)
            count_lines((bmr_family)family, seed, &optimum, lines);
        printf("%-16s %6.1f", bmr_family_name((bmr_family)family), optimum / (double)seeds);
        for (size_t k = 0; k < STRUCTURES; ++k) {
            printf(" %6.1f", lines[k] / (double)seeds);
            assert_true(lines[k] >= optimum); // nothing beats the optimum: the control of both counts
            mean[k] += log(lines[k] / optimum) / BMR_FAMILY_COUNT;
        }
        printf("\n");
    }
    for (size_t k = 0; k < STRUCTURES; ++k)
        printf("%s %.3f\n", structures[k]->name, exp(mean[k]));
    assert_true(exp(mean[STRUCTURES - 1]) <= 2.0);
    assert_true(exp(mean[0]) > 3.0); // the closest direction, measured: 4.2
}
