// SPDX-License-Identifier: MIT
#include "boomerang/pair.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

#define TWO_PI 6.283185307179586
#define FOR_EACH_STRUCTURE(s) for (bmr_structure s = 0; s < BMR_STRUCTURE_COUNT; ++s)

// --- allocations are counted by standing in for malloc ---

static size_t allocations;

#if defined(__has_feature)
#    if __has_feature(address_sanitizer)
#        define TEST_PAIR_ASAN
#    endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(TEST_PAIR_ASAN)
static const bool counts = false; // it stands there itself
#else
static const bool counts = true;
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *malloc(size_t size) {
    ++allocations;
    return __libc_malloc(size);
}
void *calloc(size_t count, size_t size) {
    ++allocations;
    return __libc_calloc(count, size);
}
void *realloc(void *block, size_t size) {
    ++allocations;
    return __libc_realloc(block, size);
}
#endif

// --- shapes ---

/// Points of an ellipse with half axes 1 and `flatness`, turned by `angle`.
static bmr_polygon *ellipse(size_t n, double flatness, double angle) {
    bmr_vec2 points[4096];
    assert_true(n <= COUNT_OF(points));
    for (size_t i = 0; i < n; ++i) {
        const double t = TWO_PI * ((double)i + 0.37) / (double)n;
        points[i] = bmr_vec2_make(cos(t), flatness * sin(t));
    }
    test_move_points(points, n, angle, 0.0, 0.0);
    return made_polygon(points, n);
}

static bmr_polygon *box(double half_width, double half_height) {
    bmr_vec2 points[4];
    return made_polygon(points, test_box_points(half_width, half_height, points));
}

static bmr_answer advance(test_pair *c, bmr_pose q) {
    const bmr_answer answer = test_pair_advance(c, &q, NULL);
    assert_int_equal(test_pair_audit(c, &q), BMR_OK);
    return answer;
}
/// Level changes by coarsening come with an event that is counted already.
static double events_of(const bmr_counters *counters) {
    uint64_t events = 0;
    for (int i = 0; i < BMR_EVENT_KIND_COUNT; ++i)
        events += i == BMR_EVENT_COARSEN ? 0 : counters->events[i];
    return (double)events;
}
static bmr_pose pose(double x, double y, double angle) {
    return bmr_pose_from_angle(bmr_vec2_make(x, y), angle);
}

// --- the plain things ---

TEST(a_pose_that_is_no_motion_answers_stab_and_does_no_harm) {
    const double bad[][4] = {{NAN, 0, 1, 0},      {0, NAN, 1, 0},       {9, 0, NAN, 0},      {9, 0, 1, NAN},
                             {INFINITY, 0, 1, 0}, {0, -INFINITY, 1, 0}, {9, 0, INFINITY, 0}, {9, 0, 0, 0},
                             {9, 0, 2, 0},        {9, 0, 0.9, 0}};
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, ellipse(20, 0.5, 0.0), box(1.0, 0.5));
        for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
            for (int before = 0; before < 3; ++before) { // new, apart by a line, in contact
                bmr_pair_init(&c.pair);
                if (before > 0)
                    assert_int_equal(advance(&c, pose(0.0, before == 1 ? 1.1 : 0.2, 0.1)),
                                     before == 1 ? BMR_APART : BMR_STAB_POLYGON);
                const bmr_pose q = {{bad[i][0], bad[i][1]}, bad[i][2], bad[i][3]};
                double gap = 7.0;
                assert_int_equal(test_pair_advance(&c, &q, &gap), BMR_STAB_POLYGON);
                assert_true(gap == 0.0);
                assert_int_equal(test_pair_audit(&c, &q), BMR_OK);
                assert_int_equal(advance(&c, pose(0.0, 1.1, 0.1)), BMR_APART);
            }
    }
}

TEST(far_poses_are_apart_up_to_the_largest_double) {
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, ellipse(20, 0.5, 0.0), box(1.0, 0.5));
        for (double x = 1.0; x < 1e300; x *= 7.0) {
            const bmr_pose q = pose(-x, x / 3.0, x);
            double gap;
            const bmr_answer answer = test_pair_advance(&c, &q, &gap);
            assert_true(x < 3.0 || answer == BMR_APART);
            assert_true(gap <= hypot(x, x / 3.0));
        }
    }
}

