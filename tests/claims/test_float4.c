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

/// In how many of so many rounds the two differ.
static size_t differences(const float4_operation *one, const float4_operation *other, size_t rounds) {
    test_random d = test_random_from(7);
    size_t different = 0;
    for (size_t round = 0; round < rounds; ++round) {
        float a[4], b[4], x[4] = {0}, y[4] = {0};
        for (int i = 0; i < 4; ++i) {
            a[i] = any_float(&d);
            b[i] = test_random_below(&d, 6) == 0 ? a[i] : any_float(&d);
        }
        const int32_t count = (int32_t)test_random_below(&d, 9);
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

typedef float posed_form(const bmr_vec32 *, const bmr_vec32 *, const bmr_transform32 *, const bmr_vec32 *,
                         int32_t, const bmr_transform32 *);
typedef float max_form(const bmr_polygon32 *, const bmr_polygon32 *, const bmr_transform32 *, int32_t *);

typedef struct tally {
    size_t edges, edges_different, maxima, maxima_different, plain_different;
} tally;

/// The first of the largest, or the last.
static float largest(const bmr_polygon32 *reference, const bmr_polygon32 *other, const bmr_transform32 *frame,
                     bool last, int32_t *edge) {
    float best = -FLT_MAX;
    *edge = 0;
    for (int32_t i = 0; i < reference->count; ++i) {
        const float s = bmr_exact32_edge_separation(reference, i, other, frame);
        if (s > best || (last && s == best)) {
            best = s;
            *edge = i;
        }
    }
    return best;
}

/// In how many answers lanes and plain C differ, in any bit.
static size_t compare_with_plain(const bmr_polygon32 *a, const bmr_transform32 *at_a, const bmr_polygon32 *b,
                                 const bmr_transform32 *at_b) {
    const bmr_transform32 frame = bmr_exact32_relative(at_b, at_a);
    size_t different = 0;
    for (int32_t e = 0; e < a->count; ++e)
        different += !same(
            bmr_exact32_posed_separation(a->vertices + e, a->normals + e, at_a, b->vertices, b->count, at_b),
            test_plain_exact32_posed_separation(a->vertices + e, a->normals + e, at_a, b->vertices, b->count,
                                                at_b));
    int32_t found = -1, plain_found = -1;
    different += !same(bmr_exact32_max_separation(a, b, &frame, &found),
                       test_plain_exact32_max_separation(a, b, &frame, &plain_found));
    different += found != plain_found;
    if (a->count < 3 || b->count < 3)
        return different;
    bmr_manifold32 manifold, plain;
    memset(&manifold, 0x5a, sizeof manifold);
    memset(&plain, 0x5a, sizeof plain);
    const float radius = random_in(0.0f, 2.0f);
    different += bmr_exact32_collide(&manifold, a, at_a, b, at_b, radius, 0.0005f) !=
                 test_plain_exact32_collide(&plain, a, at_a, b, at_b, radius, 0.0005f);
    return different + !same_words(&manifold, &plain, sizeof plain);
}

static void compare_forms(tally *t, size_t rounds, flavour kind, posed_form *posed, max_form *max) {
    arrays memory_a, memory_b;
    for (size_t round = 0; round < rounds; ++round) {
        const bmr_polygon32 a = random_arrays(&memory_a, 1 + random_below(MOST), kind);
        const bmr_polygon32 b = random_arrays(&memory_b, 1 + random_below(MOST), kind);
        const bmr_transform32 at_a = random_frame(kind), at_b = random_frame(kind),
                              frame = bmr_exact32_relative(&at_b, &at_a);
        for (int32_t e = 0; e < a.count; ++e, ++t->edges)
            t->edges_different +=
                !same_bits(posed(a.vertices + e, a.normals + e, &at_a, b.vertices, b.count, &at_b),
                           bmr_exact32_edge_separation(&a, e, &b, &frame));
        int32_t found = -1, expected = -1;
        const float value = max(&a, &b, &frame, &found);
        const float wanted = largest(&a, &b, &frame, false, &expected);
        t->maxima_different += !same_bits(value, wanted) || found != expected;
        ++t->maxima;
        t->plain_different += compare_with_plain(&a, &at_a, &b, &at_b);
    }
}

TEST(both_forms_give_the_same_bits) {
    for (flavour kind = ORDINARY; kind < FLAVOURS; ++kind) {
        tally t = {0};
        compare_forms(&t, test_scaled(300000), kind, bmr_exact32_posed_separation,
                      bmr_exact32_max_separation);
        assert_int_equal(t.edges_different, 0);
        assert_int_equal(t.maxima_different, 0);
        assert_int_equal(t.plain_different, 0);
    }
}

/// Mathematically the same, regrouped: <n, w> - <n, v> instead of <n, w - v>.
static float regrouped_edge(const bmr_vec32 *vertex, const bmr_vec32 *normal,
                            const bmr_transform32 *reference, const bmr_vec32 *points, int32_t count,
                            const bmr_transform32 *other) {
    const bmr_transform32 f = bmr_exact32_relative(other, reference);
    const bmr_vec32 m = *normal, w = *vertex;
    const bmr_vec32 n = {f.c * m.x - f.s * m.y, f.s * m.x + f.c * m.y};
    const bmr_vec32 v = {(f.c * w.x - f.s * w.y) + f.p.x, (f.s * w.x + f.c * w.y) + f.p.y};
    float least = FLT_MAX;
    for (int32_t j = 0; j < count; ++j) {
        const float s = (n.x * points[j].x + n.y * points[j].y) - (n.x * v.x + n.y * v.y);
        least = s < least ? s : least;
    }
    return least;
}

/// The last of equal maxima instead of the first.
static float last_of_equals(const bmr_polygon32 *reference, const bmr_polygon32 *other,
                            const bmr_transform32 *frame, int32_t *edge) {
    return largest(reference, other, frame, true, edge);
}

TEST(control_other_roundings_and_other_ties_are_told_apart) {
    tally regrouped = {0}, ties = {0};
    compare_forms(&regrouped, 10000, ORDINARY, regrouped_edge, bmr_exact32_max_separation);
    assert_true(regrouped.edges_different > regrouped.edges / 4);
    assert_int_equal(regrouped.maxima_different, 0);
    compare_forms(&ties, 10000, GRID, bmr_exact32_posed_separation, last_of_equals);
    assert_true(ties.maxima_different > ties.maxima / 100);
    assert_int_equal(ties.edges_different, 0);
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

static size_t compare_big(size_t rounds, float reach_factor) {
    test_random d = test_random_from(13);
    size_t different = 0, apart = 0, touching = 0;
    for (size_t round = 0; round < rounds; ++round) {
        bmr_convex32_block *const a = random_convex32(&d, random_kind(&d), 3 + test_random_below(&d, 60)),
                                  *const b =
                                      random_convex32(&d, random_kind(&d), 3 + test_random_below(&d, 60));
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
