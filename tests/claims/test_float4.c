// SPDX-License-Identifier: MIT
// The order of float operations is the contract of core/exact32. The lanes of this processor give the bits of
// plain C: each operation, and what is written in them. (What is written in them for swept shapes is in
// test_swept32.c.)
#include "checks.h"

#include <fenv.h>
#include <float.h>

#include "convex32_poses.h"
#include "plain_lanes.h"
#include "polygons.h"

#define FLOAT4_TABLE test_native_float4
#include "float4_operations.h"

enum { OPERATIONS_IN_ALL = sizeof test_native_float4 / sizeof test_native_float4[0] };

/// The same bits, or both no numbers.
static bool same(float a, float b) {
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static float any_bits(test_random *d) {
    const uint32_t bits = (uint32_t)test_random_next(d);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/// Ordinary, at the ends of what floats can hold, equal to others, or any 32 bits.
static float any_float(test_random *d) {
    static const float ends[] = {
        0.0f,     -0.0f,    1.0f,      -1.0f, 0x1p-149f,        -0x1p-149f, FLT_MIN, -FLT_MIN, FLT_MAX,
        -FLT_MAX, INFINITY, -INFINITY, NAN,   0x1.fffffep-127f, 3.0f,       0x1p24f, 0x1p-24f, FLT_EPSILON};
    switch (test_random_below(d, 4)) {
    case 0:
        return ends[test_random_below(d, sizeof ends / sizeof ends[0])];
    case 1:
        return any_bits(d);
    default:
        return (float)test_random_uniform(d, -4.0, 4.0);
    }
}

TEST(every_operation_has_the_bits_of_plain_c) {
    printf("lanes: %s\n", BMR_FLOAT4_NATIVE ? "the processor's" : "plain C's");
    for (int k = 0; k < OPERATIONS_IN_ALL; ++k) {
        const float4_operation *const native = &test_native_float4[k], *const plain = &test_plain_float4[k];
        assert_string_equal(native->name, plain->name);
        test_random d = test_random_from(7);
        for (size_t round = 0; round < test_scaled(200000); ++round) {
            float a[4], b[4], x[4] = {0}, y[4] = {0};
            for (int i = 0; i < 4; ++i) {
                a[i] = any_float(&d);
                b[i] = test_random_below(&d, 6) == 0 ? a[i] : any_float(&d);
            }
            const int32_t count = (int32_t)test_random_below(&d, 9);
            native->run(a, b, count, x);
            plain->run(a, b, count, y);
            for (int i = 0; i < 4; ++i)
                if (!same(x[i], y[i]))
                    fail_msg("%s, lane %d: %a and %a", native->name, i, (double)x[i], (double)y[i]);
        }
    }
}

/// Words that are the same bits, or no numbers.
static bool same_words(const void *a, const void *b, size_t size) {
    const float *const x = a, *const y = b;
    bool all = true;
    for (size_t i = 0; i < size / sizeof *x; ++i)
        all = all && same(x[i], y[i]);
    return all;
}

// --- polygons of up to 8 vertices: loops, lanes and plain C are compared bit by bit ---

enum { MOST = 8 };

typedef struct arrays {
    bmr_vec32 vertices[MOST], normals[MOST];
} arrays;

static int random_below(int count) {
    return (int)test_random_below(&check_random, (uint32_t)count);
}

static float random_in(float low, float high) {
    return (float)test_random_uniform(&check_random, (double)low, (double)high);
}

// The sign of a zero is the one bit that is not promised: separations are only ever compared, and a tie
// between zeros of either sign is decided by the order of the vertices in one form and of the lanes in the
// other.
static bool same_bits(float a, float b) {
    return memcmp(&a, &b, sizeof a) == 0 || (a == 0.0f && b == 0.0f);
}

typedef enum flavour { ORDINARY, GRID, HUGE_AND_TINY, ANYTHING, FLAVOURS } flavour;

static float number(flavour kind) {
    switch (kind) {
    case ORDINARY:
        return random_in(-5.0f, 5.0f);
    case GRID: // equal separations, exact zeros of both signs
        return 0.5f * (float)(random_below(5) - 2);
    case HUGE_AND_TINY:
        return random_in(-1.0f, 1.0f) * powf(10.0f, (float)(random_below(77) - 38));
    default:
        return any_float(&check_random);
    }
}

/// Signalling NaN: any arithmetic with it raises FE_INVALID.
static const uint32_t trap_bits = 0x7fa00000u;

static bmr_polygon32 random_arrays(arrays *memory, int count, flavour kind) {
    uint32_t *raw = (uint32_t *)(void *)memory;
    for (size_t i = 0; i < sizeof *memory / sizeof *raw; ++i)
        raw[i] = trap_bits;
    for (int i = 0; i < count; ++i) {
        memory->vertices[i] = (bmr_vec32){number(kind), number(kind)};
        memory->normals[i] = (bmr_vec32){number(kind), number(kind)};
    }
    return (bmr_polygon32){memory->vertices, memory->normals, count};
}

static bmr_transform32 random_frame(flavour kind) {
    if (kind == GRID) {
        const int quarter = random_below(4);
        const float sines[] = {0.0f, 1.0f, 0.0f, -1.0f};
        return (bmr_transform32){{number(kind), number(kind)}, sines[quarter], sines[(quarter + 1) % 4]};
    }
    if (kind == ANYTHING)
        return (bmr_transform32){{number(kind), number(kind)}, number(kind), number(kind)};
    const float angle = random_in(-3.2f, 3.2f);
    return (bmr_transform32){{number(kind), number(kind)}, sinf(angle), cosf(angle)};
}

static void compare_with_loops(const bmr_polygon32 *a, const bmr_transform32 *at_a, const bmr_polygon32 *b,
                               const bmr_transform32 *at_b) {
    const bmr_transform32 frame = bmr_exact32_relative(at_b, at_a);
    float best = -FLT_MAX;
    int32_t found = -1, first_of_best = 0;
    for (int32_t e = 0; e < a->count; ++e) {
        const float s = bmr_exact32_edge_separation(a, e, b, &frame);
        assert_true(same_bits(s, bmr_exact32_posed_separation(a->vertices + e, a->normals + e, at_a,
                                                              b->vertices, b->count, at_b)));
        if (s > best) {
            best = s;
            first_of_best = e;
        }
    }
    assert_true(same_bits(bmr_exact32_max_separation(a, b, &frame, &found), best));
    assert_int_equal(found, first_of_best);
}

/// Lanes and plain C differ in no bit.
static void compare_with_plain(const bmr_polygon32 *a, const bmr_transform32 *at_a, const bmr_polygon32 *b,
                               const bmr_transform32 *at_b) {
    const bmr_transform32 frame = bmr_exact32_relative(at_b, at_a);
    for (int32_t e = 0; e < a->count; ++e)
        assert_true(same(
            bmr_exact32_posed_separation(a->vertices + e, a->normals + e, at_a, b->vertices, b->count, at_b),
            test_plain_exact32_posed_separation(a->vertices + e, a->normals + e, at_a, b->vertices, b->count,
                                                at_b)));
    int32_t found = -1, plain_found = -1;
    assert_true(same(bmr_exact32_max_separation(a, b, &frame, &found),
                     test_plain_exact32_max_separation(a, b, &frame, &plain_found)));
    assert_int_equal(found, plain_found);
    if (a->count < 3 || b->count < 3)
        return;
    bmr_manifold32 manifold, plain;
    memset(&manifold, 0x5a, sizeof manifold);
    memset(&plain, 0x5a, sizeof plain);
    const float radius = random_in(0.0f, 2.0f);
    assert_int_equal(bmr_exact32_collide(&manifold, a, at_a, b, at_b, radius, 0.0005f),
                     test_plain_exact32_collide(&plain, a, at_a, b, at_b, radius, 0.0005f));
    assert_true(same_words(&manifold, &plain, sizeof plain));
}

TEST(both_forms_give_the_same_bits) {
    arrays memory_a, memory_b;
    for (flavour kind = ORDINARY; kind < FLAVOURS; ++kind)
        for (size_t round = 0; round < test_scaled(300000); ++round) {
            const bmr_polygon32 a = random_arrays(&memory_a, 1 + random_below(MOST), kind);
            const bmr_polygon32 b = random_arrays(&memory_b, 1 + random_below(MOST), kind);
            const bmr_transform32 at_a = random_frame(kind), at_b = random_frame(kind);
            compare_with_loops(&a, &at_a, &b, &at_b);
            compare_with_plain(&a, &at_a, &b, &at_b);
        }
}

TEST(nothing_past_count_is_computed_with) {
    arrays memory_a, memory_b;
    size_t raised = 0;
    for (size_t round = 0; round < test_scaled(100000); ++round) {
        const bmr_polygon32 a = random_arrays(&memory_a, 1 + random_below(MOST), ORDINARY);
        const bmr_polygon32 b = random_arrays(&memory_b, 1 + random_below(MOST), ORDINARY);
        const bmr_transform32 frame = random_frame(ORDINARY);
        int32_t edge;
        feclearexcept(FE_ALL_EXCEPT);
        volatile float sink = bmr_exact32_max_separation(&a, &b, &frame, &edge);
        sink = bmr_exact32_edge_separation(&a, a.count - 1, &b, &frame);
        sink = bmr_exact32_posed_separation(a.vertices, a.normals, &frame, b.vertices, b.count, &frame);
        (void)sink;
        raised += fetestexcept(FE_INVALID) != 0;
    }
    assert_int_equal(raised, 0);

    // Control: one vertex more than there are, and the trap springs.
    bmr_polygon32 a = random_arrays(&memory_a, 3, ORDINARY);
    const bmr_polygon32 b = random_arrays(&memory_b, 3, ORDINARY);
    const bmr_transform32 frame = random_frame(ORDINARY);
    a.count = 4;
    feclearexcept(FE_ALL_EXCEPT);
    volatile float sink = bmr_exact32_edge_separation(&a, 3, &b, &frame);
    (void)sink;
    assert_true(fetestexcept(FE_INVALID) != 0);
}

TEST(nan_never_enters_a_minimum) {
    const bmr_vec32 corners[MOST] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    const bmr_vec32 normals[MOST] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const bmr_polygon32 square = {corners, normals, 4};
    const bmr_transform32 still = {{0, 0}, 0, 1};
    bmr_vec32 points[MOST] = {{5, 0}, {NAN, 0}, {4, NAN}, {7, 0}, {NAN, NAN}, {6, 0}, {9, 0}, {8, 0}};
    const bmr_polygon32 other = {points, normals, MOST};
    assert_true(bmr_exact32_edge_separation(&square, 0, &other, &still) == 4.0f);
    for (int i = 0; i < MOST; ++i)
        points[i].x = NAN;
    assert_true(bmr_exact32_edge_separation(&square, 0, &other, &still) == FLT_MAX);
    int32_t edge = -1;
    assert_true(bmr_exact32_max_separation(&square, &other, &still, &edge) == FLT_MAX);
    assert_int_equal(edge, 0);
}

// --- polygons of any size ---

TEST(big_polygons_have_the_bits_of_plain_c) {
    test_random d = test_random_from(13);
    const size_t rounds = test_scaled(20000);
    size_t apart = 0, touching = 0;
    for (size_t round = 0; round < rounds; ++round) {
        bmr_convex32_block *const a = random_convex32(&d, random_kind(&d), 3 + test_random_below(&d, 60)),
                                  *const b =
                                      random_convex32(&d, random_kind(&d), 3 + test_random_below(&d, 60));
        const bmr_transform32 pose_a = random_pose32(&d, 20.0);
        bmr_convex32_memory memory = {0, 0, 0, 0}, plain_memory = memory;
        bmr_transform32 pose_b = pose_against(&d, &a->polygon, &pose_a, &b->polygon, 0.02);
        for (int step = 0; step < 4; ++step, pose_b = moved_a_little(&d, &pose_b, 0.01)) {
            const bool is = bmr_convex32_apart(&a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, &memory);
            assert_int_equal(is, test_plain_convex32_apart(&a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f,
                                                           &plain_memory));
            assert_memory_equal(&memory, &plain_memory, sizeof memory);
            bmr_manifold32 manifold, plain;
            memset(&manifold, 0x5a, sizeof manifold);
            memset(&plain, 0x5a, sizeof plain);
            bmr_convex32_memory of_collision = memory, plain_of_collision = memory;
            bmr_convex32_collide(&manifold, &a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, 0.0005f,
                                 &of_collision);
            test_plain_convex32_collide(&plain, &a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, 0.0005f,
                                        &plain_of_collision);
            assert_true(same_words(&manifold, &plain, sizeof plain));
            assert_memory_equal(&of_collision, &plain_of_collision, sizeof memory);
            apart += is;
            touching += manifold.count > 0;
        }
        bmr_convex32_destroy(a, NULL);
        bmr_convex32_destroy(b, NULL);
    }
    assert_true(apart > rounds / 4 && touching > rounds / 4);
}
