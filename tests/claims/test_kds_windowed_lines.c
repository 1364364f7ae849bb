// SPDX-License-Identifier: MIT
// The structures whose proof is a line and a window: refuted where they should be, and how long they last.
#include "checks.h"
#include "kds/structure.h"
#include "kds/windowed_line.h"
#include "kds_driver.h"
#include "motions.h"

static const char *const names[] = {
    "inflated-translation", "inflated-window", "hybrid", "two-lines", "coarse", "free-fd2",
    "predict-adaptive"};
#define NAMES (sizeof names / sizeof *names)

static bmr_kds *made(const char *name, const test_kds_body *a, const test_kds_body *b) {
    const bmr_kds_def def = bmr_default_kds_def();
    return made_kds(test_structure(name), &def, &a->shape, &b->shape);
}

/// The controls: what an audit must see, put into the state by hand (it begins with the line).
TEST(an_audit_refutes_what_is_false) {
    test_random random = test_random_from(4);
    own_kds_body a = test_kds_body_make(test_polygon(TEST_ELLIPSE, 30, &random));
    own_kds_body b = test_kds_body_make(test_polygon(TEST_REGULAR, 20, &random));
    const bmr_instant now = {test_pose_at(a.polygon, b.polygon, 0.4, 1.1, 0.3), {-0.3, 0.2}, 0.7};
    for (size_t k = 0; k < NAMES; ++k) {
        own_kds *kds = made(names[k], &a, &b);
        bmr_kds_report report;
        bmr_kds_start(kds, &now, &report);
        assert_true(report.apart && report.line_changed);
        assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
        bmr_windowed_line *w = (bmr_windowed_line *)(void *)kds->state;
        const bmr_windowed_line right = *w;
        w->line.offset -= 1e-6; // cuts off a vertex of the owner's
        assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_ERROR_FALSE_CERTIFICATE);
        *w = right;
        w->line.offset += 2.0; // cuts off the other
        assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_ERROR_FALSE_CERTIFICATE);
        *w = right;
        for (int i = 0; i < w->count; ++i) // nearer to its middle than the body is
            w->point[i] = bmr_scale(0.9, w->point[i]);
        assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_ERROR_INVALID_STRUCTURE);
        *w = right;
        if (!w->fixed) { // a bracket that the direction is not in
            w->low = w->high;
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_ERROR_INVALID_STRUCTURE);
            // At the ends of a vertex's cone its neighbours stand for it, and not in between.
            *w = right;
            bmr_windowed_exact(w, kds, &now.pose, 0);
            const bmr_polygon *p = (w->owner == 0 ? b : a).polygon;
            const uint32_t n = p->count, v = w->support[1 - w->owner], before = (v + n - 1) % n;
            w->low = bmr_polygon_normal(p, before), w->high = bmr_polygon_normal(p, v);
            w->point[0] = p->vertices[before], w->point[1] = p->vertices[(v + 1) % n];
            w->point[2] = p->vertices[v];
            w->count = 3;
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_OK);
            w->count = 2;
            assert_int_equal(bmr_kds_audit(kds, &now.pose), BMR_ERROR_INVALID_STRUCTURE);
        }
    }
}

