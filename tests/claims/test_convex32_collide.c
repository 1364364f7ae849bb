// SPDX-License-Identifier: MIT
// Manifolds of polygons of 4,096 vertices are those of Box2D's loops over all vertices, whatever is
// remembered. (Of up to 500 vertices: random/fuzz_convex32.cpp.)
#include "checks.h"

#include "convex32/convex32_collide.h"
#include "convex32_poses.h"
#include "convex32_reference.h"

static const float skin = 0.02f, tolerance = 0.0005f;

typedef struct pair {
    const bmr_convex32 *a, *b;
    bmr_transform32 pose_a, pose_b;
    double size;
} pair;

static void check_manifold(const pair *p, bmr_convex32_memory *memory, const bmr_manifold32 *expected) {
    bmr_manifold32 got;
    memset(&got, 0, sizeof got);
    bmr_convex32_collide(&got, p->a, &p->pose_a, p->b, &p->pose_b, skin, tolerance, memory);
    assert_true(reference_same_manifold(expected, &got));
    got.points[0].point.x = nextafterf(got.points[0].point.x, INFINITY); // control: it sees one bit
    assert_true(got.count == 0 || !reference_same_manifold(expected, &got));
}

static void check_separation(const pair *p, uint32_t hint) {
    uint32_t first, edge, vertex;
    const bmr_transform32 frame = bmr_exact32_relative(&p->pose_b, &p->pose_a);
    const float expected = reference_max_separation(p->a, &p->pose_a, p->b, &p->pose_b, &first);
    const float got = bmr_convex32_max_separation(p->a, p->b, &frame, hint, &edge, &vertex);
    assert_true(expected == got && first == edge);
    assert_true(fabs(reference_true_separation(p->a, &p->pose_a, p->b, &p->pose_b) - (double)got) <=
                1e-5 * p->size);
}

/// The largest separation is a proof that is quick to find, the distance the last word.
static bool truly_apart(const pair *p, double reach) {
    return reference_true_separation(p->a, &p->pose_a, p->b, &p->pose_b) > reach ||
           reference_distance(p->a, &p->pose_a, p->b, &p->pose_b) > reach;
}

static void check_apart(const pair *p, bmr_convex32_memory *memory) {
    const bmr_convex32_memory before = *memory;
    const float reaches[] = {0.0f, 1.5f * skin, 0.3f * (float)p->size};
    for (int i = 0; i < 3; ++i) {
        *memory = before;
        if (bmr_convex32_apart(p->a, &p->pose_a, p->b, &p->pose_b, reaches[i], memory))
            assert_true(truly_apart(p, (double)reaches[i]));
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

/// Ten poses, every fifth of which begins anew. Returns in how many the two touch.
static size_t check_pair(dice *d, const bmr_convex32_block *a, const bmr_convex32_block *b) {
    pair p = {&a->polygon, &b->polygon, random_pose32(d, 10.0), {{0, 0}, 0, 0}, 0.0};
    p.size = fmax(1.0, fmax((double)a->reach, (double)b->reach));
    bmr_convex32_memory kept = {0};
    size_t touching = 0;
    for (int i = 0; i < 10; ++i) {
        if (i % 5 == 0) {
            p.pose_b = pose_against(d, p.a, &p.pose_a, p.b, (double)skin);
        } else { // a step on from the last pose
            p.pose_a = moved_a_little(d, &p.pose_a, 0.02);
            p.pose_b = moved_a_little(d, &p.pose_b, 0.02);
        }
        bmr_manifold32 expected;
        memset(&expected, 0, sizeof expected);
        reference_collide(&expected, p.a, &p.pose_a, p.b, &p.pose_b, skin, tolerance);
        touching += expected.count > 0;
        check_apart(&p, &kept);
        check_manifold(&p, &kept, &expected);
        bmr_convex32_memory other = any_memory(d), none = {0};
        check_manifold(&p, i % 2 == 0 ? &none : &other, &expected);
        check_separation(&p, dice_roll(d));
        // Big polygons that are certainly within their skins have points.
        assert_true(expected.count > 0 || (p.a->count <= 8 && p.b->count <= 8) ||
                    truly_apart(&p, (double)skin - 1e-5 * p.size));
    }
    return touching;
}

TEST(same_as_all_vertices_at_4096) {
    enum { MANY = 4096 };
    dice d = {0x5eed2u};
    size_t touching = 0;
    for (size_t pairs = 0; pairs < test_scaled(10); ++pairs) {
        bmr_convex32_block *blocks[2];
        const uint32_t small = dice_below(&d, 3); // which is; 2: neither
        for (uint32_t i = 0; i < 2; ++i) {
            const convex32_kind kind = random_kind(&d);
            blocks[i] = i == small ? random_convex32(&d, kind, 3 + dice_below(&d, 6))
                                   : random_convex32(&d, kind < KIND_BOX ? kind : KIND_REGULAR, MANY);
        }
        touching += check_pair(&d, blocks[0], blocks[1]);
        bmr_convex32_destroy(blocks[0], NULL);
        bmr_convex32_destroy(blocks[1], NULL);
    }
    assert_true(touching > 0);
}
