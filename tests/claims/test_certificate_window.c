// SPDX-License-Identifier: MIT
// What the rotational hysteresis of the free directions rests on (docs/open-question.md): a window's bracket
// is as wide as the limit over the diameter, wherever the polygon's vertices lie, and costs no more than the
// limit.
#include "certificate/window.h"
#include "checks.h"
#include "hierarchies.h"
#include "polygons.h"

/// Of what one turn of a tangent pays for, whose loss is a quarter of the limit at least: then the tangents
/// meet that far from a chord, and two tangents that differ by the angle delta meet within (D/2)
/// tan(delta/2).
#define FOUND_PART 0.25
/// The short side of a leaning bracket costs this part of the limit.
#define SHORT_PART 0.0625
/// No turn is wider, whatever it costs.
#define WIDEST (75.0 * PI / 180.0)
#define WIDEST_SHORT (15.0 * PI / 180.0)
#define PI 3.14159265358979323846
#define ROUNDING 1e-9

static uint32_t support_of(const bmr_polygon *p, bmr_vec2 d) {
    uint32_t best = 0;
    for (uint32_t i = 1; i < p->count; ++i)
        if (bmr_dot(p->vertices[i], d) > bmr_dot(p->vertices[best], d))
            best = i;
    return best;
}

static double angle_from(bmr_vec2 a, bmr_vec2 b) {
    return atan2(bmr_cross(a, b), bmr_dot(a, b));
}

/// Least of what was found over what is promised, and the most that was lost at the direction.
typedef struct widths {
    double even, far, near; ///< of a bracket that does not lean, and the two sides of one that does
    double even_loss, loss; ///< over the diameter, and over the limit
    double vertices;        ///< the control: the support vertex with its two neighbours, against `even`
} widths;

static void measure(const bmr_polygon *p, bmr_vec2 d, double limit, widths *w) {
    const double diameter = test_diameter(p);
    const uint32_t n = p->count, v = support_of(p, d);
    const double height = bmr_dot(p->vertices[v], d);
    const double turn = fmin(WIDEST, 2.0 * atan(2.0 * FOUND_PART * limit / diameter));
    const double back = fmin(WIDEST_SHORT, 2.0 * atan(2.0 * FOUND_PART * SHORT_PART * limit / diameter));
    for (int lean = -1; lean <= 1; ++lean) {
        bmr_window window;
        bmr_window_make(p, d, v, limit, lean, &window);
        const double low = angle_from(window.low, d), high = angle_from(d, window.high);
        const double loss = fmax(bmr_dot(window.corner[0], d), bmr_dot(window.corner[1], d)) - height;
        if (lean == 0) {
            w->even = fmin(w->even, fmin(low, high) / turn);
            w->even_loss = fmax(w->even_loss, loss / diameter);
        } else {
            w->far = fmin(w->far, (lean > 0 ? high : low) / turn);
            w->near = fmin(w->near, (lean > 0 ? low : high) / back);
            w->loss = fmax(w->loss, loss / limit);
        }
    }
    // Its bracket reaches over the normals of the edges next to it.
    const double before = angle_from(bmr_polygon_normal(p, (v + n - 2) % n), d),
                 after = angle_from(d, bmr_polygon_normal(p, (v + 1) % n));
    w->vertices = fmin(w->vertices, fmin(before, after) / turn);
}

static widths measure_many(void) {
    widths w = {INFINITY, INFINITY, INFINITY, 0.0, 0.0, INFINITY};
    test_random random = test_random_from(31);
    for (size_t round = 0; round < test_scaled(400); ++round)
        for (int family = 0; family < TEST_FAMILY_COUNT; ++family) {
            const size_t n = 5 + test_random_below(&random, 150);
            own_polygon *p = test_polygon((test_family)family, n, &random);
            assert_non_null(p);
            // Now anywhere, now close to the normal of an edge, where the vertices crowd if they do.
            const bmr_vec2 normal = bmr_polygon_normal(p, test_random_below(&random, p->count));
            const double off =
                test_random_uniform(&random, -1.0, 1.0) * pow(10.0, test_random_uniform(&random, -5.0, 0.5));
            const bmr_pose by = {{0.0, 0.0}, cos(off), sin(off)};
            const double limit = test_diameter(p) * pow(10.0, test_random_uniform(&random, -4.0, 0.0));
            if (p->count > 4)
                measure(p, bmr_rotate(&by, normal), limit, &w);
        }
    return w;
}

TEST(a_bracket_is_as_wide_as_the_limit_pays_for) {
    const widths w = measure_many();
    assert_true(w.even >= 1.0 - ROUNDING);
    assert_true(w.far >= 1.0 - ROUNDING);
    assert_true(w.near >= 1.0 - ROUNDING);
    assert_true(w.vertices < 0.1); // the control
}

TEST(nothing_is_lost_at_the_direction_or_the_limit_when_leaning) {
    const widths w = measure_many();
    assert_true(w.even_loss <= ROUNDING);
    assert_true(w.loss <= 1.0 + ROUNDING);
    assert_true(w.loss > SHORT_PART); // leaning costs more than its short side does
}

