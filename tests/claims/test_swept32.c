// SPDX-License-Identifier: MIT
// What is promised of shapes in motion is held against the motion itself, step by step in double precision;
// and the form of these files without SSE2 against the one with it.
#include "checks.h"

#include <fenv.h>
#include <float.h>
#include <math.h>

#include "convex32_poses.h"
#include "exact32/swept32.h"
#include "plain_lanes.h"

// --- Random shapes of up to 8 points in motion, and their gaps on the way, in double.

enum { MOST = BMR_SWEPT32_MOST };

static float random_in(float low, float high) {
    return (float)test_random_uniform(&check_random, (double)low, (double)high);
}

/// Signalling NaN: any arithmetic with it raises FE_INVALID.
static const uint32_t trap_bits = 0x7fa00000u;

/// A hull of up to 8 points, in order, in an array of 8. What is past the count is a trap.
typedef struct hull {
    bmr_vec32 points[MOST];
    int32_t count;
} hull;

static hull random_hull(void) {
    hull o;
    uint32_t *raw = (uint32_t *)(void *)o.points;
    for (int i = 0; i < 2 * MOST; ++i)
        raw[i] = trap_bits;
    o.count = 1 + (int32_t)test_random_below(&check_random, MOST);
    const float size = powf(10.0f, random_in(-1.0f, 0.7f)), flat = random_in(0.05f, 1.0f);
    const bmr_vec32 center = {random_in(-1.0f, 1.0f), random_in(-1.0f, 1.0f)};
    const float from = random_in(-3.0f, 3.0f);
    for (int i = 0; i < o.count; ++i) {
        const float angle = from + 6.28318f * ((float)i + random_in(0.0f, 0.8f)) / (float)o.count;
        o.points[i].x = center.x + size * cosf(angle);
        o.points[i].y = center.y + flat * size * sinf(angle);
    }
    return o;
}

/// Of a regular square about the origin.
static hull square(float half) {
    const hull o = {{{half, -half}, {half, half}, {-half, half}, {-half, -half}}, 4};
    return o;
}

typedef struct mover {
    hull shape;
    bmr_motion32 motion;
    double angle; ///< at the end
} mover;

static const bmr_vec32 none = {0.0f, 0.0f};

static mover place(hull shape, bmr_vec32 center, bmr_vec32 start, bmr_vec32 end, float angle, float turn) {
    const mover m = {shape, {center, start, end, sinf(angle), cosf(angle), turn}, (double)angle};
    return m;
}

/// `way` and `turn` bound how far it goes.
static mover random_mover(bmr_vec32 about, float way, float turn) {
    const bmr_vec32 center = {random_in(-1.0f, 1.0f), random_in(-1.0f, 1.0f)};
    const bmr_vec32 end = {about.x + random_in(-3.0f, 3.0f), about.y + random_in(-3.0f, 3.0f)};
    const bmr_vec32 start = {end.x + random_in(-way, way), end.y + random_in(-way, way)};
    return place(random_hull(), center, start, end, random_in(-3.0f, 3.0f), random_in(-turn, turn));
}

static bmr_swept32 swept(const mover *m) {
    bmr_swept32 s;
    bmr_swept32_make(&s, m->shape.points, m->shape.count, &m->motion);
    return s;
}

typedef struct point {
    double x, y;
} point;

/// Where the shape's points are when a part `t` of the motion is done.
static void pose(const mover *m, double t, point *points) {
    const double angle = m->angle - (1.0 - t) * (double)m->motion.turn, s = sin(angle), c = cos(angle);
    const double px = (1.0 - t) * (double)m->motion.start.x + t * (double)m->motion.end.x;
    const double py = (1.0 - t) * (double)m->motion.start.y + t * (double)m->motion.end.y;
    for (int i = 0; i < m->shape.count; ++i) {
        const double x = (double)m->shape.points[i].x - (double)m->motion.center.x;
        const double y = (double)m->shape.points[i].y - (double)m->motion.center.y;
        points[i].x = c * x - s * y + px;
        points[i].y = s * x + c * y + py;
    }
}

/// How far apart two shapes are along n at a time.
static double gap_at(const mover *a, const mover *b, double t, bmr_vec32 n) {
    point pa[MOST], pb[MOST];
    pose(a, t, pa);
    pose(b, t, pb);
    double most = -DBL_MAX, least = DBL_MAX;
    for (int i = 0; i < a->shape.count; ++i)
        most = fmax(most, (double)n.x * pa[i].x + (double)n.y * pa[i].y);
    for (int i = 0; i < b->shape.count; ++i)
        least = fmin(least, (double)n.x * pb[i].x + (double)n.y * pb[i].y);
    return least - most;
}

