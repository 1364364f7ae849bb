// SPDX-License-Identifier: MIT
// Manifolds of polygons of any size are those of Box2D's loops over all vertices, whatever is remembered.
// (Of up to 500 vertices: random/fuzz_convex32.cpp.)
#include "checks.h"

#include <float.h>

#include "convex32/convex32_collide.h"
#include "convex32_poses.h"
#include "convex32_reference.h"
#include "test_scale.h"

static const float skin = 0.02f, tolerance = 0.0005f;

typedef struct tally {
    size_t poses, touching, different;
    size_t missed;       ///< no points though big polygons are certainly within their skins
    size_t off;          ///< separations that are not the true one, to 1e-5 of the shapes' size
    size_t apart, wrong; ///< looks that said apart; and were wrong
    size_t turned_over;  ///< manifolds that differ when the comparison is given one perturbed
} tally;

typedef struct pair {
    const bmr_convex32 *a, *b;
    bmr_transform32 pose_a, pose_b;
    double size;
} pair;

static void report(const char *what, const pair *p, const bmr_manifold32 *expected,
                   const bmr_manifold32 *got) {
    fprintf(stderr, "%s: %u against %u vertices, poses (%a %a %a %a) (%a %a %a %a)\n", what, p->a->count,
            p->b->count, (double)p->pose_a.p.x, (double)p->pose_a.p.y, (double)p->pose_a.s,
            (double)p->pose_a.c, (double)p->pose_b.p.x, (double)p->pose_b.p.y, (double)p->pose_b.s,
            (double)p->pose_b.c);
    const bmr_manifold32 *both[2] = {expected, got};
    for (int i = 0; i < 2; ++i)
        fprintf(stderr, "  count %d type %d normal %.9g %.9g feature %u %u\n", both[i]->count, both[i]->type,
                (double)both[i]->normal.x, (double)both[i]->normal.y, both[i]->points[0].feature.index_a,
                both[i]->points[0].feature.index_b);
}

static void check_manifold(tally *t, const pair *p, bmr_convex32_memory *memory,
                           const bmr_manifold32 *expected) {
    bmr_manifold32 got;
    memset(&got, 0, sizeof got);
    bmr_convex32_collide(&got, p->a, &p->pose_a, p->b, &p->pose_b, skin, tolerance, memory);
    if (!reference_same_manifold(expected, &got) && ++t->different <= 5)
        report("manifold", p, expected, &got);
    if (got.count > 0) {
        got.points[0].point.x = nextafterf(got.points[0].point.x, FLT_MAX);
        t->turned_over += !reference_same_manifold(expected, &got);
    }
}

static void check_separation(tally *t, const pair *p, uint32_t hint) {
    uint32_t first, edge, vertex;
    const bmr_transform32 frame = bmr_exact32_relative(&p->pose_b, &p->pose_a);
    const float expected = reference_max_separation(p->a, &p->pose_a, p->b, &p->pose_b, &first);
    const float got = bmr_convex32_max_separation(p->a, p->b, &frame, hint, &edge, &vertex);
    t->different += !(expected == got) || first != edge;
    t->off += !(fabs(reference_true_separation(p->a, &p->pose_a, p->b, &p->pose_b) - (double)got) <=
                1e-5 * p->size);
}

/// The largest separation is a proof that is quick to find, the distance the last word.
static bool truly_apart(const pair *p, double reach) {
    return reference_true_separation(p->a, &p->pose_a, p->b, &p->pose_b) > reach ||
           reference_distance(p->a, &p->pose_a, p->b, &p->pose_b) > reach;
}

static void check_apart(tally *t, const pair *p, bmr_convex32_memory *memory) {
    const bmr_convex32_memory before = *memory;
    for (int i = 0; i < 3; ++i) {
        const float reach = i == 0 ? 0.0f : i == 1 ? 1.5f * skin : 0.3f * (float)p->size;
        *memory = before;
        if (!bmr_convex32_apart(p->a, &p->pose_a, p->b, &p->pose_b, reach, memory))
            continue;
        ++t->apart;
        t->wrong += !truly_apart(p, (double)reach);
    }
}

static bmr_convex32_memory any_memory(dice *d) {
    bmr_convex32_memory m;
    m.support_a = (uint16_t)dice_roll(d);
    m.support_b = (uint16_t)dice_roll(d);
    m.axis_x = (int16_t)(dice_below(d, 65535) - 32767);
    m.axis_y = (int16_t)(dice_below(d, 65535) - 32767);
    return m;
}

static double size_of(const bmr_convex32_block *block) {
    return (double)block->reach;
}

static void check_pair(tally *t, dice *d, const bmr_convex32_block *a, const bmr_convex32_block *b,
                       int poses) {
    pair p = {&a->polygon, &b->polygon, random_pose32(d, 10.0), {{0, 0}, 0, 0}, 0.0};
    p.size = fmax(1.0, fmax(size_of(a), size_of(b)));
    bmr_convex32_memory kept;
    memset(&kept, 0, sizeof kept);
    for (int i = 0; i < poses; ++i, ++t->poses) {
        if (i % 5 == 0) {
            p.pose_b = pose_against(d, p.a, &p.pose_a, p.b, (double)skin);
        } else { // a step on from the last pose
            p.pose_a = moved_a_little(d, &p.pose_a, 0.02);
            p.pose_b = moved_a_little(d, &p.pose_b, 0.02);
        }
        bmr_manifold32 expected;
        memset(&expected, 0, sizeof expected);
        reference_collide(&expected, p.a, &p.pose_a, p.b, &p.pose_b, skin, tolerance);
        t->touching += expected.count > 0;
        bmr_convex32_memory zero, any = any_memory(d);
        memset(&zero, 0, sizeof zero);
        check_apart(t, &p, &kept);
        check_manifold(t, &p, &kept, &expected);
        check_manifold(t, &p, i % 2 == 0 ? &zero : &any, &expected);
        check_separation(t, &p, dice_roll(d));
        if (expected.count == 0 && (p.a->count > 8 || p.b->count > 8))
            t->missed += !truly_apart(&p, (double)skin - 1e-5 * p.size);
    }
}

TEST(same_as_all_vertices_at_4096) {
    enum { MANY = 4096 };
    const size_t poses = test_scaled(100);
    tally t;
    memset(&t, 0, sizeof t);
    dice d = {0x5eed2u};
    while (t.poses < poses) {
        bmr_convex32_block *blocks[2];
        const uint32_t small = dice_below(&d, 3); // which is; 2: neither
        for (uint32_t i = 0; i < 2; ++i) {
            const convex32_kind kind = random_kind(&d);
            blocks[i] = i == small ? random_convex32(&d, kind, 3 + dice_below(&d, 6))
                                   : random_convex32(&d, kind < KIND_BOX ? kind : KIND_REGULAR, MANY);
        }
        check_pair(&t, &d, blocks[0], blocks[1], 10);
        bmr_convex32_destroy(blocks[0], NULL);
        bmr_convex32_destroy(blocks[1], NULL);
    }
    printf("%zu poses, %zu touching, %zu looks said apart\n", t.poses, t.touching, t.apart);
    assert_int_equal(t.different, 0);
    assert_int_equal(t.off, 0);
    assert_int_equal(t.wrong, 0);
    assert_int_equal(t.missed, 0);
    assert_true(t.touching > 0 && t.turned_over >= t.touching); // control: the comparison sees one bit
}
