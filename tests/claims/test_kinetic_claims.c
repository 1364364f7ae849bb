// SPDX-License-Identifier: MIT
// Section 6, last paragraph: "Rotational hysteresis implies that the number of events is bounded by the size
// of a kappa-clear decomposition of the path that the polygons traverse through the three-dimensional
// configuration space, for some constant kappa."
#include "checks.h"
#include "course_stage.h"
#include "kds/registry.h"
#include "kds_driver.h"

/// As in test_kinetic_hysteresis.c: no event is near the annulus where nothing is promised.
#define VERTICES 400
#define RATIO 20.0

/// The least (displacement + D rotation) / distance that test_kinetic_hysteresis.c asks for between events.
#define LEAST_RHO 0.2

/// A segment of a decomposition has a diameter of at most 2 / (kappa - 1) of the least distance on it; where
/// that is below rho no two events are in one segment.
static const double kappa = 1.0 + 2.0 / LEAST_RHO;

/// Where a known spin turns back, the short side of a bracket is left after a rotation of gamma g/(16 D),
/// gamma = 0.3 (free_direction.c): what is proved of all motions.
static const double kappa_back = 1.0 + 2.0 * 16.0 / 0.3;

/// Two polygons of few vertices, and so near that these are what bounds the events.
#define FEW 16
#define NEAR 1e4
#define NEARER 1e6
#define FEW_SEEDS 6

static stage played(const bmr_outline outlines[2], size_t n, bmr_family family, double ratio, uint64_t seed) {
    return stage_of(outline(outlines[0], n, seed), outline(outlines[1], n, seed + 1),
                    (bmr_family_def){family, ratio, seed, 64, 0});
}

static stage set(bmr_family family, uint64_t seed) {
    static const bmr_outline outlines[2] = {BMR_OUTLINE_ELLIPSE, BMR_OUTLINE_DISC};
    return played(outlines, VERTICES, family, RATIO, seed);
}

static uint64_t events(const stage *s, const bmr_kds_info *structure) {
    bmr_run_def def = {.simulation = bmr_default_simulation_def()};
    def.simulation.kds.margin = 1e-9; // far below all gaps here
    return run_of(s, structure, def).events;
}

/// Section 6, rotational hysteresis: after an event P moves Omega(d) or turns by Omega(d/D).
TEST(events_of_rigid_motions_are_no_more_than_a_clear_decomposition) {
    static const bmr_family families[] = {BMR_FAMILY_SPIN, BMR_FAMILY_RIGID_ALGEBRAIC, BMR_FAMILY_TUMBLE,
                                          BMR_FAMILY_RIGID_WANDER};
    const bmr_kds_info *const structures[] = {&bmr_kds_inflated_window, &bmr_kds_free_fd2, &bmr_kds_hybrid,
                                              &bmr_kds_two_lines};
    bool beyond = false;
    for (size_t f = 0; f < sizeof families / sizeof *families; ++f) {
        own_stage s = set(families[f], 13 + f);
        bmr_clear clear;
        assert_int_equal(bmr_clear_decomposition(&s.course, kappa, s.motion.diameter, &clear), BMR_OK);
        for (size_t k = 0; k < sizeof structures / sizeof *structures; ++k) {
            const uint64_t count = events(&s, structures[k]);
            printf("%s, %s: %d events, %d to %d segments\n", bmr_family_name(families[f]),
                   structures[k]->name, (int)count, (int)clear.least, (int)clear.found);
            assert_true(count > 0 && count <= clear.least);
            assert_true((double)count <= 0.0602 * (double)clear.least); // 24 of 439 was seen, and a tenth
        }
        // The control: the closest features know no such bound.
        beyond = beyond || events(&s, &bmr_kds_closest_features) > clear.found;
    }
    assert_true(beyond);
}

/// A place where turning to and fro is bad for the free direction.
typedef struct swing {
    size_t n;
    double ratio;
    uint64_t seed;
} swing;

