// SPDX-License-Identifier: MIT
// Bodies in kinetic worlds that are set elsewhere: what is a jump and what goes on, near the world's origin
// and far from it; and what a pair remembers, and is told when, that is near.
#include "world_stage.h"

#define FAR 1e6

/// A grid and all pairs, to be treated alike.
typedef struct twins {
    stage *of[2];
    const bmr_polygon *polygon;
} twins;

static twins make_twins(double scale) {
    twins t = {.polygon = box(scale)};
    for (int all = 0; all < 2; all++) {
        t.of[all] = make_stage(BMR_OPEN, 0.0);
        t.of[all]->def.all_pairs = all;
        t.of[all]->response.kind = BMR_RESPONSE_PASS;
        open_stage(t.of[all]);
    }
    return t;
}

static bmr_body add_both(twins *t, bmr_motion_piece piece) {
    const bmr_body body = add_piece(t->of[0], t->polygon, piece, 0.0);
    assert_int_equal(add_piece(t->of[1], t->polygon, piece, 0.0), body);
    return body;
}

static void advance_both(twins *t, double time) {
    advance(t->of[0], time);
    advance(t->of[1], time);
}

/// As many contacts as expected, the same in both.
static void close_twins(twins *t, size_t contacts) {
    assert_int_equal(t->of[0]->count, contacts);
    assert_int_equal(t->of[1]->count, contacts);
    for (size_t i = 0; i < contacts; i++)
        assert_memory_equal(&t->of[0]->contacts[i], &t->of[1]->contacts[i], sizeof(bmr_contact));
    close_stage(t->of[0]);
    close_stage(t->of[1]);
}

/// Who comes down on the body, when it is asked where that is.
static void drop_one_on(twins *t, bmr_body body, double height) {
    const bmr_body_state state = state_of(t->of[0], body);
    const double now = bmr_world_time(t->of[0]->world);
    add_both(t, flight(now, state.pose.position.x, state.pose.position.y + height, 0.0, -height, 0.0));
    advance_both(t, now + 2.0);
}

