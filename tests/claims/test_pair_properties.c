// SPDX-License-Identifier: MIT
// Random motions of random and hard shapes, all structures: every state is re-proved from scratch at every
// step, and every answer is compared with the distance by another method.
#include "boomerang/pair.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

#define STEPS 40

/// What double rounding can do to test_distance, relative to the extents and the distance
/// (test_pair_oracle.cpp).
#define ORACLE_ROUNDING 1e-13

#define LEAST_ROUNDS 300

/// As scaled, but enough for every control to see what it waits for.
static size_t rounds(size_t count) {
    const size_t scaled = test_scaled(count);
    return scaled > LEAST_ROUNDS ? scaled : LEAST_ROUNDS;
}

typedef struct trial {
    test_body body[2];
    bmr_shape shape[2];
    bmr_pair_def def;
    bmr_pair pair;
    test_motion motion;
    double scale; ///< of the coordinates' rounding
} trial;

static bmr_polygon *random_polygon(test_random *random, size_t largest) {
    const uint32_t kind = test_random_below(random, 20);
    bmr_vec2 points[2];
    bmr_polygon *polygon = NULL;
    if (kind < 2) { // a point or a segment
        for (uint32_t i = 0; i <= kind; ++i)
            points[i] =
                bmr_vec2_make(test_random_uniform(random, -1.0, 1.0), test_random_uniform(random, -1.0, 1.0));
        assert_int_equal(bmr_polygon_create(points, kind + 1, NULL, &polygon), BMR_OK);
        return polygon;
    }
    const double n = exp(test_random_uniform(random, log(3.0), log((double)largest)));
    polygon = test_polygon((test_family)test_random_below(random, TEST_FAMILY_COUNT), (size_t)n, random);
    assert_non_null(polygon);
    return polygon;
}

/// The same polygon, scaled and away from its frame's origin.
static bmr_polygon *moved(bmr_polygon *polygon, double scale, bmr_vec2 by) {
    bmr_vec2 *points = malloc(polygon->count * sizeof *points);
    assert_non_null(points);
    for (uint32_t i = 0; i < polygon->count; ++i)
        points[i] = bmr_add(bmr_scale(scale, polygon->vertices[i]), by);
    bmr_polygon *made = made_polygon(points, polygon->count);
    free(points);
    bmr_polygon_destroy(polygon, NULL);
    return made;
}

static void begin(trial *t, bmr_structure structure, test_motion_kind kind, size_t largest,
                  test_random *random) {
    for (int side = 0; side < 2; ++side) {
        bmr_polygon *polygon = random_polygon(random, largest);
        if (test_random_below(random, 4) == 0) {
            const double scale = exp(test_random_uniform(random, log(1e-3), log(1e3)));
            const double away = scale * test_random_uniform(random, 0.0, 10.0);
            polygon = moved(polygon, scale, bmr_vec2_make(away, -away));
        }
        t->body[side] = test_body_make(polygon, structure);
        t->shape[side] = test_body_shape(&t->body[side]);
    }
    const bmr_polygon *a = t->shape[0].polygon, *b = t->shape[1].polygon;
    t->def.structure = structure;
    const double radius = fmax(a->radius, b->radius);
    t->def.margin = test_random_below(random, 2) ? 0.0 : radius * test_random_uniform(random, 0.0, 0.05);
    t->def.hysteresis = test_random_below(random, 2) ? 0.0 : radius * test_random_uniform(random, 0.0, 0.05);
    bmr_pair_init(&t->pair);
    t->motion = test_motion_make(kind, a, b, random);
    t->scale = a->extent + b->extent;
}

static void end(trial *t) {
    test_body_destroy(&t->body[0]);
    test_body_destroy(&t->body[1]);
}

/// One step, all that is promised about it asserted. The truth is returned.
static double step_and_check(trial *t, const bmr_pose *q) {
    const double need = t->def.margin + (t->pair.state == BMR_PAIR_CONTACT ? t->def.hysteresis : 0.0);
    double gap;
    const bmr_answer answer = bmr_pair_advance(&t->pair, &t->def, &t->shape[0], &t->shape[1], q, NULL, &gap);
    const double truth = test_distance(t->shape[0].polygon, t->shape[1].polygon, q);
    const double rounding = ORACLE_ROUNDING * (t->scale + truth);
    if (answer == BMR_APART) {
        assert_int_equal(t->pair.state, BMR_PAIR_APART);
        assert_true(gap > need ||
                    (gap > t->def.margin && need > t->def.margin && t->pair.state != BMR_PAIR_CONTACT));
        assert_true(gap <= truth + rounding);
        double quick;
        assert_true(bmr_pair_check(&t->pair, q, t->def.margin, &quick));
        assert_true(quick <= truth + rounding);
    } else {
        assert_int_equal(t->pair.state, BMR_PAIR_CONTACT);
        assert_true(gap == 0.0);
        assert_true(truth <= need + BMR_PAIR_SLOP * t->scale + 1e-6 * need + rounding);
    }
    const bmr_error audit = bmr_pair_audit(&t->pair, &t->def, &t->shape[0], &t->shape[1], q);
    if (audit != BMR_OK)
        fail_msg("%s, %u and %u vertices, level %d, at (%.17g, %.17g; %.17g, %.17g): the audit: %s",
                 bmr_structure_name(t->def.structure), t->shape[0].polygon->count, t->shape[1].polygon->count,
                 t->pair.level, q->position.x, q->position.y, q->c, q->s, bmr_error_describe(audit));
    return truth;
}

