// SPDX-License-Identifier: MIT
#include "boomerang/certificate.h"
#include "certificate/coarse.h"
#include "checks.h"
#include "kds/structure.h"
#include "motions.h"
#include "owned.h"
#include "polygons.h"

#define TWO_PI 6.283185307179586
/// A certificate of A's line at `direction` with the support vertex of B as window, in B's normal cone.
static bmr_certificate vertex_certificate(const bmr_polygon *a, const bmr_polygon *b, bmr_vec2 direction,
                                          const bmr_pose *q) {
    const bmr_vec2 v = bmr_unrotate(q, bmr_neg(direction));
    const uint32_t j = bmr_polygon_support(b, v);
    const double offset = bmr_dot(direction, a->vertices[bmr_polygon_support(a, direction)]);
    bmr_certificate k;
    bmr_certificate_fill(&k, direction, offset, &b->vertices[j], 1,
                         bmr_polygon_normal(b, j > 0 ? j - 1 : b->count - 1), bmr_polygon_normal(b, j),
                         a->extent, b->extent);
    return k;
}

typedef struct setting {
    bmr_polygon *a, *b;
    bmr_pose pose;
    bmr_certificate certificate;
} setting;

static setting random_setting(test_random *random) {
    setting s;
    s.a = test_polygon((test_family)test_random_below(random, TEST_FAMILY_COUNT),
                       3 + test_random_below(random, 30), random);
    s.b = test_polygon((test_family)test_random_below(random, TEST_FAMILY_COUNT),
                       3 + test_random_below(random, 30), random);
    assert_non_null(s.a);
    assert_non_null(s.b);
    const double way = test_random_uniform(random, 0.0, TWO_PI);
    const double gap = exp(test_random_uniform(random, log(1e-3), log(10.0)));
    s.pose = test_pose_at(s.a, s.b, way, test_random_uniform(random, 0.0, TWO_PI), gap);
    s.certificate = vertex_certificate(s.a, s.b, bmr_vec2_make(cos(way), sin(way)), &s.pose);
    return s;
}

static void drop(setting *s) {
    bmr_polygon_destroy(s->a, NULL);
    bmr_polygon_destroy(s->b, NULL);
}

TEST(the_opposite_direction_is_outside_the_narrowest_bracket) {
    // A nearly flat corner at the bottom of B: its normal cone is 1e-9 wide. Turned by half a turn it is at
    // the top, and B reaches down to y = 1 - 3: the old window says 1.
    const bmr_vec2 corner = {0.0, 0.0}, low = {-5e-10, -1.0}, high = {5e-10, -1.0}, up = {0.0, 1.0};
    bmr_certificate k;
    bmr_certificate_fill(&k, up, 0.0, &corner, 1, low, high, 1.0, 3.0);
    bmr_pose q = {{0.0, 1.0}, 1.0, 0.0};
    double gap;
    assert_int_equal(bmr_certificate_check(&k, &q, 0.0, &gap), BMR_CHECK_HOLDS);
    q.c = -1.0;
    assert_int_equal(bmr_certificate_check(&k, &q, 0.0, &gap), BMR_CHECK_ROLLED);
    // The control: the two sines alone would have let it pass.
    const double past_low = -(double)k.low[0] * -1.0, past_high = (double)k.high[0] * -1.0;
    assert_true(past_low >= -BMR_ROLL_TOLERANCE && past_high >= -BMR_ROLL_TOLERANCE && gap > 0.0);
}

/// Of a window that is no float's rounding and holds everywhere, all that is lost is what the check's own
/// arithmetic may be off by: at any size the gap is a lower bound, and hardly lower.
TEST(what_the_evaluation_loses_is_in_the_offset) {
    const bmr_vec2 down = {0.0, -1.0}, everywhere = {0.0, 0.0};
    for (double size = 0x1p-20; size <= 0x1p20; size *= 0x1p20) {
        const bmr_vec2 end = {0.75 * size, -0.5 * size};
        bmr_certificate k;
        bmr_certificate_fill(&k, down, 0.0, &end, 1, everywhere, everywhere, size, size);
        for (int i = 0; i < 100; ++i) {
            const bmr_pose q = {{0.0, 0.0}, cos(0.0628 * i), sin(0.0628 * i)};
            const long double gap = -(long double)q.s * end.x - (long double)q.c * end.y;
            double below;
            bmr_certificate_check(&k, &q, 0.0, &below);
            assert_true(below <= gap && below >= gap - BMR_CERTIFICATE_LOSS * 2.0 * size);
        }
    }
}

