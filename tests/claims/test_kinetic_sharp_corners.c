// SPDX-License-Identifier: MIT
// Section 6's tuning remark, beta towards 1 and kappa towards 3, for polygons with sharp corners: it holds
// where the root polygon has edges of length zero there, and fails at every corner without them.
#include "checks.h"
#include "course_stage.h"
#include "kds/registry.h"
#include "motions.h"

/// The tuning: 4 * 2^5 directions at the root, offsets that shrink by 0.95.
#define ROOT_LEVEL 5
#define OFFSET_RATIO 0.95
/// Levels of the table of directions.
#define TABLE_LEVELS 12
/// Within 5 % of the remark's limits.
#define BETA 1.05
#define KAPPA 3.15

/// Polygons whose corners are sharp, and some with none.
typedef enum shape { SQUARE, TRIANGLE, NEEDLE, RANDOM, LENS, ROUND, SHAPES } shape;
static const char *const shape_names[SHAPES] = {"square", "triangle", "needle", "random", "lens", "256-gon"};

static bmr_polygon *polygon_of(shape of, test_random *random) {
    const bmr_vec2 square[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    const bmr_vec2 triangle[] = {{-0.6, -0.3}, {0.7, -0.2}, {0.1, 0.8}};
    switch (of) {
    case SQUARE:
        return made_polygon(square, 4);
    case TRIANGLE:
        return made_polygon(triangle, 3);
    case NEEDLE:
        return test_polygon(TEST_NEEDLE, 24, random);
    case RANDOM:
        return test_polygon(TEST_GRID, 12, random);
    case LENS:
        return test_polygon(TEST_LENS, 64, random);
    default:
        return test_polygon(TEST_REGULAR, 256, random);
    }
}

static bmr_compass *compass;

/// A body whose compass hierarchy cuts vertices on so many levels; 0: on none.
static test_kds_body body_of(shape of, uint32_t corner_levels, test_random *random) {
    test_kds_body body = test_kds_body_make(polygon_of(of, random));
    bmr_hierarchy **h = &body.hierarchies[BMR_HIERARCHY_COMPASS];
    bmr_hierarchy_destroy(*h, NULL);
    assert_int_equal(bmr_hierarchy_build_compass_with_corners(body.polygon, compass, corner_levels, NULL, h),
                     BMR_OK);
    assert_int_equal(bmr_hierarchy_audit(*h), BMR_OK);
    assert_true(bmr_hierarchy_depth(*h) >= corner_levels);
    body.shape.hierarchies[BMR_HIERARCHY_COMPASS] = *h;
    return body;
}

static bmr_kds_def tuned(void) {
    bmr_kds_def def = bmr_default_kds_def();
    def.root_level = ROOT_LEVEL;
    def.offset_ratio = OFFSET_RATIO;
    def.margin = 1e-9;
    return def;
}

/// The least slack over the distance right after a start, all around and from near to far.
static double least_slack(const char *name, shape of, uint32_t corner_levels) {
    test_random random = test_random_from(3);
    own_kds_body a = body_of(of, corner_levels, &random);
    const bmr_kds_info *info = test_structure(name);
    own_kds_body b =
        info->domain == BMR_KDS_POINT ? test_kds_point_make(0.0, 0.0) : body_of(of, corner_levels, &random);
    const bmr_kds_def def = tuned();
    own_kds *kds = made_kds(info, &def, &a.shape, &b.shape);
    double least = INFINITY;
    for (int k = 0; k < 360; ++k)
        for (double d = 0.05; d < 200.0; d *= 1.7) {
            // Away from a vertex along some direction, so that the vertex is the closest point often.
            const bmr_vec2 u = {cos(0.01745 * k), sin(0.01745 * k)};
            const bmr_vec2 from = a.polygon->vertices[bmr_polygon_support(a.polygon, u)];
            const bmr_vec2 to = b.polygon->vertices[bmr_polygon_support(b.polygon, bmr_neg(u))];
            const bmr_instant now = {
                {bmr_sub(bmr_add(from, bmr_scale(d * a.polygon->radius, u)), to), 1.0, 0.0}, {0.0, 0.0}, 0.0};
            bmr_kds_report report;
            bmr_kds_start(kds, &now, &report);
            assert_true(report.apart);
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            const size_t count = bmr_kds_conditions(kds, conditions);
            double slack = INFINITY;
            for (size_t i = 0; i < count; ++i)
                if (conditions[i].kind == BMR_CONDITION_BEYOND)
                    slack = fmin(slack, bmr_condition_value(&conditions[i], &now.pose));
            least = fmin(least, slack / test_distance(a.polygon, b.polygon, &now.pose));
        }
    return least;
}

/// Section 6, tuning: with richer roots and slower offsets beta nears 1 and kappa nears 3.
TEST(the_slack_is_the_distance_over_beta_at_sharp_corners_too) {
    const char *const names[] = {"point-inflated-compass", "point-complex", "inflated-translation",
                                 "inflated-window"};
    for (size_t i = 0; i < COUNT_OF(names); ++i)
        for (int of = 0; of < SHAPES; ++of) {
            const double with = least_slack(names[i], (shape)of, ROOT_LEVEL),
                         without = least_slack(names[i], (shape)of, 0);
            printf("%s, %s: slack / distance at least %.4f, without zero-length edges %.4f\n", names[i],
                   shape_names[of], with, without);
            assert_true(with >= 1.0 / BETA);
            if (of == SQUARE || of == TRIANGLE) // control: whatever the tuning
                assert_true(without < 1.0 / BETA);
        }
}

/// Two polygons alike.
static stage alike(shape of, bmr_family family, uint64_t seed) {
    test_random random = test_random_from(seed);
    const test_kds_body a = body_of(of, ROOT_LEVEL, &random);
    return stage_with(a, body_of(of, ROOT_LEVEL, &random),
                      (bmr_family_def){family, 20.0, seed, family == BMR_FAMILY_LINE ? 0 : 64, 0});
}

/// Section 6, tuning: with richer roots and slower offsets beta nears 1 and kappa nears 3.
TEST(events_are_a_distance_over_beta_apart_and_no_more_than_a_clear_decomposition) {
    const bmr_family families[] = {BMR_FAMILY_LINE, BMR_FAMILY_ORBIT, BMR_FAMILY_ZIGZAG, BMR_FAMILY_WANDER};
    double without = INFINITY;
    for (int of = 0; of < SHAPES; ++of) {
        double least = INFINITY;
        uint64_t events = 0, segments = 0;
        for (size_t f = 0; f < COUNT_OF(families); ++f) {
            own_stage s = alike((shape)of, families[f], 3 + f);
            bmr_run_def def = {.simulation = bmr_default_simulation_def()};
            def.simulation.kds = tuned();
            bmr_clear clear;
            assert_int_equal(bmr_clear_decomposition(&s.course, KAPPA, 0.0, &clear), BMR_OK);
            const bmr_run run = run_of(&s, &bmr_kds_inflated_translation, def);
            least = fmin(least, run.hysteresis.both);
            events += run.events;
            segments += clear.least;
            assert_true(run.events <= clear.least);
            without = fmin(without, run_of(&s, &bmr_kds_lazy_compass, def).hysteresis.both);
        }
        printf("%s: moves by %.3f of the distance at least, %llu events, %llu segments for kappa = %.2f\n",
               shape_names[of], least, (unsigned long long)events, (unsigned long long)segments, KAPPA);
        assert_true(least >= 1.0 / BETA);
    }
    assert_true(without < 1.0 / BETA); // control: the lazy structure promises no such thing
}

TEST(a_table_of_too_few_levels_is_refused) {
    test_random random = test_random_from(1);
    own_polygon *square = polygon_of(SQUARE, &random);
    own_hierarchy *h = NULL;
    assert_int_equal(bmr_hierarchy_build_compass_with_corners(square, compass, TABLE_LEVELS + 1, NULL, &h),
                     BMR_ERROR_TABLE_TOO_SMALL);
    assert_int_equal(bmr_hierarchy_build_compass_with_corners(square, NULL, 1, NULL, &h),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_null(h);
    assert_int_equal(bmr_hierarchy_build_compass_with_corners(square, compass, TABLE_LEVELS, NULL, &h),
                     BMR_OK);
    assert_int_equal(bmr_hierarchy_audit(h), BMR_OK);
    assert_true(bmr_hierarchy_edge_count(h) <= 5 * 4 + (4u << TABLE_LEVELS));
}

/// One compass for all tests of a program.
__attribute__((constructor)) static void make_compass(void) {
    if (bmr_compass_create((size_t)1 << TABLE_LEVELS, NULL, &compass) != BMR_OK)
        abort();
}
__attribute__((destructor)) static void drop_compass(void) {
    bmr_compass_destroy(compass, NULL);
}
