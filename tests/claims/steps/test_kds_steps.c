// SPDX-License-Identifier: MIT
// The steps that a start or repair reports are what it costs: core is compiled once more with a call at every
// basic block, and the blocks that were run are at most a constant times the steps, for every structure,
// every single repair, and polygons of any size.
#include "checks.h"
#include "driven.h"
#include "motions.h"

/// Blocks for each step reported, at most. Measured: 8 to 42 on average, 141 at most (a rival's walk by one
/// feature, which looks at some ten conditions); other compilers cut blocks otherwise.
#define MOST_BLOCKS 256.0
/// Of the blocks a vertex, from 512 vertices to 32768.
#define MOST_GROWTH 1.2

static uint64_t blocks;

/// Called by the traced core at every basic block.
void __sanitizer_cov_trace_pc(void);
void __sanitizer_cov_trace_pc(void) {
    ++blocks;
}

/// What the repairs of one structure ran and reported.
typedef struct tally {
    double worst;   ///< the most blocks for a step in one start or repair
    double busiest; ///< the most blocks of one, whatever it reports
    double blocks, steps;
    size_t repairs;
} tally;
static tally now_at;

static void note(tally *t, uint64_t before, double steps) {
    const double ran = (double)(blocks - before);
    t->worst = fmax(t->worst, ran / steps);
    t->busiest = fmax(t->busiest, ran);
    t->blocks += ran;
    t->steps += steps;
    ++t->repairs;
}

void __real_bmr_kds_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);
void __wrap_bmr_kds_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);
void __wrap_bmr_kds_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    const uint64_t before = blocks;
    __real_bmr_kds_start(kds, now, report);
    note(&now_at, before, report->touched);
}

void __real_bmr_kds_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report);
void __wrap_bmr_kds_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report);
void __wrap_bmr_kds_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    const uint64_t before = blocks;
    __real_bmr_kds_repair(kds, now, failed, report);
    note(&now_at, before, report->touched);
}

static const size_t sizes[] = {12, 128, 2048};
#define SIZES (sizeof sizes / sizeof *sizes)

static void drive(const bmr_kds_info *info, size_t n, uint64_t seed) {
    test_random random = test_random_from(seed);
    const test_family family = seed % 2 ? TEST_ELLIPSE : TEST_LENS;
    own_kds_body a = test_kds_body_make(test_polygon(family, n, &random));
    own_kds_body b = info->domain == BMR_KDS_POINT
                         ? test_kds_point_make(0.1, 0.2)
                         : test_kds_body_make(test_polygon(TEST_REGULAR, n, &random));
    const test_path_kind kind = info->role == BMR_KDS_RIVAL ? TEST_PATH_LINE
                                : seed % 3                  ? TEST_PATH_WANDER
                                                            : TEST_PATH_ORBIT;
    const bool turns = info->domain == BMR_KDS_RIGID && info->role != BMR_KDS_RIVAL;
    const test_path path = test_path_make(kind, a.polygon, b.polygon, 1e-3, turns, &random);
    const test_drive how = {.path = &path, .audit_every = 100000};
    driven(info->name, &a, &b, &how);
}

TEST(no_repair_runs_more_than_a_constant_for_each_step_that_it_reports) {
    double worst = 0.0, busiest = 0.0;
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        for (size_t k = 0; k < SIZES; ++k) {
            now_at = (tally){0};
            const size_t seeds = test_scaled(2);
            for (size_t seed = 1; seed <= seeds; ++seed)
                drive(bmr_kds_at(i), sizes[k], seed);
            printf("%s, n = %zu: %zu repairs, %.1f steps each, %.1f blocks a step, at most %.1f\n",
                   bmr_kds_at(i)->name, sizes[k], now_at.repairs, now_at.steps / (double)now_at.repairs,
                   now_at.blocks / now_at.steps, now_at.worst);
            assert_true(now_at.repairs > 1);
            assert_true(now_at.steps <= now_at.blocks); // no step without anything done
            worst = fmax(worst, now_at.worst);
            busiest = fmax(busiest, now_at.busiest);
        }
    }
    printf("at most %.1f blocks a step; at most %.0f in a repair\n", worst, busiest);
    assert_true(worst <= MOST_BLOCKS);
    assert_true(busiest > 2.0 * MOST_BLOCKS); // control: that a repair is one step would be found out
}

/// An ellipse and a regular polygon.
static test_pair pair_make(bmr_structure structure, size_t n, size_t m, test_random *random) {
    bmr_polygon *ellipse = test_polygon(TEST_ELLIPSE, n, random);
    return test_pair_make(structure, ellipse, test_polygon(TEST_REGULAR, m, random));
}

static void step_pair(test_motion_kind kind, bmr_structure structure, size_t n, uint64_t seed, tally *t) {
    test_random random = test_random_from(seed);
    own_pair c = pair_make(structure, n, n, &random);
    test_motion motion = test_motion_make(kind, c.shape[0].polygon, c.shape[1].polygon, &random);
    for (int i = 0; i < 2000; ++i) {
        const bmr_pose q = test_motion_next(&motion, &random);
        c.counters.steps = 0;
        const uint64_t before = blocks;
        test_pair_advance(&c, &q, NULL);
        if (c.counters.steps > 0) // else the old proof held
            note(t, before, (double)c.counters.steps);
    }
}