TEST(a_pair_leaves_contact_beyond_margin_and_hysteresis) {
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, box(1.0, 1.0), box(1.0, 1.0));
        c.def.margin = 0.01;
        c.def.hysteresis = 0.02;
        assert_int_equal(advance(&c, pose(0.0, 2.02, 0.0)), BMR_APART);
        assert_int_equal(advance(&c, pose(0.0, 2.005, 0.0)), BMR_STAB_POLYGON);
        assert_int_equal(advance(&c, pose(0.0, 2.02, 0.0)), BMR_STAB_POLYGON);
        assert_int_equal(advance(&c, pose(0.0, 2.04, 0.0)), BMR_APART);
    }
}

TEST(a_pair_does_not_allocate) {
    test_random random = test_random_from(5);
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, ellipse(100, 0.4, 0.0), ellipse(60, 0.7, 0.0));
        static bmr_pose poses[2000];
        for (size_t i = 0; i < 2000; ++i)
            poses[i] = test_pose_at(c.shape[0].polygon, c.shape[1].polygon, 0.03 * (double)i,
                                    0.02 * (double)i, test_random_uniform(&random, -0.05, 0.2));
        const size_t before = allocations;
        for (size_t i = 0; i < 2000; ++i) {
            test_pair_advance(&c, &poses[i], NULL);
            bmr_pair_audit(&c.pair, &c.def, &c.shape[0], &c.shape[1], &poses[i]);
        }
        assert_int_equal(allocations, before);
        assert_true(events_of(&c.counters) > 500.0);
        void *volatile block = malloc(100); // the control: this count does count
        free(block);
        assert_true(!counts || allocations > before);
    }
}

// --- flat on flat ---

TEST(a_flat_box_sliding_on_a_flat_box_does_not_roll_each_step) {
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, box(10.0, 1.0), box(1.0, 1.0));
        test_random random = test_random_from(8);
        size_t beyond = 0, steps = 5000;
        for (size_t i = 0; i < steps; ++i) {
            // What single precision makes of an angle of 0: noise, but for the sliding.
            const double noise = test_random_uniform(&random, -1.5e-7, 1.5e-7);
            const bmr_pose q = pose(-9.0 + 18.0 * (double)i / (double)steps, 2.0005, noise);
            assert_int_equal(advance(&c, q), BMR_APART);
            // The control: a checker with no tolerance would call half of these a roll.
            const bmr_certificate *k = &c.pair.certificate;
            const bmr_pose inverse = bmr_pose_inverse(&q), *frame = c.pair.owner == 0 ? &q : &inverse;
            const bmr_vec2 d =
                bmr_neg(bmr_unrotate(frame, bmr_vec2_make((double)k->normal[0], (double)k->normal[1])));
            const bmr_vec2 low = {(double)k->low[0], (double)k->low[1]},
                           high = {(double)k->high[0], (double)k->high[1]};
            beyond += bmr_cross(low, d) < 0.0 || bmr_cross(d, high) < 0.0;
        }
        assert_true(events_of(&c.counters) <= 4.0);
        if (s < BMR_FREE_DIRECTION) // there the bracket's ends are not on the flat
            assert_true(beyond > steps / 4);
    }
}

TEST(spinning_far_apart_costs_nothing) {
    FOR_EACH_STRUCTURE(s) {
        own_pair c = test_pair_make(s, ellipse(64, 0.3, 0.0), ellipse(64, 0.3, 0.0));
        for (int i = 0; i < 1000; ++i)
            assert_int_equal(advance(&c, pose(2.5, 0.0, 0.1 * i)), BMR_APART);
        assert_int_equal(c.counters.events[BMR_EVENT_START], 1);
        assert_true(events_of(&c.counters) == 1.0);
        // The control: where the disks overlap, spinning does cost.
        for (int i = 0; i < 1000; ++i)
            advance(&c, pose(0.0, 1.4, 0.1 * i));
        assert_true(events_of(&c.counters) > 50.0);
    }
}

// --- how events grow ---