TEST(only_a_bracket_costs_what_a_bracket_costs) {
    static const bmr_vec2 lows[] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    const bmr_vec2 end = {1.0, 0.0}, normal = {-1.0, 0.0};
    bmr_certificate k[3];
    for (int i = 0; i < 3; ++i)
        bmr_certificate_fill(&k[i], normal, 1.0, &end, 1, lows[i], bmr_left(lows[i]), 1.0, 1.0);
    assert_true(k[0].offset > 1.0f && k[0].offset < k[1].offset && k[1].offset == k[2].offset);
}

TEST(a_coarse_line_is_of_an_edge_or_an_axis) {
    test_random random = test_random_from(3);
    own_polygon *p = test_polygon(TEST_CIRCLE, 5, &random);
    for (uint32_t k = 0; k < 5; ++k) {
        bmr_vec2 edge, axis;
        assert_true(bmr_coarse_normal(p, k, &edge));
        assert_true(edge.x == bmr_polygon_normal(p, k).x && edge.y == bmr_polygon_normal(p, k).y);
        assert_true(bmr_coarse_normal(p, BMR_COARSE_AXIS + k, &axis) == (k < 4));
        assert_true(k == 4 || axis.x == (double)((k == 0) - (k == 2)));
        assert_true(k == 4 || axis.y == (double)((k == 1) - (k == 3)));
    }
    bmr_vec2 none;
    assert_false(bmr_coarse_normal(p, 5, &none));
    assert_false(bmr_coarse_normal(p, BMR_COARSE_AXIS - 1, &none));
}

TEST(a_half_plane_of_directions_is_a_bracket) {
    // The end of a segment along x is its support in every direction with x >= 0.
    const bmr_vec2 end = {1.0, 0.0}, low = {0.0, -1.0}, high = {0.0, 1.0}, normal = {-1.0, 0.0};
    bmr_certificate k;
    bmr_certificate_fill(&k, normal, 1.0, &end, 1, low, high, 1.0, 1.0);
    for (int degrees = -179; degrees <= 180; ++degrees) {
        const double angle = degrees * TWO_PI / 360.0;
        const bmr_pose q = {{-9.0, 0.0}, cos(angle), sin(angle)};
        double gap;
        const bmr_check check = bmr_certificate_check(&k, &q, 0.0, &gap);
        assert_int_equal(check == BMR_CHECK_ROLLED, abs(degrees) > 90);
    }
}

TEST(a_nan_anywhere_never_holds) {
    test_random random = test_random_from(13);
    for (int trial = 0; trial < 100; ++trial) {
        setting s = random_setting(&random);
        double gap;
        assert_int_equal(bmr_certificate_check(&s.certificate, &s.pose, -1.0, &gap), BMR_CHECK_HOLDS);
        float numbers[sizeof(bmr_certificate) / sizeof(float)];
        for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i) {
            memcpy(numbers, &s.certificate, sizeof numbers);
            numbers[i] = NAN;
            bmr_certificate k;
            memcpy(&k, numbers, sizeof k);
            assert_int_not_equal(bmr_certificate_check(&k, &s.pose, -1.0, &gap), BMR_CHECK_HOLDS);
        }
        double pose[4] = {s.pose.position.x, s.pose.position.y, s.pose.c, s.pose.s};
        for (size_t i = 0; i < 4; ++i)
            for (int sign = -1; sign <= 1; ++sign) {
                double bad[4];
                memcpy(bad, pose, sizeof bad);
                bad[i] = sign == 0 ? (double)NAN : (double)sign * (double)INFINITY;
                bmr_pose q = {{bad[0], bad[1]}, bad[2], bad[3]};
                assert_int_not_equal(bmr_certificate_check(&s.certificate, &q, -1.0, &gap), BMR_CHECK_HOLDS);
            }
        drop(&s);
    }
}

/// (Other tampering, and what a certificate's gap is worth: test_pair_properties.c, test_pair_oracle.cpp.)
TEST(a_normal_longer_than_1_is_refused) {
    test_random random = test_random_from(14);
    for (int trial = 0; trial < 100; ++trial) {
        setting s = random_setting(&random);
        assert_int_equal(bmr_certificate_audit(&s.certificate, s.a, s.b, &s.pose), BMR_OK);
        s.certificate.normal[0] *= 1.001f;
        s.certificate.normal[1] *= 1.001f;
        s.certificate.offset += (float)(s.a->extent + s.b->extent); // the line itself is fine
        assert_int_equal(bmr_certificate_audit(&s.certificate, s.a, s.b, &s.pose),
                         BMR_ERROR_FALSE_CERTIFICATE);
        drop(&s);
    }
}