TEST(a_point_and_a_segment_stand_for_themselves_in_every_direction) {
    const bmr_vec2 ends[2] = {{-0.5, 0.1}, {0.7, 0.2}};
    for (size_t n = 1; n <= 2; ++n)
        for (int lean = -1; lean <= 1; ++lean) {
            own_polygon *p = made_polygon(ends, n);
            bmr_window w;
            bmr_window_make(p, bmr_vec2_make(0.6, 0.8), 0, 0.1, lean, &w);
            assert_true(w.life == -2.0); // never
            assert_true(w.low.x == 0.0 && w.low.y == 0.0 && w.high.x == 0.0 && w.high.y == 0.0);
            for (size_t i = 0; i < n; ++i)
                assert_true((w.corner[0].x == p->vertices[i].x && w.corner[0].y == p->vertices[i].y) ||
                            (w.corner[1].x == p->vertices[i].x && w.corner[1].y == p->vertices[i].y));
        }
}

static bool is_unit(bmr_vec2 v) {
    return fabs(hypot(v.x, v.y) - 1.0) <= ROUNDING;
}

/// Do the corners reach as far as the polygon in every direction of the bracket?
static bool stands_for(const bmr_window *w, const bmr_polygon *p) {
    for (int i = 0; i <= 16; ++i) {
        const double part = i / 16.0;
        const bmr_vec2 d = bmr_add(bmr_scale(1.0 - part, w->low), bmr_scale(part, w->high));
        const double reach = fmax(bmr_dot(w->corner[0], d), bmr_dot(w->corner[1], d));
        if (!(reach >= bmr_dot(p->vertices[support_of(p, d)], d) - ROUNDING))
            return false;
    }
    return true;
}

static bool is_sound(const bmr_polygon *p, bmr_vec2 d, int lean) {
    bmr_window w;
    bmr_window_make(p, d, support_of(p, d), 1e-3, lean, &w);
    return is_unit(w.low) && is_unit(w.high) && angle_from(w.low, d) >= -ROUNDING &&
           angle_from(d, w.high) >= -ROUNDING && stands_for(&w, p);
}

/// Each point is `size` large: next to an edge of length 1 the rounding hides its edges, and products of
/// lengths as short as 1e-235 are 0.
TEST(points_that_are_polygons_themselves_stand_in_the_window) {
    test_random random = test_random_from(47);
    for (size_t round = 0; round < test_scaled(400); ++round) {
        bmr_vec2 points[12];
        const double size = pow(10.0, test_random_uniform(&random, -240.0, -8.0));
        const double flat = pow(10.0, test_random_uniform(&random, -60.0, 0.0));
        // Near the origin, where coordinates can be that small, and at another place.
        const size_t near = 2 + test_random_below(&random, 9);
        const bmr_vec2 far = {test_random_uniform(&random, -3.0, 3.0),
                              test_random_uniform(&random, -3.0, 3.0)};
        for (size_t i = 0; i < 12; ++i) {
            const double x = size * flat * test_random_uniform(&random, -1.0, 1.0),
                         y = size * test_random_uniform(&random, -1.0, 1.0);
            points[i] = i < near ? bmr_vec2_make(x, y) : bmr_vec2_make(x + far.x, y + far.y);
        }
        own_polygon *p = made_polygon(points, 12);
        for (uint32_t i = 0; p->count > 2 && i < p->count + 36; ++i) {
            const double angle = 10.0 * i * PI / 180.0;
            const bmr_vec2 d =
                i < p->count ? bmr_polygon_normal(p, i) : bmr_vec2_make(cos(angle), sin(angle));
            for (int lean = -1; lean <= 1; ++lean)
                assert_true(is_sound(p, d, lean));
        }
    }
}

/// Thousands of edges that are one up to rounding: the search for the far end of a tangent that lies along
/// them goes by doubling, not from edge to edge.
TEST(edges_that_are_one_up_to_rounding_cost_a_logarithm) {
    enum { SIDE = 2000 };
    bmr_vec2 points[2 * SIDE + 2];
    for (int i = -SIDE; i <= SIDE; ++i)
        points[i + SIDE] = bmr_vec2_make(i, -1e-300 * i * i);
    points[2 * SIDE + 1] = bmr_vec2_make(0.0, -SIDE);
    own_polygon *p = made_polygon(points, 2 * SIDE + 2);
    assert_int_equal(p->count, 2 * SIDE + 2);
    const bmr_vec2 up = {0.0, 1.0};
    for (int lean = -1; lean <= 1; ++lean) {
        bmr_window w;
        bmr_window_make(p, up, support_of(p, up), 1e-3, lean, &w);
        assert_true(w.steps <= 100);
        assert_true(bmr_cross(w.low, up) > 0.0 && bmr_cross(up, w.high) > 0.0);
        // All of the edge stands in the window.
        if (lean == 0)
            assert_true(fabs(w.corner[0].x - w.corner[1].x) >= 2 * SIDE);
    }
}