/// A bracket ends sooner on the side that is nearer, and that is what counts where nobody knows which way it
/// turns.
TEST(a_bracket_lasts_as_long_as_its_nearer_side) {
    test_random random = test_random_from(12);
    size_t uneven = 0;
    for (size_t k = 0; k < NAMES; ++k)
        for (int i = 0; i < 20; ++i) {
            own_kds_body a = test_kds_body_make(test_polygon(TEST_ELLIPSE, 30, &random));
            own_kds_body b = test_kds_body_make(test_polygon(TEST_ELLIPSE, 20, &random));
            const bmr_instant now = {
                test_pose_at(a.polygon, b.polygon, 0.3 * i, 0.7 * i, 0.3), {-0.3, 0.2}, 0.7};
            own_kds *kds = made(names[k], &a, &b);
            bmr_kds_report report;
            bmr_kds_start(kds, &now, &report);
            const bmr_windowed_line *w = (const bmr_windowed_line *)(const void *)kds->state;
            const double low = bmr_windowed_life(w, &now.pose, -1), high = bmr_windowed_life(w, &now.pose, 1);
            assert_true(bmr_windowed_life(w, &now.pose, 0) == (low > high ? low : high));
            assert_true((low == -2.0) == w->fixed);
            uneven += low != high;
            // A corner takes the place of the polygon's own vertices only where it lasts longer to one side.
            for (int sense = -1; sense <= 1 && !w->fixed; sense += 2) {
                bmr_windowed_line own = *w, corner = *w;
                bmr_windowed_exact(&own, kds, &now.pose, sense);
                bmr_windowed_corners(&corner, kds, &now.pose, 0.01, sense);
                assert_true(
                    bmr_windowed_life(&corner, &now.pose, -1) <= bmr_windowed_life(&own, &now.pose, -1) ||
                    bmr_windowed_life(&corner, &now.pose, 1) <= bmr_windowed_life(&own, &now.pose, 1));
            }
        }
    assert_true(uneven > NAMES * 10);
}

/// The same polygon with y turned around.
static test_kds_body mirrored(const bmr_polygon *polygon) {
    bmr_vec2 points[64];
    assert_true(polygon->count <= 64);
    for (uint32_t i = 0; i < polygon->count; ++i)
        points[i] = bmr_vec2_make(polygon->vertices[i].x, -polygon->vertices[i].y);
    bmr_polygon *image = made_polygon(points, polygon->count);
    return test_kds_body_make(image);
}

/// For how long the line that a structure starts with separates, if the velocity stays; at most 100.
static double life_of_start(const char *name, const test_kds_body *a, const test_kds_body *b,
                            const bmr_instant *now) {
    own_kds *kds = made(name, a, b);
    bmr_kds_report report;
    bmr_kds_start(kds, now, &report);
    assert_true(report.apart);
    const bmr_vec2 u =
        bmr_windowed_direction((const bmr_windowed_line *)(const void *)kds->state, &now->pose);
    const double gap = bmr_kds_separation(kds, &now->pose, u) - bmr_default_kds_def().margin;
    const double closing = -bmr_dot(u, now->velocity);
    return gap < 100.0 * closing ? gap / closing : 100.0;
}

/// No sense of turning is preferred, and no end of the cone of the directions that separate. (The coarse line
/// is left out: of an even number of edges one of two middle ones is the first, and turning round makes it
/// the other.)
TEST(the_mirror_image_of_a_way_finds_a_line_that_lasts_as_long) {
    test_random random = test_random_from(13);
    size_t ending = 0;
    for (size_t k = 0; k < NAMES; ++k)
        for (size_t i = 0; i < 50 && strcmp(names[k], "coarse") != 0; ++i) {
            own_kds_body a = test_kds_body_make(test_polygon(TEST_CIRCLE, 20, &random));
            own_kds_body b = test_kds_body_make(test_polygon(TEST_ELLIPSE, 20, &random));
            own_kds_body image_a = mirrored(a.polygon), image_b = mirrored(b.polygon);
            const double way = test_random_uniform(&random, 0.0, 6.3);
            const bmr_instant now = {test_pose_at(a.polygon, b.polygon,
                                                  test_random_uniform(&random, 0.0, 6.3),
                                                  test_random_uniform(&random, 0.0, 6.3), 0.5),
                                     {cos(way), sin(way)},
                                     0.0};
            bmr_instant image = now;
            image.pose.position.y = -now.pose.position.y;
            image.pose.s = -now.pose.s;
            image.velocity.y = -now.velocity.y;
            const double life = life_of_start(names[k], &a, &b, &now),
                         image_life = life_of_start(names[k], &image_a, &image_b, &image);
            assert_true(fabs(life - image_life) <= 1e-9 * life);
            ending += life < 100.0;
        }
    assert_true(ending > NAMES * 10);
}