TEST(the_audit_checks_where_the_two_points_of_a_window_tie) {
    // At either end of the bracket one point of the window is farther than the third corner. Straight up they
    // tie, and the corner may be above both.
    const bmr_vec2 window[2] = {{1.0, 0.0}, {-1.0, 0.0}}, low = {0.8, 0.6}, high = {-0.8, 0.6},
                   down = {0.0, -1.0}, triangle[3] = {{-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}};
    const bmr_pose q = {{0.0, -4.0}, 0.8, 0.6};
    own_polygon *owner = made_polygon(triangle, 3);
    for (int above = 0; above < 2; ++above) {
        const bmr_vec2 corners[3] = {window[0], window[1], {0.0, above ? 0.5 : -0.5}};
        own_polygon *other = made_polygon(corners, 3);
        bmr_certificate k;
        bmr_certificate_fill(&k, down, 1.0, window, 2, low, high, owner->extent, other->extent);
        assert_int_equal(bmr_certificate_audit(&k, owner, other, &q),
                         above ? BMR_ERROR_FALSE_CERTIFICATE : BMR_OK);
    }
}

// ---- conditions: when one counts as failed, and the rate that decides it close to zero ----

/// A motion that bends and turns, with its rates.
static bmr_instant instant_at(double time) {
    const double angle = 0.3 + 0.7 * time;
    const bmr_instant now = {
        .pose = {.position = {1.5 + 0.4 * time, -0.5 + 0.9 * time * time}, .c = cos(angle), .s = sin(angle)},
        .velocity = {0.4, 1.8 * time},
        .spin = 0.7};
    return now;
}

TEST(rates_are_derivatives_of_values) {
    const bmr_vec2 normal = {0.6, 0.8}, point = {-0.28, 0.96}, center = {0.2, -0.3};
    const bmr_condition conditions[] = {
        bmr_condition_beyond(0, normal, 0.1, point, 0), bmr_condition_beyond(1, normal, 0.1, point, 0),
        bmr_condition_turn(0, normal, point, 0), bmr_condition_turn(1, normal, point, 0),
        bmr_condition_disks(center, point, 0.5, 0)};
    const double step = 1e-6;
    for (size_t i = 0; i < sizeof conditions / sizeof *conditions; ++i) {
        double most = 0.0;
        for (double time = -2.0; time <= 2.0; time += 0.125) {
            const bmr_instant before = instant_at(time - step), now = instant_at(time),
                              after = instant_at(time + step);
            const double slope = (bmr_condition_value(&conditions[i], &after.pose) -
                                  bmr_condition_value(&conditions[i], &before.pose)) /
                                 (2.0 * step);
            const double rate = bmr_condition_rate(&conditions[i], &now);
            // A central difference is off by step^2 and by an ulp of the values over the step.
            assert_true(fabs(rate - slope) <= 1e-8);
            most = fmax(most, fabs(rate));
        }
        assert_true(most > 0.1); // there is a rate to be wrong about
    }
}

TEST(centers_that_coincide_have_no_rate) {
    bmr_instant now = instant_at(0.0);
    const bmr_condition disks = bmr_condition_disks(now.pose.position, bmr_vec2_make(0.0, 0.0), 0.5, 0);
    assert_true(bmr_condition_rate(&disks, &now) == 0.0);
}

TEST(close_to_zero_the_rate_decides) {
    const double tolerance = 1e-10;
    bmr_instant now = instant_at(0.0);
    const double far = hypot(now.pose.position.x, now.pose.position.y);
    for (int sign = -1; sign <= 1; sign += 2) {
        now.velocity = bmr_scale(sign, now.pose.position); // away from the origin, or towards it
        const struct {
            double above;
            bool fails;
        } cases[] = {{1e-9, false}, {5e-11, sign < 0}, {-5e-11, true}, {-1e-9, true}, {NAN, true}};
        for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
            const bmr_condition disks = bmr_condition_disks(bmr_vec2_make(0.0, 0.0), bmr_vec2_make(0.0, 0.0),
                                                            far - cases[i].above, 0);
            assert_int_equal(bmr_condition_fails(&disks, &now, tolerance), cases[i].fails);
        }
    }
}