/// Set aside by a little, again and again: by a jump each time, or by roundings, of which many are a cell.
TEST(who_creeps_is_in_its_cell) {
    static const struct {
        double scale, step;
        int steps;
        bool jumps;
    } cases[] = {{0.07, 1e-3, 300, true},
                 {7e-3, -1e-3, 300, true},
                 {7e-6, 1.9e-3, 2, true},
                 {1e-4, -0.9e-8, 20000, false},
                 {1e-4, 0.9e-8, 20000, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        twins t = make_twins(cases[k].scale);
        bmr_body body = add_both(&t, flight(0.0, FAR, FAR, 0.0, 0.0, 0.0));
        // From a side of its cell.
        const bmr_body_state first = state_of(t.of[0], body);
        const double x = cases[k].step > 0.0 ? first.cell_high.x - 2e-8 : first.cell_low.x + 2e-8;
        for (int all = 0; all < 2; all++) {
            stage *s = t.of[all];
            const uint64_t before = bmr_world_get_counts(s->world).replanned;
            for (int i = 1; i <= cases[k].steps; i++) {
                const bmr_motion_piece rest = flight(0.0, x + i * cases[k].step, FAR, 0.0, 0.0, 0.0);
                assert_int_equal(bmr_world_set_piece(s->world, body, &rest), BMR_OK);
                if (i % 100 == 0)
                    advance(s, 1e-4 * i);
            }
            const uint64_t replanned = bmr_world_get_counts(s->world).replanned - before;
            assert_int_equal(replanned, cases[k].jumps ? 0 : cases[k].steps - 1);
        }
        if (!cases[k].jumps)
            assert_true(t.of[0]->events[BMR_WORLD_CROSS] > 0);
        advance_both(&t, 3.0);
        drop_one_on(&t, body, 50.0 * cases[k].scale);
        assert_true(t.of[0]->count == 0 || !t.of[0]->contacts[0].placed);
        close_twins(&t, 1);
    }
}

/// A rounding of a long way is more than a cell of a small body.
TEST(a_rounding_may_lead_beyond_the_hysteresis) {
    twins t = make_twins(1e-6);
    // It comes from 1e9, turns at time 0, and goes there again.
    const bmr_algebraic_piece bend = {.degree = 2, .x = {1e9, -2e9, 1e9}};
    const bmr_body body = add_both(&t, test_algebraic(-1.0, bend));
    const bmr_motion_piece rest = flight(0.0, -1e-5, 0.0, 0.0, 0.0, 0.0);
    for (int all = 0; all < 2; all++) {
        const uint64_t before = bmr_world_get_counts(t.of[all]->world).replanned;
        assert_int_equal(bmr_world_set_piece(t.of[all]->world, body, &rest), BMR_OK);
        assert_int_equal(bmr_world_get_counts(t.of[all]->world).replanned - before, 1);
    }
    advance_both(&t, 1.0);
    const bmr_body_state after = state_of(t.of[0], body);
    assert_true(after.cell_low.x <= -1e-5 && after.cell_high.x >= -1e-5);
    drop_one_on(&t, body, 1e-4);
    close_twins(&t, 1);
}

/// The way of a plan whose pieces do not quite meet, past bodies that rest.
TEST(a_plan_may_have_gaps) {
    enum { PIECES = 60, RESTING = 6 };
    const double gaps[] = {1e-3, 1e-5, 1e-8};
    for (size_t k = 0; k < sizeof gaps / sizeof *gaps; k++) {
        twins t = make_twins(5e-3);
        for (int i = 0; i < RESTING; i++)
            add_both(&t, flight(0.0, FAR + 0.1 * (i + 1) - 0.004, FAR + 0.009, 0.0, 0.0, 0.0));
        bmr_motion_piece piece = flight(0.0, FAR, FAR, 0.1, 0.0, 0.0);
        bmr_motion *motion = made_motion(piece);
        for (int i = 1; i < PIECES; i++) {
            piece = flight(0.1 * i, FAR + 0.01 * i, FAR + (i % 2 ? gaps[k] : 0.0), 0.1, 0.0, 0.0);
            assert_int_equal(bmr_motion_change(motion, 0.1 * i, &piece), BMR_OK);
        }
        const bmr_shape shape = {.polygon = t.polygon};
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body body;
        for (int all = 0; all < 2; all++)
            assert_int_equal(bmr_world_add(t.of[all]->world, &def, &body), BMR_OK);
        bmr_motion_destroy(motion);
        for (int i = 1; i <= 70; i++)
            advance_both(&t, 0.1 * i);
        assert_true(t.of[0]->count >= RESTING);
        close_twins(&t, t.of[0]->count);
    }
}

/// Into another one by a thousandth: put there, wherever that is.
TEST(who_is_put_into_another_is_placed) {
    const double places[] = {0.0, FAR};
    for (int i = 0; i < 2; i++) {
        twins t = make_twins(1.0);
        for (int all = 0; all < 2; all++)
            t.of[all]->response.kind = BMR_RESPONSE_IMPULSE;
        add_both(&t, flight(0.0, places[i], 0.0, 0.0, 0.0, 0.0));
        const bmr_body body = add_both(&t, flight(0.0, places[i] + 2.0005, 0.0, 0.0, 0.0, 0.0));
        advance_both(&t, 1.0);
        const bmr_motion_piece inside = flight(1.0, places[i] + 1.9995, 0.0, 0.0, 0.0, 0.0);
        for (int all = 0; all < 2; all++)
            assert_int_equal(bmr_world_set_piece(t.of[all]->world, body, &inside), BMR_OK);
        advance_both(&t, 2.0);
        assert_true(t.of[0]->count == 1 && t.of[0]->contacts[0].placed);
        close_twins(&t, 1);
    }
}

/// Answers go on from where the two are, turned as they are, far away and long after they began.
TEST(an_answer_is_no_jump) {
    const double places[] = {0.0, FAR, 1e8};
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        twins t = make_twins(1.0);
        const bmr_algebraic_piece turning = {.degree = 3,
                                             .x = {places[i] - 5.0 * 50.0 - 4.0, 5.0},
                                             .y = {places[i], 0.0, 0.0, 1e-7},
                                             .rotation_degree = 2,
                                             .a = {1.0, 0.0, 0.01},
                                             .b = {0.0, 0.03}};
        for (int all = 0; all < 2; all++)
            t.of[all]->response = (bmr_response){BMR_RESPONSE_IMPULSE, 1.0};
        add_both(&t, test_algebraic(-50.0, turning));
        add_both(&t, flight(-70.0, places[i], places[i] - 70.0 * 0.01, 0.0, 0.01, 0.7));
        advance_both(&t, 3.0);
        assert_true(t.of[0]->count >= 1 && !t.of[0]->contacts[0].placed);
        assert_int_equal(bmr_world_get_counts(t.of[1]->world).candidates, 1);
        close_twins(&t, t.of[0]->count);
    }
}