/// The least of it over the motion, as finely as it is looked at.
static double least_gap(const mover *a, const mover *b, bmr_vec32 n) {
    enum { SAMPLES = 32 };
    double least = DBL_MAX;
    for (int i = 0; i <= SAMPLES; ++i)
        least = fmin(least, gap_at(a, b, (double)i / SAMPLES, n));
    return least;
}

/// The largest gap of two still hulls along any direction, of many.
static double largest_gap(const mover *a, const mover *b) {
    enum { DIRECTIONS = 720 };
    double most = -DBL_MAX;
    for (int i = 0; i < DIRECTIONS; ++i) {
        const float angle = 6.2831853f * (float)i / DIRECTIONS;
        const bmr_vec32 n = {cosf(angle), sinf(angle)};
        most = fmax(most, gap_at(a, b, 1.0, n));
    }
    return most;
}

/// No two floats are taken for equal that are not, but for the sign of a zero.
static bool same(float a, float b) {
    return a == b || (isnan(a) && isnan(b));
}

// Coordinates below stay under 20, gaps are a few operations on them: 1e-5 is some ten units of 20 in the
// last place.
static const double rounding = 1e-5;

typedef struct tally {
    size_t apart, too_short, not_found;
} tally;

/// The motion itself denies no answer. Counts answers; too_short: those that a claim of `more` would be;
/// not_found: of shapes at rest, those that a direction would have kept apart by a five hundredth more.
static tally hold_against_motion(size_t rounds, float way, float turn, double more) {
    tally t = {0};
    for (size_t round = 0; round < rounds; ++round) {
        const bmr_vec32 there = {random_in(0.0f, 5.0f), random_in(-3.0f, 3.0f)};
        const mover a = random_mover(none, way, turn), b = random_mover(there, way, turn);
        const bmr_swept32 sa = swept(&a), sb = swept(&b);
        const float asked = random_in(0.0f, 0.5f);
        bmr_vec32 n = {0.0f, 0.0f};
        if (bmr_swept32_find_apart(&sa, &sb, asked, &n)) {
            const double least = least_gap(&a, &b, n);
            ++t.apart;
            assert_true(fabs(hypot((double)n.x, (double)n.y) - 1.0) < 1e-6);
            assert_true(least > (double)asked - rounding);
            t.too_short += !(least > (double)asked + more);
            // Along a direction beside the one that was found it holds as far as it is said to.
            const float off = random_in(-0.3f, 0.3f);
            const bmr_vec32 beside = {n.x - off * n.y, n.y + off * n.x};
            const float length = sqrtf(1.0f + off * off);
            const bmr_vec32 d = {beside.x / length, beside.y / length};
            assert_true(bmr_swept32_apart_along(&sa, &sb, asked, n));
            assert_true(!bmr_swept32_apart_along(&sa, &sb, asked, d) ||
                        least_gap(&a, &b, d) > (double)asked - rounding);
        } else {
            t.not_found +=
                way == 0.0f && turn == 0.0f && largest_gap(&a, &b) > 1.002 * (double)asked + rounding;
            assert_true(n.x == 0.0f && n.y == 0.0f);
        }
    }
    return t;
}

TEST(what_is_apart_stays_so_all_the_way) {
    const struct {
        float way, turn;
        double more; // the fixed direction is less than the best one the more they turn
    } motions[] = {
        {0.0f, 0.0f, 0.05}, {0.5f, 0.0f, 0.05}, {0.0f, 0.2f, 0.05}, {0.5f, 0.2f, 0.05}, {2.0f, 1.5f, 0.5}};
    for (size_t i = 0; i < sizeof motions / sizeof motions[0]; ++i) {
        const size_t rounds = test_scaled(20000);
        const tally t = hold_against_motion(rounds, motions[i].way, motions[i].turn, motions[i].more);
        assert_int_equal(t.not_found, 0);
        assert_true(t.apart > rounds / 20 && t.apart < rounds - rounds / 20);
        // The control: a claim of so much more would be seen to fail, so distances are not far from what is
        // asked.
        assert_true(t.too_short > 0);
    }
}