/// Events of a straight pass whose least distance is sigma, sampled finely near the closest place.
static double events_of_a_pass(bmr_structure s, size_t n, double sigma, double way, double *features) {
    own_pair c = test_pair_make(s, ellipse(n, 0.25, 0.3), ellipse(n, 0.5, 1.9));
    const bmr_pose nearest = test_pose_at(c.shape[0].polygon, c.shape[1].polygon, way, 0.6, sigma);
    const bmr_vec2 along = {-sin(way), cos(way)};
    uint32_t last = 0;
    for (int i = -3000; i <= 3000; ++i) {
        const double t = i / 3000.0;
        bmr_pose q = nearest;
        q.position = bmr_add(q.position, bmr_scale(6.0 * t * t * t, along));
        assert_int_equal(test_pair_advance(&c, &q, NULL), BMR_APART);
        // What the same pass costs whoever follows the vertex nearest to the other's centre.
        const uint32_t feature = bmr_polygon_support(c.shape[0].polygon, q.position);
        *features += feature != last;
        last = feature;
    }
    return events_of(&c.counters);
}

TEST(events_of_a_pass_grow_with_the_logarithm_of_its_nearness_and_not_with_n) {
    const size_t sizes[] = {64, 512, 4096};
    const double ways[] = {0.1, 1.3, 2.9, 4.4, 5.5, 6.1};
    FOR_EACH_STRUCTURE(s) {
        double least[3] = {0}, most[3] = {0}, features[3] = {0};
        for (size_t k = 0; k < 3; ++k) {
            double unused = 0.0;
            for (size_t w = 0; w < 6; ++w) {
                least[k] += events_of_a_pass(s, sizes[k], 2.0 / 10.0, ways[w], &unused) / 6.0;
                most[k] += events_of_a_pass(s, sizes[k], 2.0 / 1e4, ways[w], &features[k]) / 6.0;
            }
            features[k] /= 6.0;
            const double doublings = log2(1e3), slope = (most[k] - least[k]) / doublings;
            assert_true(slope > 0.0); // it does see the difference
            assert_true(slope <= 1.2);
        }
        // With few vertices there are fewer levels than the nearness asks for; from then on n does not
        // matter.
        assert_true(most[0] <= most[1] + 0.5 && fabs(most[2] - most[1]) <= 1.0);
        // The control: a structure on full resolution pays in n.
        assert_true(features[2] > 4.0 * features[1] && features[1] > 4.0 * features[0]);
        assert_true(features[2] > 20.0 * most[2]);
    }
}

/// Events of one turn around the other at a distance of sigma, counter-clockwise (sense 1) or clockwise (-1),
/// the other turning `spin` times meanwhile.
static double events_of_an_orbit(bmr_structure s, size_t n, double sigma, double sense, double spin) {
    own_pair c = test_pair_make(s, ellipse(n, 0.25, 0.3), ellipse(n, 0.5, 1.9));
    for (int i = 0; i < 20000; ++i) {
        const double turned = sense * TWO_PI * i / 20000.0;
        const bmr_pose q =
            test_pose_at(c.shape[0].polygon, c.shape[1].polygon, turned, 0.6 + spin * turned, sigma);
        test_pair_advance(&c, &q, NULL);
    }
    return events_of(&c.counters);
}

/// The free direction's brackets reach to where a body turns: to either side alike.
TEST(an_orbit_meets_as_many_events_backwards) {
    for (int spin = -1; spin <= 2; ++spin) {
        const double there = events_of_an_orbit(BMR_FREE_DIRECTION, 256, 2e-2, 1.0, spin),
                     back = events_of_an_orbit(BMR_FREE_DIRECTION, 256, 2e-2, -1.0, spin);
        assert_true(fabs(there - back) <= 0.2 * there);
    }
}

TEST(events_of_an_orbit_grow_with_the_square_root_of_its_nearness) {
    FOR_EACH_STRUCTURE(s) {
        const double far = events_of_an_orbit(s, 4096, 2e-1, 1.0, 0.0),
                     near = events_of_an_orbit(s, 4096, 2e-3, 1.0, 0.0);
        const double exponent = log(near / far) / log(100.0);
        assert_true(exponent > 0.3 && exponent < 0.6);
    }
}