/// A hysteresis longer than disks overlap: the pair remembers its contact until it was apart by that.
TEST(a_long_hysteresis_is_kept) {
    for (int k = 0; k < 8; k++) {
        const bool kept = k & 1, pass = k & 2, curved = k & 4;
        const bmr_polygon *b = box(1.0);
        own_stage *s = make_stage(BMR_OPEN, 0.0);
        s->def.kds.hysteresis = kept ? 5.0 : 1.0;
        s->response.kind = pass ? BMR_RESPONSE_PASS : BMR_RESPONSE_MINE;
        fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
        // Inwards to where they touch, out to 2.5 apart, and back.
        bmr_motion_piece piece = flight(0.0, 3.0, 0.0, -1.0, 0.0, 0.0);
        bmr_motion *motion = made_motion(piece);
        const double turn = 1.0 - 0.75 * MARGIN, place = 3.0 - turn;
        piece = flight(turn, place, 0.0, 1.0, 0.0, 0.0);
        if (curved)
            piece = test_algebraic(turn, (bmr_algebraic_piece){.degree = 2, .x = {place, 2.0, -0.4}});
        assert_int_equal(bmr_motion_change(motion, turn, &piece), BMR_OK);
        if (!curved) {
            piece = flight(turn + 2.5, place + 2.5, 0.0, -1.0, 0.0, 0.0);
            assert_int_equal(bmr_motion_change(motion, turn + 2.5, &piece), BMR_OK);
        }
        const bmr_shape shape = {.polygon = b};
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body body;
        assert_int_equal(bmr_world_add(s->world, &def, &body), BMR_OK);
        bmr_motion_destroy(motion);
        advance(s, turn + 5.0 + (curved ? 0.2 : 0.4) * MARGIN); // the curve comes back at -2
        assert_int_equal(s->events[BMR_WORLD_LEAVE], pass && !kept ? 1 : 0);
        if (pass)
            assert_int_equal(s->count, kept ? 1 : 2);
        if (!pass || !kept)
            assert_int_equal(s->contacts[1].again, kept ? 1 : 0);
    }
}

/// A motion that begins a few margins before its contact, so fast that this is little beside the rounding of
/// a polynomial: the contact is reported within the margin all the same.
TEST(a_fast_contact_is_not_early) {
    const double margin = 1.5e-5, now = 458.25, speed = 4.2e5;
    for (int k = 0; k <= 40; k++) {
        const bmr_polygon *b = box(10.0);
        own_stage *s = make_passing_stage();
        s->def.kds.margin = s->def.kds.hysteresis = margin;
        assert_int_equal(bmr_world_create(&s->def, now, NULL, &s->world), BMR_OK);
        bmr_algebraic_piece turning = {.rotation_degree = 4, .b = {0.0, 0.17, 0.0, 0.0, 1.0}};
        add_piece(s, b, test_algebraic(now, turning), 0.0);
        turning.degree = 1;
        turning.x[0] = 20.0 + margin * (1.0 + 0.05 * k);
        turning.x[1] = -speed;
        add_piece(s, b, test_algebraic(now, turning), 0.0);
        assert_int_equal(bmr_world_advance(s->world, now + 1e-8), BMR_OK);
        assert_int_equal(s->count, 1);
        assert_true(s->contacts[0].distance < 1.25 * margin && s->contacts[0].distance > 0.5 * margin);
    }
}

/// Steps of a look at a pair that passes are no shorter than what times are known to.
TEST(a_contact_step_has_a_least) {
    bmr_world *world;
    bmr_world_def def = bmr_default_world_def();
    def.contact_step = 1000.0 * def.failure.tolerance;
    assert_int_equal(bmr_world_create(&def, 0.0, NULL, &world), BMR_OK);
    bmr_world_destroy(world);
    def.contact_step = 999.0 * def.failure.tolerance;
    assert_int_equal(bmr_world_create(&def, 0.0, NULL, &world), BMR_ERROR_OUT_OF_RANGE);
}