/// A point turns by as much as the series are for, and the other one stays: the answer changes where the
/// nearer end, less the height of the arc, is as far off as asked.
TEST(where_a_turn_began_is_known_to_rounding) {
    const hull tip = {{{1.0f, 0.0f}}, 1};
    const bmr_vec32 far = {3.0f, 0.0f}, n = {1.0f, 0.0f};
    const double turn = 0.25, room = 2e-6;
    size_t looks = 0;
    for (int k = 0; k < 200; ++k) {
        const mover a = place(tip, none, none, none, random_in(-3.0f, 3.0f), (float)turn),
                    b = place(tip, none, far, far, 0.0f, 0.0f);
        const bmr_swept32 sa = swept(&a), sb = swept(&b);
        const double at_end = gap_at(&a, &b, 1.0, n), height = 0.125 * turn * turn;
        const double least = fmin(at_end, gap_at(&a, &b, 0.0, n)) - height;
        if (at_end - turn > least - 1e-5)
            continue; // the length of the arc is enough
        assert_true(bmr_swept32_apart_along(&sa, &sb, (float)(least - room), n));
        assert_false(bmr_swept32_apart_along(&sa, &sb, (float)(least + room), n));
        ++looks;
    }
    assert_true(looks > 100);
}

TEST(a_shape_is_measured) {
    const hull o = {{{1.0f, 1.0f}, {4.0f, 1.0f}, {4.0f, 5.0f}}, 3};
    const bmr_vec32 center = {1.0f, 1.0f}, start = {7.0f, 8.0f}, end = {5.0f, 8.5f};
    const bmr_motion32 quarter = {center, start, end, 1.0f, 0.0f, 0.5f};
    bmr_swept32 s;
    bmr_swept32_make(&s, o.points, o.count, &quarter);
    const float x[MOST] = {0.0f, 0.0f, -4.0f}, y[MOST] = {0.0f, 3.0f, 3.0f};
    for (int i = 0; i < MOST; ++i) // past the count, the first again
        assert_true(s.x[i] == x[i] && s.y[i] == y[i]);
    assert_true(s.radius == 5.0f && s.width == 5.0f && s.edge == 3.0f && s.turn == 0.5f);
    assert_true(s.end.x == 5.0f && s.end.y == 8.5f && s.back.x == 2.0f && s.back.y == -0.5f);
    bmr_swept32_make(&s, o.points + 2, 1, &quarter);
    assert_true(s.radius == 5.0f && s.width == 0.0f && s.edge == FLT_MAX);
    bmr_swept32_make(&s, o.points + 1, 2, &quarter);
    assert_true(s.radius == 5.0f && s.width == 4.0f && s.edge == 4.0f);
}

TEST(what_is_no_number_is_unknown) {
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < 3; ++i)
        for (int32_t count = 1; count <= MOST; ++count)
            for (int32_t k = 0; k < 2 * count; ++k) {
                hull o = random_hull();
                while (o.count != count)
                    o = random_hull();
                const bmr_vec32 away = {50.0f, 0.0f};
                mover a = place(square(1.0f), none, none, none, 0.0f, 0.0f),
                      b = place(o, none, away, away, 0.0f, 0.0f);
                bmr_swept32 sa = swept(&a), sb = swept(&b);
                bmr_vec32 n = none;
                assert_true(bmr_swept32_find_apart(&sa, &sb, 1.0f, &n));
                *(k % 2 ? &b.shape.points[k / 2].y : &b.shape.points[k / 2].x) = bad[i];
                sb = swept(&b);
                assert_false(sb.radius <= FLT_MAX);
                n = none;
                assert_false(bmr_swept32_find_apart(&sa, &sb, 1.0f, &n));
                const bmr_transform32 still = {none, 0.0f, 1.0f}, off = {away, 0.0f, 1.0f};
                const bmr_vec32 right = {1.0f, 0.0f};
                float reach;
                bmr_posed32_gap(a.shape.points, 4, &still, b.shape.points, count, &off, right, &reach);
                assert_true(reach == INFINITY);
                if (count >= 3)
                    assert_true(bmr_points32_reach(b.shape.points, count) == INFINITY);
            }
}

