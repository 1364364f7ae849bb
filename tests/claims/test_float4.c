// SPDX-License-Identifier: MIT
// The lanes of this processor give the bits of plain C: each operation, and what is written in them. (What is
// written in them for swept shapes is in test_swept32.c.)
#include "checks.h"

#include <float.h>

#include "convex32_poses.h"
#include "plain_lanes.h"

#define FLOAT4_TABLE test_native_float4
#include "float4_operations.h"

enum { OPERATIONS_IN_ALL = sizeof test_native_float4 / sizeof test_native_float4[0] };

/// The same bits, or both no numbers.
static bool same(float a, float b) {
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static float any_bits(dice *d) {
    const uint32_t bits = dice_roll(d);
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/// Ordinary, at the ends of what floats can hold, equal to others, or any 32 bits.
static float any_float(dice *d) {
    static const float ends[] = {
        0.0f,     -0.0f,    1.0f,      -1.0f, 0x1p-149f,        -0x1p-149f, FLT_MIN, -FLT_MIN, FLT_MAX,
        -FLT_MAX, INFINITY, -INFINITY, NAN,   0x1.fffffep-127f, 3.0f,       0x1p24f, 0x1p-24f, FLT_EPSILON};
    switch (dice_below(d, 4)) {
    case 0:
        return ends[dice_below(d, sizeof ends / sizeof ends[0])];
    case 1:
        return any_bits(d);
    default:
        return (float)dice_in(d, -4.0, 4.0);
    }
}

/// In how many of so many rounds the two differ.
static size_t differences(const float4_operation *one, const float4_operation *other, size_t rounds) {
    dice d = {7};
    size_t different = 0;
    for (size_t round = 0; round < rounds; ++round) {
        float a[4], b[4], x[4] = {0}, y[4] = {0};
        for (int i = 0; i < 4; ++i) {
            a[i] = any_float(&d);
            b[i] = dice_below(&d, 6) == 0 ? a[i] : any_float(&d);
        }
        const int32_t count = (int32_t)dice_below(&d, 9);
        one->run(a, b, count, x);
        other->run(a, b, count, y);
        different += !same(x[0], y[0]) || !same(x[1], y[1]) || !same(x[2], y[2]) || !same(x[3], y[3]);
    }
    return different;
}

TEST(every_operation_has_the_bits_of_plain_c) {
    printf("lanes: %s\n", BMR_FLOAT4_NATIVE ? "the processor's" : "plain C's");
    for (int i = 0; i < OPERATIONS_IN_ALL; ++i) {
        const float4_operation *const native = &test_native_float4[i], *const plain = &test_plain_float4[i];
        assert_string_equal(native->name, plain->name);
        const size_t different = differences(native, plain, test_scaled(200000));
        if (different != 0)
            printf("%s: %zu\n", native->name, different);
        assert_int_equal(different, 0);
    }
}

/// Control: no operation passes for another.
TEST(every_operation_is_told_from_every_other) {
    for (int i = 0; i < OPERATIONS_IN_ALL; ++i)
        for (int j = 0; j < OPERATIONS_IN_ALL; ++j)
            if (i != j && differences(&test_native_float4[i], &test_plain_float4[j], 3000) == 0)
                fail_msg("%s passes for %s", test_native_float4[i].name, test_plain_float4[j].name);
}

// What a processor's own instruction may give instead.
static void min_of_numbers(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)count;
    for (int i = 0; i < 4; ++i)
        out[i] = a[i] != a[i] ? b[i] : b[i] != b[i] ? a[i] : a[i] < b[i] ? a[i] : b[i];
}
static void min_with_zeros_in_order(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)count;
    for (int i = 0; i < 4; ++i)
        out[i] = a[i] < b[i] || (a[i] == b[i] && signbit(a[i])) ? a[i] : b[i];
}
static void max_keeps_the_first(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)count;
    for (int i = 0; i < 4; ++i)
        out[i] = b[i] > a[i] ? b[i] : a[i];
}
static void sum_in_a_row(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)b, (void)count;
    out[0] = out[1] = out[2] = out[3] = ((a[0] + a[1]) + a[2]) + a[3];
}
static void quotient_by_the_inverse(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)count;
    for (int i = 0; i < 4; ++i)
        out[i] = a[i] * (1.0f / b[i]);
}
static void flushed_product(const float a[4], const float b[4], int32_t count, float out[4]) {
    (void)count;
    for (int i = 0; i < 4; ++i)
        out[i] = fabsf(a[i] * b[i]) < FLT_MIN ? copysignf(0.0f, a[i] * b[i]) : a[i] * b[i];
}

TEST(near_misses_are_seen) {
    static const float4_operation wrong[] = {
        {"min", min_of_numbers}, {"min", min_with_zeros_in_order}, {"max", max_keeps_the_first},
        {"sum", sum_in_a_row},   {"div", quotient_by_the_inverse}, {"mul", flushed_product}};
    size_t seen = 0;
    for (size_t w = 0; w < sizeof wrong / sizeof wrong[0]; ++w)
        for (int i = 0; i < OPERATIONS_IN_ALL; ++i)
            if (strcmp(test_plain_float4[i].name, wrong[w].name) == 0)
                seen += differences(&wrong[w], &test_plain_float4[i], 20000) > 0;
    assert_int_equal(seen, sizeof wrong / sizeof wrong[0]);
}

enum { MOST = 8 };

typedef struct arrays {
    bmr_vec32 vertices[MOST], normals[MOST];
} arrays;

