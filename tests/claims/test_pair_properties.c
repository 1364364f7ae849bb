// SPDX-License-Identifier: MIT
// Random motions of random and hard shapes, all structures: every state is re-proved from scratch at every
// step, and every answer is compared with the distance by another method.
#include "boomerang/pair.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

#define STEPS 40

/// test_distance is exact, and rounded once (test_pair_oracle.cpp).
#define ORACLE_ROUNDING 0x1p-52

#define LEAST_ROUNDS 300

/// As scaled, but enough for every control to see what it waits for.
static size_t rounds(size_t count) {
    const size_t scaled = test_scaled(count);
    return scaled > LEAST_ROUNDS ? scaled : LEAST_ROUNDS;
}

typedef struct trial {
    test_pair of;
    test_motion motion;
    double scale; ///< of the coordinates' rounding
} trial;

static trial begin(bmr_structure structure, test_motion_kind kind, size_t largest, test_random *random) {
    bmr_polygon *body[2];
    for (int side = 0; side < 2; ++side)
        body[side] = test_any_polygon(largest, random);
    trial t = {.of = test_pair_make(structure, body[0], body[1])};
    const double radius = fmax(body[0]->radius, body[1]->radius);
    bmr_pair_def *def = &t.of.def;
    def->margin = test_random_below(random, 2) ? 0.0 : radius * test_random_uniform(random, 0.0, 0.05);
    def->hysteresis = test_random_below(random, 2) ? 0.0 : radius * test_random_uniform(random, 0.0, 0.05);
    t.motion = test_motion_make(kind, body[0], body[1], random);
    t.scale = body[0]->extent + body[1]->extent;
    return t;
}

static void end(trial *t) {
    test_pair_destroy(&t->of);
}
#define own_trial OWNED(end) trial

/// One step, all that is promised about it asserted.
static void step_and_check(trial *t, const bmr_pose *q) {
    const double need =
        t->of.def.margin + (t->of.pair.state == BMR_PAIR_CONTACT ? t->of.def.hysteresis : 0.0);
    double gap;
    const bmr_answer answer = test_pair_advance(&t->of, q, &gap);
    const double truth = test_distance(t->of.shape[0].polygon, t->of.shape[1].polygon, q);
    const double rounding = ORACLE_ROUNDING * truth;
    if (answer == BMR_APART) {
        assert_int_equal(t->of.pair.state, BMR_PAIR_APART);
        assert_true(gap > need || (gap > t->of.def.margin && need > t->of.def.margin &&
                                   t->of.pair.state != BMR_PAIR_CONTACT));
        assert_true(gap <= truth + rounding);
        double quick;
        assert_true(bmr_pair_check(&t->of.pair, q, t->of.def.margin, &quick));
        assert_true(quick <= truth + rounding);
    } else {
        assert_int_equal(t->of.pair.state, BMR_PAIR_CONTACT);
        assert_true(gap == 0.0);
        assert_true(truth <= need + BMR_PAIR_SLOP * t->scale + 1e-6 * need + rounding);
    }
    assert_int_equal(test_pair_audit(&t->of, q), BMR_OK);
}

/// Audits reject the pair with something wrong, each time something else, which `tampered` counts.
static void tamper(const trial *t, const bmr_pose *q, test_random *random, size_t tampered[7]) {
    const bmr_pair honest = t->of.pair;
    bmr_pair p = honest;
    const bmr_polygon *own = t->of.shape[honest.owner].polygon,
                      *other = t->of.shape[1 - honest.owner].polygon;
    const float size = (float)(2e-5 * t->scale);
    const bmr_pose inverse = bmr_pose_inverse(q);
    double gap = 0.0;
    assert_true(bmr_pair_check(&honest, q, t->of.def.margin, &gap));
#define REJECTED(i)                                                                                          \
    do {                                                                                                     \
        assert_int_not_equal(bmr_pair_audit(&p, &t->of.def, &t->of.shape[0], &t->of.shape[1], q), BMR_OK);   \
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
        return;
    }
    p.certificate.offset -= size;
    REJECTED(1);
    p.owner = 2;
    REJECTED(2);
    p.edge = 1000; // neither a vertex nor an edge
    REJECTED(5);
    p.owner = (uint8_t)(1 - p.owner);
    if (t->of.shape[0].polygon->count > 2 && t->of.shape[1].polygon->count > 2)
        REJECTED(2);
    p = honest;
    const bmr_pose *other_in_owner = honest.owner == 0 ? q : &inverse;
    const bmr_vec2 u = bmr_unrotate(
        other_in_owner, bmr_vec2_make((double)p.certificate.normal[0], (double)p.certificate.normal[1]));
    const double far = 2.0 * t->scale + 2.0 * gap;
    for (int w = 0; w < 2; ++w) {
        p.certificate.window[w][0] += (float)(u.x * far);
        p.certificate.window[w][1] += (float)(u.y * far);
    }
    REJECTED(3);
    // Two corners may cover all of a needle; one covers no body.
    const bool one_point =
        memcmp(p.certificate.window[0], p.certificate.window[1], sizeof p.certificate.window[0]) == 0;
    memset(p.certificate.low, 0, sizeof p.certificate.low);
    memset(p.certificate.high, 0, sizeof p.certificate.high);
    if (one_point && other->count > 1)
        REJECTED(4);
    p = honest;
    const bool lazy = t->of.def.structure < BMR_FREE_DIRECTION && !honest.free;
    if (!lazy) {
        p.edge = own->count;
        REJECTED(5);
    } else { // any other edge whose line is not the same in floats
        const bmr_hierarchy *h = t->of.shape[p.owner].hierarchies[p.structure];
        p.edge = test_random_below(random, bmr_hierarchy_edge_count(h));
        const bmr_vec2 from = bmr_hierarchy_line(h, honest.edge).normal;
        const bmr_vec2 to = bmr_hierarchy_line(h, p.edge).normal;
        if (fabs(to.x - from.x) + fabs(to.y - from.y) > 1e-6)
            REJECTED(5);
        p = honest;
    }
    p.other = lazy ? p.other_after : other->count;
    REJECTED(6);
}

static void run_motions(bmr_structure structure, size_t motions, size_t largest, uint64_t seed,
                        size_t tampered[7]) {
    test_random random = test_random_from(seed + (uint64_t)structure);
    for (size_t i = 0; i < motions; ++i) {
        own_trial t = begin(structure, (test_motion_kind)(i % TEST_MOTION_KIND_COUNT), largest, &random);
        for (int step = 0; step < STEPS; ++step) {
            const bmr_pose q = test_motion_next(&t.motion, &random);
            step_and_check(&t, &q);
            if (tampered && t.of.pair.state == BMR_PAIR_APART && test_random_below(&random, 5) == 0)
                tamper(&t, &q, &random, tampered);
        }
    }
}

TEST(every_answer_is_true_and_complete_and_every_state_re_proved_and_none_that_was_tampered_with) {
    size_t tampered[7] = {0};
    for (bmr_structure structure = 0; structure < BMR_STRUCTURE_COUNT; ++structure) {
        run_motions(structure, rounds(5600), 40, 100, tampered);
        run_motions(structure, rounds(80), 4096, 200, NULL);
    }
    for (size_t i = 0; i < COUNT_OF(tampered); ++i)
        assert_true(tampered[i] > 100);
}
