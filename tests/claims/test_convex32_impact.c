// SPDX-License-Identifier: MIT
// Times of impact that take many directions: what slides along a side that turns.
#include <math.h>

#include "checks.h"

#include "convex32/convex32_distance.h"

static const float slop = 0.005f;
static const float tolerance = 0.25f * 0.005f;

static bmr_transform32 pose_at(const bmr_sweep32 *sweep, float t) {
    const float angle = (1.0f - t) * sweep->a0 + t * sweep->a, s = sinf(angle), c = cosf(angle);
    const bmr_vec32 l = sweep->local_center;
    const bmr_transform32 pose = {{(1.0f - t) * sweep->c0.x + t * sweep->c.x - (c * l.x - s * l.y),
                                   (1.0f - t) * sweep->c0.y + t * sweep->c.y - (s * l.x + c * l.y)},
                                  s,
                                  c};
    return pose;
}

static float distance_at(const bmr_proxy32 *a, const bmr_sweep32 *sweep_a, const bmr_proxy32 *b,
                         const bmr_sweep32 *sweep_b, float t) {
    const bmr_transform32 at_a = pose_at(sweep_a, t), at_b = pose_at(sweep_b, t);
    bmr_closest32 closest = {0, 0};
    return bmr_convex32_distance(a, &at_a, b, &at_b, &closest).distance;
}

/// A triangle turns by three radians, and a circle keeps to a side of four metres: it passes, three
/// millimetres farther than the distance looked for, or touches with a skin that is thicker by four.
TEST(a_circle_along_a_turning_side_is_followed_to_the_end) {
    static const bmr_vec32 triangle[] = {
        {0.303084105f, 4.33253002f}, {-2.64281178f, 1.35380948f}, {-1.82097781f, 0.225786775f}};
    static const bmr_vec32 centre = {0.384313732f, 0.384313732f};
    const bmr_proxy32 side = bmr_proxy32_points(triangle, 3, 0.01f);
    const bmr_sweep32 sweep_side = {{0.0215609986f, 0.390951395f},
                                    {1.93548501f, 1.93548501f},
                                    {3.87097001f, -0.689875722f},
                                    -5.37254906f,
                                    -8.59607887f,
                                    0.0f};
    const bmr_sweep32 sweep_circle = {{-0.53725493f, 0.2657969f},
                                      {1.98339295f, 1.98339295f},
                                      {3.96678591f, -0.0990970135f},
                                      -2.86274505f,
                                      -4.58039188f,
                                      0.0f};
    for (int how = 0; how < 4; ++how) { // the side that turns is the first shape's, or the second's
        const bool swapped = how % 2 != 0, touches = how >= 2;
        const bmr_proxy32 circle = bmr_proxy32_points(&centre, 1, touches ? 0.600078455f : 0.596078455f);
        const float target = side.radius + circle.radius - 3.0f * slop;
        bmr_vec32 direction = {0.0f, 0.0f};
        float t = -1.0f;
        const bmr_impact32 answer =
            swapped
                ? bmr_convex32_impact(&circle, &sweep_circle, &side, &sweep_side, 1.0f, slop, &direction, &t)
                : bmr_convex32_impact(&side, &sweep_side, &circle, &sweep_circle, 1.0f, slop, &direction, &t);
        assert_int_equal(answer, touches ? BMR_IMPACT_TOUCHING : BMR_IMPACT_SEPARATED);
        float least = INFINITY, last = 0.0f;
        for (int i = 0; i <= 1000; ++i) {
            last = distance_at(&side, &sweep_side, &circle, &sweep_circle, t * (float)i / 1000.0f);
            least = fminf(least, last);
        }
        assert_true(least > target - 1e-5f);
        if (touches)
            assert_true(last < target + tolerance + 1e-5f);
        else
            assert_true(t == 1.0f && least < target + 0.0035f);
    }
}
