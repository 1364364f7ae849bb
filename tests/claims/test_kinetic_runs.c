// SPDX-License-Identifier: MIT
// Whole runs: every structure on every family of motion, audited; saturation at mu = n; lines that the online
// structures use over those of the offline optimum, on the twelve families of motion: the figures of
// docs/open-question.md. (BMR_TEST_SCALE=5 takes its ten seeds.)
#include "checks.h"
#include "course_stage.h"
#include "kds/registry.h"
#include "kds_driver.h"

// The example structure of CONTRIBUTING.md: what is copied from a page must stand all motions, too.
#define main own_structure_main
int own_structure_main(void);
#include "examples/own_structure.c" // NOLINT(bugprone-suspicious-include)
#undef main

static stage set(bmr_family family, double ratio, size_t n, uint64_t seed) {
    return stage_of(ngon(BMR_NGON_ELLIPSE, n, seed), ngon(BMR_NGON_DISC, n, seed + 1),
                    (bmr_family_def){family, ratio, seed, 0, 0});
}

static bool takes(const bmr_kds_info *structure, bmr_family family) {
    return structure->domain == BMR_KDS_RIGID ||
           (structure->domain == BMR_KDS_TRANSLATION && !bmr_family_is_rigid(family));
}

TEST(test_every_structure_is_right_on_every_family) {
    const size_t seeds = test_scaled(1);
    for (int family = 0; family < BMR_FAMILY_COUNT; family++)
        for (uint64_t seed = 1; seed <= seeds; seed++) {
            own_stage s = set((bmr_family)family, 40.0, 20, seed);
            for (size_t k = 0; k <= bmr_kds_count(); k++) {
                const bmr_kds_info *structure = k < bmr_kds_count() ? bmr_kds_at(k) : &own_structure;
                if (!takes(structure, (bmr_family)family))
                    continue;
                const bmr_run r = plain_run_of(&s, structure);
                assert_int_equal(r.counts.external, 0); // the separation is never less than sigma
                assert_true(r.lines <= r.events);
                assert_int_equal(r.hysteresis.intervals, r.events);
                assert_true(r.qualities.conditions >= 1 && r.qualities.conditions <= BMR_KDS_MAX_CONDITIONS);
                assert_true(r.qualities.replanned <= r.qualities.conditions);
                assert_true(r.qualities.bytes > 0.0 && r.qualities.efficiency == (double)r.events);
            }
        }
}

static bmr_polygon *scaled(bmr_ngon kind, size_t n, double scale) {
    own_polygon *polygon = ngon(kind, n, 1);
    bmr_vec2 points[20];
    for (uint32_t i = 0; i < polygon->count; i++)
        points[i] = bmr_scale(scale, polygon->vertices[i]);
    return made_polygon(points, polygon->count);
}

static void add_time(void *context, const bmr_simulation_event *event) {
    *(double *)context += event->time;
}

/// *times: the sum of its events'.
static bmr_run run_at_scale(const bmr_kds_info *structure, bmr_family family, bool is_point, double scale,
                            double *times) {
    static const bmr_vec2 point = {0.0, 0.0};
    bmr_polygon *b = is_point ? made_polygon(&point, 1) : scaled(BMR_NGON_DISC, 20, scale);
    own_stage s = stage_of(scaled(BMR_NGON_ELLIPSE, 20, scale), b, (bmr_family_def){family, 40.0, 1, 0, 0});
    bmr_run_def def = {.simulation = bmr_default_simulation_def(), .observer = add_time, .context = times};
    def.simulation.kds.margin *= scale;
    def.simulation.kds.hysteresis *= scale;
    return run_of(&s, structure, def);
}

/// A power of 2 loses no digit: where each length is as many times as large, the same happens.
TEST(a_thousand_times_larger_all_is_the_same) {
    size_t runs = 0;
    for (int family = 0; family < BMR_FAMILY_COUNT; family++)
        for (size_t k = 0; k <= bmr_kds_count(); k++) {
            const bmr_kds_info *structure = k < bmr_kds_count() ? bmr_kds_at(k) : &own_structure;
            const bool is_point = structure->domain == BMR_KDS_POINT;
            if (bmr_family_is_rigid((bmr_family)family) && structure->domain != BMR_KDS_RIGID)
                continue;
            double times[2] = {0.0, 0.0};
            const bmr_run small = run_at_scale(structure, (bmr_family)family, is_point, 1.0, &times[0]),
                          large = run_at_scale(structure, (bmr_family)family, is_point, 0x1p10, &times[1]);
            assert_int_equal(large.events, small.events);
            assert_int_equal(large.lines, small.lines);
            assert_int_equal(large.counts.touched, small.counts.touched);
            assert_int_equal(large.counts.failure_times, small.counts.failure_times);
            assert_true(times[1] == times[0]);
            runs += small.events > 0;
        }
    assert_true(runs > 200);
}

static double orbit_events(const char *name, size_t n, double ratio) {
    own_stage s = set(BMR_FAMILY_ORBIT, ratio, n, 2);
    return (double)plain_run_of(&s, test_structure(name)).events;
}

/// mu = min{n, sqrt(D / sigma)}: events grow with the square root until it reaches n, and then no more.
TEST(test_orbits_saturate_when_mu_reaches_n) {
    static const char *const names[] = {"lazy-dudley", "hybrid", "two-lines"};
    for (size_t k = 0; k < 3; k++) {
        const double few_far = orbit_events(names[k], 12, 1e3), few_near = orbit_events(names[k], 12, 1e5);
        const double many_far = orbit_events(names[k], 512, 1e3),
                     many_near = orbit_events(names[k], 512, 3e4);
        printf("%s: n = 12: %g then %g; n = 512: %g then %g\n", names[k], few_far, few_near, many_far,
               many_near);
        assert_true(few_near <= 1.5 * few_far + 2.0);
        assert_true(many_near >= 3.0 * many_far); // sqrt(30) = 5.5
    }
}

#define VERTICES 64
#define RATIO 128.0
#define SEEDS 2
/// Of the optimum's cones (bmr_offline_optimum).
#define RESOLUTION 0.02

static const bmr_kds_info *const structures[] = {&bmr_kds_free_fd2, &bmr_kds_predict_adaptive};
#define STRUCTURES (sizeof structures / sizeof *structures)

/// Adds the lines that the optimum and the structures use on one motion, the first ones counted.
static void count_lines(bmr_family family, uint64_t seed, double *optimum, double lines[STRUCTURES]) {
    own_stage s = stage_of(ngon(BMR_NGON_ELLIPSE, VERTICES, seed), ngon(BMR_NGON_DISC, VERTICES, seed),
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