static void run_motions(bmr_structure structure, size_t motions, size_t largest, uint64_t seed) {
    test_random random = {seed + (uint64_t)structure};
    for (size_t i = 0; i < motions; ++i) {
        trial t;
        begin(&t, structure, (test_motion_kind)(i % TEST_MOTION_KIND_COUNT), largest, &random);
        for (int step = 0; step < STEPS; ++step) {
            const bmr_pose q = test_motion_next(&t.motion, &random);
            step_and_check(&t, &q);
        }
        end(&t);
    }
}

TEST(every_answer_is_true_and_complete_and_every_state_re_proved) {
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        run_motions((bmr_structure)structure, rounds(5600), 40, 100);
}

TEST(the_same_holds_for_up_to_4096_vertices) {
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure)
        run_motions((bmr_structure)structure, rounds(80), 4096, 200);
}

TEST(the_audit_rejects_a_tampered_pair) {
    size_t tampered[7] = {0};
    for (int structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure) {
        test_random random = {500};
        for (size_t i = 0; i < rounds(600); ++i) {
            trial t;
            begin(&t, (bmr_structure)structure, (test_motion_kind)(i % TEST_MOTION_KIND_COUNT), 40, &random);
            for (int step = 0; step < STEPS; ++step) {
                const bmr_pose q = test_motion_next(&t.motion, &random);
                step_and_check(&t, &q);
                if (t.pair.state != BMR_PAIR_APART || test_random_below(&random, 5) != 0)
                    continue;
                const bmr_pair honest = t.pair;
                bmr_pair p = honest;
                const bmr_polygon *own = t.shape[honest.owner].polygon,
                                  *other = t.shape[1 - honest.owner].polygon;
                const float size = (float)(2e-5 * t.scale);
                const bmr_pose inverse = bmr_pose_inverse(&q);
                double gap = 0.0;
                assert_true(bmr_pair_check(&honest, &q, t.def.margin, &gap));
#define REJECTED(i)                                                                                          \
    do {                                                                                                     \
        assert_int_not_equal(bmr_pair_audit(&p, &t.def, &t.shape[0], &t.shape[1], &q), BMR_OK);              \
        ++tampered[i];                                                                                       \
        p = honest;                                                                                          \
    } while (0)
                if (honest.level == BMR_LEVEL_DISKS) {
                    // Two disks of half the size cover no polygon, nor does a disk that is elsewhere cover a
                    // point.
                    p.certificate.offset *= 0.49f;
                    if (own->count > 1 && other->count > 1)
                        REJECTED(0);
                    p = honest;
                    p.certificate.normal[0] += (float)(2.0 * own->radius) + size;
                    REJECTED(0);
                    continue;
                }
                p.certificate.offset -= size;
                REJECTED(1);
                p.owner = 2;
                REJECTED(2);
                p.edge = 1000; // neither a vertex nor an edge
                REJECTED(5);
                p.owner = (uint8_t)(1 - p.owner);
                if (t.shape[0].polygon->count > 2 && t.shape[1].polygon->count > 2)
                    REJECTED(2);
                p = honest;
                const bmr_pose *other_in_owner = honest.owner == 0 ? &q : &inverse;
                const bmr_vec2 u =
                    bmr_unrotate(other_in_owner, bmr_vec2_make((double)p.certificate.normal[0],
                                                               (double)p.certificate.normal[1]));
                const double far = 2.0 * t.scale + 2.0 * gap;
                for (int w = 0; w < 2; ++w) {
                    p.certificate.window[w][0] += (float)(u.x * far);
                    p.certificate.window[w][1] += (float)(u.y * far);
                }
                REJECTED(3);
                // Two corners may cover all of a needle; one covers no body.
                const bool one_point = memcmp(p.certificate.window[0], p.certificate.window[1],
                                              sizeof p.certificate.window[0]) == 0;
                memset(p.certificate.low, 0, sizeof p.certificate.low);
                memset(p.certificate.high, 0, sizeof p.certificate.high);
                if (one_point && other->count > 1)
                    REJECTED(4);
                p = honest;
                const bool lazy = structure < BMR_FREE_DIRECTION && !honest.free;
                if (!lazy) {
                    p.edge = own->count;
                    REJECTED(5);
                } else { // any other edge whose line is not the same in floats
                    const bmr_hierarchy *h = t.shape[p.owner].hierarchies[p.structure];
                    p.edge = test_random_below(&random, bmr_hierarchy_edge_count(h));
                    const bmr_vec2 from = bmr_hierarchy_line(h, honest.edge).normal;
                    const bmr_vec2 to = bmr_hierarchy_line(h, p.edge).normal;
                    if (fabs(to.x - from.x) + fabs(to.y - from.y) > 1e-6)
                        REJECTED(5);
                    p = honest;
                }
                p.other = lazy ? p.other_after : other->count;
                REJECTED(6);
            }
            end(&t);
        }
    }
    for (size_t i = 0; i < sizeof tampered / sizeof *tampered; ++i)
        assert_true(tampered[i] > 100);
}