/// `strange`: of any floats.
static bmr_polygon32 random_arrays(dice *d, arrays *memory, bool strange) {
    for (int i = 0; i < MOST; ++i) {
        const double turn = dice_in(d, 0.0, 6.3);
        memory->vertices[i] =
            (bmr_vec32){strange ? any_float(d) : (float)dice_in(d, -2.0, 2.0), (float)dice_in(d, -2.0, 2.0)};
        memory->normals[i] = (bmr_vec32){(float)cos(turn), strange ? any_float(d) : (float)sin(turn)};
    }
    const bmr_polygon32 p = {memory->vertices, memory->normals, (int32_t)(1 + dice_below(d, MOST))};
    return p;
}

/// Words that are the same bits, or no numbers.
static bool same_words(const void *a, const void *b, size_t size) {
    const float *const x = a, *const y = b;
    bool all = true;
    for (size_t i = 0; i < size / sizeof *x; ++i)
        all = all && same(x[i], y[i]);
    return all;
}

typedef float posed_form(const bmr_vec32 *, const bmr_vec32 *, const bmr_transform32 *, const bmr_vec32 *,
                         int32_t, const bmr_transform32 *);

static size_t compare_small(size_t rounds, posed_form *posed) {
    dice d = {11};
    arrays memory_a, memory_b;
    size_t different = 0;
    for (size_t round = 0; round < rounds; ++round) {
        const bool strange = round % 3 == 0;
        bmr_polygon32 a = random_arrays(&d, &memory_a, strange), b = random_arrays(&d, &memory_b, strange);
        const bmr_transform32 pose_a = random_pose32(&d, 3.0), pose_b = random_pose32(&d, 3.0),
                              frame = bmr_exact32_relative(&pose_b, &pose_a);
        const int32_t edge = (int32_t)dice_below(&d, (uint32_t)a.count);
        different += !same(posed(a.vertices + edge, a.normals + edge, &pose_a, b.vertices, b.count, &pose_b),
                           test_plain_exact32_posed_separation(a.vertices + edge, a.normals + edge, &pose_a,
                                                               b.vertices, b.count, &pose_b));
        int32_t found = -1, plain_found = -1;
        different += !same(bmr_exact32_max_separation(&a, &b, &frame, &found),
                           test_plain_exact32_max_separation(&a, &b, &frame, &plain_found));
        different += found != plain_found;
        if (a.count < 3 || b.count < 3)
            continue;
        bmr_manifold32 manifold, plain;
        memset(&manifold, 0x5a, sizeof manifold);
        memset(&plain, 0x5a, sizeof plain);
        const float radius = (float)dice_in(&d, 0.0, 2.0);
        different += bmr_exact32_collide(&manifold, &a, &pose_a, &b, &pose_b, radius, 0.0005f) !=
                     test_plain_exact32_collide(&plain, &a, &pose_a, &b, &pose_b, radius, 0.0005f);
        different += !same_words(&manifold, &plain, sizeof plain);
    }
    return different;
}

/// The largest in place of the least: the control.
static float as_seen_from_behind(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                                 const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                                 const bmr_transform32 *other) {
    const bmr_vec32 back = {-normal->x, -normal->y};
    return -bmr_exact32_posed_separation(vertex, &back, reference, points, count, other);
}

TEST(small_polygons_have_the_bits_of_plain_c) {
    assert_int_equal(compare_small(test_scaled(400000), bmr_exact32_posed_separation), 0);
    assert_true(compare_small(1000, as_seen_from_behind) > 100);
}

static size_t compare_big(size_t rounds, float reach_factor) {
    dice d = {13};
    size_t different = 0, apart = 0, touching = 0;
    for (size_t round = 0; round < rounds; ++round) {
        bmr_convex32_block *const a = random_convex32(&d, random_kind(&d), 3 + dice_below(&d, 60)),
                                  *const b = random_convex32(&d, random_kind(&d), 3 + dice_below(&d, 60));
        const bmr_transform32 pose_a = random_pose32(&d, 20.0);
        bmr_convex32_memory memory = {0, 0, 0, 0}, plain_memory = memory;
        bmr_transform32 pose_b = pose_against(&d, &a->polygon, &pose_a, &b->polygon, 0.02);
        for (int step = 0; step < 4; ++step, pose_b = moved_a_little(&d, &pose_b, 0.01)) {
            const bool is = bmr_convex32_apart(&a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, &memory);
            different += is != test_plain_convex32_apart(&a->polygon, &pose_a, &b->polygon, &pose_b,
                                                         0.02f * reach_factor, &plain_memory);
            different += memcmp(&memory, &plain_memory, sizeof memory) != 0;
            bmr_manifold32 manifold, plain;
            memset(&manifold, 0x5a, sizeof manifold);
            memset(&plain, 0x5a, sizeof plain);
            bmr_convex32_memory of_collision = memory, plain_of_collision = memory;
            bmr_convex32_collide(&manifold, &a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, 0.0005f,
                                 &of_collision);
            test_plain_convex32_collide(&plain, &a->polygon, &pose_a, &b->polygon, &pose_b, 0.02f, 0.0005f,
                                        &plain_of_collision);
            different += !same_words(&manifold, &plain, sizeof plain) ||
                         memcmp(&of_collision, &plain_of_collision, sizeof memory) != 0;
            apart += is;
            touching += manifold.count > 0;
            plain_memory = memory;
        }
        bmr_convex32_destroy(a, NULL);
        bmr_convex32_destroy(b, NULL);
    }
    assert_true(apart > rounds / 4 && touching > rounds / 4);
    return different;
}

TEST(big_polygons_have_the_bits_of_plain_c) {
    assert_int_equal(compare_big(test_scaled(20000), 1.0f), 0);
    assert_true(compare_big(500, 1.5f) > 10); // the control
}