TEST(no_step_of_a_pair_runs_more_than_a_constant_for_each_that_it_counts) {
    for (int s = 0; s < BMR_STRUCTURE_COUNT; ++s) {
        tally t = {0};
        for (size_t k = 0; k < SIZES; ++k)
            for (int kind = 0; kind < TEST_MOTION_KIND_COUNT; ++kind)
                step_pair((test_motion_kind)kind, (bmr_structure)s, sizes[k], 1 + k, &t);
        printf("%s: %zu repairs, %.1f steps each, %.1f blocks a step, at most %.1f\n",
               bmr_structure_name((bmr_structure)s), t.repairs, t.steps / (double)t.repairs,
               t.blocks / t.steps, t.worst);
        assert_true(t.repairs > 1000);
        assert_true(t.steps <= t.blocks);
        assert_true(t.worst <= MOST_BLOCKS);
        assert_true(t.busiest > MOST_BLOCKS); // control: that a repair is one step would be found out
    }
}

/// Mean steps of a repair in which a pair, nearly touching, jumps to a place where it gains three levels or
/// more.
static double steps_of_coarsening(bmr_structure structure, size_t n, size_t m) {
    double steps = 0.0;
    size_t repairs = 0;
    for (uint64_t seed = 1; seed <= 10; ++seed) {
        test_random random = test_random_from(seed);
        own_pair c = pair_make(structure, n, m, &random);
        const bmr_polygon *a = c.shape[0].polygon, *b = c.shape[1].polygon;
        const double direction = test_random_uniform(&random, 0.0, 6.28),
                     angle = test_random_uniform(&random, 0.0, 6.28);
        for (int k = 0; k < 30; ++k) {
            const bmr_pose near = test_pose_at(a, b, direction, angle, 1e-5),
                           far = test_pose_at(a, b, direction + 0.05 + 0.1 * k, angle, 0.2);
            bmr_pair_init(&c.pair);
            test_pair_advance(&c, &near, NULL);
            c.counters = (bmr_counters){0};
            test_pair_advance(&c, &far, NULL);
            if (c.counters.events[BMR_EVENT_COARSEN] < 3)
                continue;
            steps += (double)c.counters.steps;
            ++repairs;
        }
    }
    assert_true(repairs > 50);
    return steps / (double)repairs;
}

/// Between two neighbouring edges of a 5-gon lie any number of an 8192-gon's. A pair that climbed to the best
/// line of each level on its way up passed them all: 544 steps a repair. It takes the first line that is good
/// enough, and 357 steps: what the way down costs, and one climb.
TEST(a_coarsening_pair_does_not_climb_to_the_best_line_of_each_level) {
    const double steps = steps_of_coarsening(BMR_LAZY_COMPASS, 5, 8192);
    printf("a 5-gon and an 8192-gon: %.1f steps a coarsening\n", steps);
    assert_true(steps <= 450.0);
}

/// Blocks that `build` takes for each vertex of polygons of n vertices.
static double blocks_a_vertex(test_family family, size_t n, bmr_hierarchy_kind kind,
                              const bmr_compass *compass) {
    test_random random = test_random_from(n);
    own_polygon *polygon = test_polygon(family, n, &random);
    assert_non_null(polygon);
    own_hierarchy *made = NULL;
    const uint64_t before = blocks;
    assert_int_equal(bmr_hierarchy_build(kind, polygon, compass, NULL, &made), BMR_OK);
    const double each = (double)(blocks - before) / polygon->count;
    return each;
}

/// The same of a search by halves for each vertex.
static double blocks_a_search(size_t n) {
    test_random random = test_random_from(n);
    own_polygon *polygon = test_polygon(TEST_REGULAR, n, &random);
    const uint64_t before = blocks;
    for (uint32_t i = 0; i < polygon->count; ++i)
        bmr_polygon_support(polygon, bmr_polygon_normal(polygon, i));
    const double each = (double)(blocks - before) / polygon->count;
    return each;
}

/// O(n) preprocessing: a vertex costs no more in a large polygon than in a small one. From 512 vertices to
/// 32768 the logarithm grows by two thirds.
TEST(a_hierarchy_is_built_in_linear_time) {
    const test_family families[] = {TEST_CIRCLE, TEST_ELLIPSE, TEST_LENS};
    const size_t small = 512, large = 32768;
    own_compass *compass = NULL;
    assert_int_equal(bmr_compass_create(large, NULL, &compass), BMR_OK);
    for (size_t f = 0; f < sizeof families / sizeof *families; ++f)
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            const double few = blocks_a_vertex(families[f], small, (bmr_hierarchy_kind)kind, compass),
                         many = blocks_a_vertex(families[f], large, (bmr_hierarchy_kind)kind, compass);
            printf("%s, hierarchy %d: %.1f blocks a vertex of %zu, %.1f of %zu\n",
                   test_family_name(families[f]), kind, few, small, many, large);
            assert_true(many <= MOST_GROWTH * few);
        }
    assert_true(blocks_a_search(large) > MOST_GROWTH * blocks_a_search(small)); // control: n log n
}
