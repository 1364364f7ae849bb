// SPDX-License-Identifier: MIT
// Section 6's tuning remark, beta towards 1 and kappa towards 3, for polygons with sharp corners: it holds
// where the root polygon has edges of length zero there, and fails at every corner without them.
#include "boomerang/analysis.h"
#include "boomerang/families.h"
#include "checks.h"
#include "kds/registry.h"
#include "kds_driver.h"
#include "motions.h"

#define COUNT(list) (sizeof(list) / sizeof *(list))

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
    bmr_polygon *made = NULL;
    switch (of) {
    case SQUARE:
        assert_int_equal(bmr_polygon_create(square, 4, NULL, &made), BMR_OK);
        return made;
    case TRIANGLE:
        assert_int_equal(bmr_polygon_create(triangle, 3, NULL, &made), BMR_OK);
        return made;
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
    test_random random = {3};
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
    for (size_t i = 0; i < COUNT(names); ++i)
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

/// A run of a tuned structure along a motion past two polygons alike.
typedef struct outcome {
    bmr_run run;
    bmr_clear clear;
} outcome;

static outcome run_of(const bmr_kds_info *info, shape of, bmr_family family, uint32_t corner_levels,
                      uint64_t seed) {
    test_random random = {seed};
    own_kds_body a = body_of(of, corner_levels, &random), b = body_of(of, corner_levels, &random);
    const bmr_family_def how = {family, 20.0, seed, family == BMR_FAMILY_LINE ? 0 : 64, 0};
    own_family motion;
    assert_int_equal(bmr_family_create(&how, a.polygon, b.polygon, NULL, &motion), BMR_OK);
    const bmr_course course = {{a.polygon, b.polygon}, {motion.motions[0], motion.motions[1]}, 0.0, 1.0};
    bmr_run_def def = {.structure = info,
                       .shapes = {a.shape, b.shape},
                       .simulation = bmr_default_simulation_def(),
                       .audit = true};
    def.simulation.kds = tuned();
    outcome o;
    assert_int_equal(bmr_run_course(&def, &course, motion.diameter, NULL, &o.run), BMR_OK);
    assert_int_equal(o.run.audit, BMR_OK);
    assert_int_equal(bmr_clear_decomposition(&course, KAPPA, 0.0, &o.clear), BMR_OK);
    return o;
}

/// Section 6, tuning: with richer roots and slower offsets beta nears 1 and kappa nears 3.
TEST(events_are_a_distance_over_beta_apart_and_no_more_than_a_clear_decomposition) {
    const bmr_family families[] = {BMR_FAMILY_LINE, BMR_FAMILY_ORBIT, BMR_FAMILY_ZIGZAG, BMR_FAMILY_WANDER};
    double without = INFINITY;
    for (int of = 0; of < SHAPES; ++of) {
        double least = INFINITY;
        uint64_t events = 0, segments = 0;
        for (size_t f = 0; f < COUNT(families); ++f) {
            const outcome o =
                run_of(&bmr_kds_inflated_translation, (shape)of, families[f], ROOT_LEVEL, 3 + f);
            least = fmin(least, o.run.hysteresis.both);
            events += o.run.events;
            segments += o.clear.least;
            assert_true(o.run.events <= o.clear.least);
            const outcome lazy = run_of(&bmr_kds_lazy_compass, (shape)of, families[f], ROOT_LEVEL, 3 + f);
            without = fmin(without, lazy.run.hysteresis.both);
        }
        printf("%s: moves by %.3f of the distance at least, %llu events, %llu segments for kappa = %.2f\n",
               shape_names[of], least, (unsigned long long)events, (unsigned long long)segments, KAPPA);
        assert_true(least >= 1.0 / BETA);
    }
    assert_true(without < 1.0 / BETA); // control: the lazy structure promises no such thing
}

TEST(a_table_of_too_few_levels_is_refused) {
    test_random random = {1};
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