TEST(nothing_past_count_is_computed_with) {
    const bmr_transform32 still = {none, 0.6f, 0.8f};
    size_t raised = 0;
    for (int round = 0; round < 1000; ++round) {
        const mover a = random_mover(none, 0.5f, 0.1f), b = random_mover(none, 0.5f, 0.1f);
        const bmr_polygon32 polygon = {a.shape.points, b.shape.points, a.shape.count};
        bmr_vec32 n = {1.0f, 0.0f};
        float reach;
        feclearexcept(FE_ALL_EXCEPT);
        const bmr_swept32 sa = swept(&a), sb = swept(&b);
        bmr_swept32_find_apart(&sa, &sb, 0.1f, &n);
        bmr_posed32_gap(a.shape.points, a.shape.count, &still, b.shape.points, b.shape.count, &still, n,
                        &reach);
        if (a.shape.count >= 3 && b.shape.count >= a.shape.count) {
            bmr_posed32_depth(&polygon, &still, n, &reach);
            bmr_points32_reach(a.shape.points, a.shape.count);
        }
        raised += fetestexcept(FE_INVALID) != 0;
    }
    assert_int_equal(raised, 0);
    // Control: one point more than there are, and the trap springs.
    mover a = random_mover(none, 0.5f, 0.1f);
    while (a.shape.count == MOST)
        a = random_mover(none, 0.5f, 0.1f);
    ++a.shape.count;
    feclearexcept(FE_ALL_EXCEPT);
    const bmr_swept32 sa = swept(&a);
    (void)sa;
    assert_true(fetestexcept(FE_INVALID) != 0);
}

TEST(what_lies_on_one_point_is_divided_by_nothing) {
    for (int32_t count = 1; count <= MOST; ++count) {
        hull o = random_hull();
        o.count = count;
        for (int i = 0; i < count; ++i) // also with sides of no length
            o.points[i] = i < 3 ? none : o.points[0];
        const mover m = place(o, none, none, none, 0.0f, 0.0f);
        for (float apart = -0.0f; apart < 2.0f; apart += 1.0f) {
            bmr_vec32 n = none;
            feclearexcept(FE_ALL_EXCEPT);
            const bmr_swept32 s = swept(&m);
            assert_false(bmr_swept32_find_apart(&s, &s, apart, &n));
            assert_int_equal(fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW), 0);
        }
    }
}

TEST(a_posed_gap_is_the_distance_along_its_direction) {
    size_t not_its_reverse = 0;
    for (size_t round = 0; round < test_scaled(20000); ++round) {
        const mover a = place(random_hull(), none, none, none, random_in(-3.0f, 3.0f), 0.0f);
        const bmr_vec32 at = {random_in(-8.0f, 8.0f), random_in(-8.0f, 8.0f)};
        const mover b = place(random_hull(), none, at, at, random_in(-3.0f, 3.0f), 0.0f);
        const bmr_transform32 xa = {a.motion.end, a.motion.s, a.motion.c}, xb = {at, b.motion.s, b.motion.c};
        const float angle = random_in(-3.2f, 3.2f);
        const bmr_vec32 n = {cosf(angle), sinf(angle)}, back = {-n.x, -n.y};
        float reach;
        const double found = (double)bmr_posed32_gap(a.shape.points, a.shape.count, &xa, b.shape.points,
                                                     b.shape.count, &xb, n, &reach);
        float largest = 0.0f;
        for (int i = 0; i < a.shape.count; ++i)
            largest = fmaxf(largest, fmaxf(fabsf(a.shape.points[i].x), fabsf(a.shape.points[i].y)));
        for (int i = 0; i < b.shape.count; ++i)
            largest = fmaxf(largest, fmaxf(fabsf(b.shape.points[i].x), fabsf(b.shape.points[i].y)));
        assert_true(reach == largest);
        assert_true(fabs(found - gap_at(&a, &b, 1.0, n)) < rounding);
        not_its_reverse += !(fabs(found - gap_at(&a, &b, 1.0, back)) < rounding);
    }
    assert_true(not_its_reverse > 0); // the control
}