/// The free direction leans with the last spin, and fails soon when the body turns back. Two lines do not:
/// the coarse line stands.
TEST(events_of_turning_to_and_fro_are_no_more_than_the_clear_decomposition_that_is_proved) {
    static const bmr_outline outlines[2] = {BMR_OUTLINE_REGULAR, BMR_OUTLINE_REGULAR};
    static const swing swings[] = {{3, 4.0, 28}, {3, 6.0, 28}, {3, 8.0, 28}, {8, 64.0, 39}};
    // The last one's decomposition has 75,000 segments, and takes as long as all the rest.
    const size_t count = COUNT_OF(swings) - (test_scaled(2) < 2 ? 1 : 0);
    const bmr_kds_info *const structures[] = {&bmr_kds_free_fd2, &bmr_kds_hybrid, &bmr_kds_two_lines};
    uint64_t most[3] = {0, 0, 0};
    double nearest = INFINITY;
    for (const swing *at = swings; at < swings + count; ++at) {
        own_stage s =
            stage_of(outline(outlines[0], at->n, 2 * at->seed), outline(outlines[1], at->n, 2 * at->seed + 1),
                     (bmr_family_def){BMR_FAMILY_TO_AND_FRO, at->ratio, at->seed, 0, 0});
        bmr_clear clear;
        assert_int_equal(bmr_clear_decomposition(&s.course, kappa_back, s.motion.diameter, &clear), BMR_OK);
        for (int k = 0; k < 3; ++k) {
            const bmr_run run =
                run_of(&s, structures[k], (bmr_run_def){.simulation = bmr_default_simulation_def()});
            printf("%d vertices, D/sigma %g, %s: %d events, at least %d segments, rho %.3f\n", (int)at->n,
                   at->ratio, structures[k]->name, (int)run.events, (int)clear.least, run.hysteresis.both);
            assert_true(run.events <= clear.least);
            most[k] = run.events > most[k] ? run.events : most[k];
            if (k < 2 && run.events > 1) {
                assert_true(run.hysteresis.both >= 2.0 / (kappa_back - 1.0));
                nearest = fmin(nearest, run.hysteresis.both);
            }
        }
    }
    assert_true(nearest >= 0.119); // 0.132 was seen, less a tenth
    // The control: what holds of a spin that goes on is false here.
    assert_true(nearest < LEAST_RHO);
    assert_true(most[0] > 50 && most[1] > 50 && most[2] <= 1);
}

/// The vertices bound the events of a rigid motion, however near it comes: with a coarse line. The control is
/// the free direction, whose events go on growing. How many more there are a hundred times as near:
TEST(few_vertices_bound_the_events_of_rigid_motions) {
    static const bmr_outline outlines[2] = {BMR_OUTLINE_RANDOM, BMR_OUTLINE_RANDOM};
    const bmr_kds_info *const structures[] = {&bmr_kds_free_fd2, &bmr_kds_hybrid, &bmr_kds_two_lines};
    const bmr_family families[] = {BMR_FAMILY_RIGID_ALGEBRAIC, BMR_FAMILY_SPIN};
    for (int f = 0; f < 2; ++f) {
        double more[3] = {0.0, 0.0, 0.0};
        for (uint64_t seed = 1; seed <= FEW_SEEDS; ++seed)
            for (int nearer = 0; nearer < 2; ++nearer) {
                own_stage s = played(outlines, FEW, families[f], nearer ? NEARER : NEAR, seed);
                for (int k = 0; k < 3; ++k)
                    more[k] += (nearer ? 1.0 : -1.0) * (double)events(&s, structures[k]) / FEW_SEEDS;
            }
        printf("%s: free-fd2 %+.2f, hybrid %+.2f, two-lines %+.2f\n", bmr_family_name(families[f]), more[0],
               more[1], more[2]);
        assert_true(more[0] >= 0.5 && more[1] <= 0.5 * more[0] && more[2] <= 0.5 * more[0]);
    }
}