TEST(a_depth_is_the_least_distance_from_a_side) {
    const bmr_vec32 corners[MOST] = {{2.0f, -1.0f}, {2.0f, 1.0f}, {-2.0f, 1.0f}, {-2.0f, -1.0f}};
    const bmr_vec32 normals[MOST] = {{1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}, {0.0f, -1.0f}};
    const bmr_polygon32 box = {corners, normals, 4};
    const bmr_transform32 quarter = {{10.0f, 0.0f}, 1.0f, 0.0f};
    const struct {
        bmr_vec32 point;
        float depth;
    } cases[] = {{{10.0f, 0.0f}, 1.0f},
                 {{10.75f, 0.0f}, 0.25f},
                 {{10.0f, 1.5f}, 0.5f},
                 {{10.0f, 4.0f}, -2.0f},
                 {{12.0f, 0.0f}, -1.0f}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        float reach = 1.5f;
        assert_true(bmr_posed32_depth(&box, &quarter, cases[i].point, &reach) == cases[i].depth);
        assert_true(reach == 2.0f);
    }
    float reach = 5.0f; // is raised, never lowered
    const bmr_vec32 nowhere = {NAN, 0.0f};
    assert_true(isnan(bmr_posed32_depth(&box, &quarter, nowhere, &reach)) && reach == 5.0f);
}

static void compare_forms(const bmr_swept32 *a, const bmr_swept32 *b) {
    for (int i = 0; i < MOST; ++i)
        assert_true(same(a->x[i], b->x[i]) && same(a->y[i], b->y[i]));
    assert_true(same(a->radius, b->radius) && same(a->width, b->width) && same(a->edge, b->edge));
    assert_true(same(a->turn, b->turn) && same(a->end.x, b->end.x) && same(a->back.y, b->back.y));
}

/// `strange`: some coordinate is no number, or large. What is promised then is that it is noticed.
static void compare_answers(size_t rounds, bool strange) {
    const float bad[] = {NAN, INFINITY, -INFINITY, 1e30f};
    for (size_t round = 0; round < rounds; ++round) {
        mover a = random_mover(none, 0.5f, 0.4f), b = random_mover(none, 0.5f, 0.4f);
        if (round % 8 == 0) // equal supports, zeros
            a.shape = b.shape = square(0.5f), a.motion.s = b.motion.s = 0.0f, a.motion.c = b.motion.c = 1.0f;
        b.motion.end.x += random_in(0.0f, 8.0f);
        bmr_vec32 *const some = &a.shape.points[test_random_below(&check_random, (uint32_t)a.shape.count)];
        if (strange)
            *(test_random_below(&check_random, 2) ? &some->x : &some->y) =
                bad[test_random_below(&check_random, 4)];
        const bmr_swept32 sa = swept(&a), sb = swept(&b);
        bmr_swept32 other;
        test_plain_swept32_make(&other, a.shape.points, a.shape.count, &a.motion);
        if (strange)
            assert_true(same(sa.radius, other.radius));
        else
            compare_forms(&sa, &other);

        const float apart = random_in(0.0f, 0.5f);
        bmr_vec32 n = {0.0f, 0.0f}, m = n;
        assert_int_equal(bmr_swept32_find_apart(&sa, &sb, apart, &n),
                         test_plain_swept32_find_apart(&other, &sb, apart, &m));
        assert_true(same(n.x, m.x) && same(n.y, m.y));
        assert_int_equal(bmr_swept32_apart_along(&sa, &sb, apart, n),
                         test_plain_swept32_apart_along(&sa, &sb, apart, m));

        const bmr_transform32 xa = {a.motion.end, a.motion.s, a.motion.c},
                              xb = {b.motion.end, b.motion.s, b.motion.c};
        float reach, scalar_reach;
        const float gap = bmr_posed32_gap(a.shape.points, a.shape.count, &xa, b.shape.points, b.shape.count,
                                          &xb, n, &reach);
        const float scalar_gap = test_plain_posed32_gap(a.shape.points, a.shape.count, &xa, b.shape.points,
                                                        b.shape.count, &xb, m, &scalar_reach);
        assert_true(same(gap, scalar_gap) && reach == scalar_reach);
        if (a.shape.count < 3 || b.shape.count < a.shape.count)
            continue;
        const bmr_polygon32 polygon = {a.shape.points, b.shape.points, a.shape.count};
        reach = scalar_reach = random_in(0.0f, 2.0f);
        assert_true(same(bmr_posed32_depth(&polygon, &xa, xb.p, &reach),
                         test_plain_posed32_depth(&polygon, &xa, xb.p, &scalar_reach)));
        assert_true(strange || reach == scalar_reach);
        assert_true(bmr_points32_reach(a.shape.points, a.shape.count) ==
                    test_plain_points32_reach(a.shape.points, a.shape.count));
    }
}

TEST(both_forms_give_the_same) {
    compare_answers(test_scaled(100000), false);
    compare_answers(test_scaled(20000), true);
}
