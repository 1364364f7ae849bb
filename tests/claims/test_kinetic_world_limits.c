// SPDX-License-Identifier: MIT
// Where kinetic worlds come to their limits: each ends in what was right, or in an error that says what and
// who, and none of them in a wrong answer or in a loop.
#include "world/parts.h"
#include "world_stage.h"

static void assert_trouble(const stage *s, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b) {
    const bmr_world_trouble trouble = bmr_world_get_trouble(s->world);
    assert_int_equal(trouble.error, error);
    assert_int_equal(trouble.kind, kind);
    assert_int_equal(trouble.a, a);
    assert_int_equal(trouble.b, b);
    assert_true(error == BMR_OK || trouble.time == bmr_world_time(s->world));
}

static void assert_refused(const stage *s, double until, bmr_trouble kind, bmr_body a, bmr_body b) {
    assert_int_equal(bmr_world_advance(s->world, until), BMR_ERROR_OUT_OF_RANGE);
    assert_trouble(s, BMR_ERROR_OUT_OF_RANGE, kind, a, b);
}

// ---- walls and boxes ----

/// Only some thousand margins wide, as walls were once, and as wide as a box may be.
TEST(a_ball_bounces_in_a_box_of_any_width) {
    const bmr_polygon *b = box(1.0);
    const double sizes[] = {10.0, 1e4, 1e6, 2e8};
    for (size_t i = 0; i < COUNT_OF(sizes); i++) {
        own_stage *s = make_stage(BMR_WALLED, sizes[i]);
        // In a corner, far from the middles of the walls that it meets.
        const double x = sizes[i] - 3.0, y = 2.5 - sizes[i];
        const bmr_body ball = fly(s, b, x, y, 1.0, -0.5, 0.0);
        advance(s, 10.0);
        assert_int_equal(s->count, 2);
        assert_near(s->contacts[0].time, 2.0, 2.0 * MARGIN + 1e-15 * sizes[i]);
        assert_near(s->contacts[1].time, 3.0, 4.0 * MARGIN + 1e-15 * sizes[i]);
        for (size_t k = 0; k < 2; k++) {
            assert_true(s->contacts[k].b == BMR_WALL(1) || s->contacts[k].b == BMR_WALL(2));
            assert_near(s->contacts[k].distance, MARGIN, 1e-9);
            // A wall rests, and what moves along it slides.
            assert_near(s->contacts[k].velocity[0].x, k == 0 ? -1.0 : 1.0, 1e-12);
            assert_near(s->contacts[k].velocity[0].y, 0.5, 1e-12);
            const double wall =
                s->contacts[k].b == BMR_WALL(1) ? s->contacts[k].points[0].x : -s->contacts[k].points[0].y;
            assert_near(wall, sizes[i], 2.0 * MARGIN + 1e-15 * sizes[i]);
        }
        assert_near(state_of(s, ball).velocity.x, -1.0, 1e-9);
        assert_near(state_of(s, ball).velocity.y, 0.5, 1e-9);
    }
}

/// So far from the origin that a rounding of a place is a 70th of the margin: contacts are as exact as near
/// it.
TEST(far_from_the_origin_contacts_are_as_exact) {
    const double far = 1e8;
    own_stage *s = make_stage(BMR_WALLED, 0.0);
    s->def.low = bmr_vec2_make(far - 6.0, -far - 6.0);
    s->def.high = bmr_vec2_make(far + 6.0, -far + 6.0);
    const bmr_polygon *b = box(1.0);
    test_random random = test_random_from(8);
    for (int i = 0; i < 9; i++)
        drift(s, b, far + 3.5 * (i % 3) - 3.5, 3.5 * (i / 3) - 3.5 - far, &random);
    const double before = bmr_world_get_totals(s->world).energy;
    advance(s, 30.0);
    assert_true(s->count > 100 && s->count < MOST);
    for (size_t i = 0; i < s->count; i++)
        if (s->contacts[i].again == 0)
            assert_near(s->contacts[i].distance, MARGIN, 2e-9);
    assert_near(bmr_world_get_totals(s->world).energy, before, 1e-12 * before);
}

/// Of each two bodies one image is a pair, in a box a hundred times as long as high, too.
TEST(all_pairs_of_a_long_box_are_all) {
    enum { BODIES = 40 };
    const bmr_polygon *b = box(0.5);
    stage *runs[2];
    for (int all = 0; all < 2; all++) {
        stage *s = runs[all] = make_stage(BMR_PERIODIC, 0.0);
        s->def.low = bmr_vec2_make(-400.0, -4.0);
        s->def.high = bmr_vec2_make(400.0, 4.0);
        s->def.all_pairs = all;
        test_random random = test_random_from(3);
        for (int i = 0; i < BODIES; i++)
            fly(s, b, 20.0 * i - 400.0, test_random_uniform(&random, -4.0, 4.0),
                test_random_uniform(&random, -9.0, 9.0), test_random_uniform(&random, -9.0, 9.0),
                test_random_uniform(&random, -1.0, 1.0));
        for (int i = 1; i <= 5; i++) {
            advance(s, 10.0 * i);
            if (all)
                assert_int_equal(bmr_world_get_counts(s->world).pairs, BODIES * (BODIES - 1) / 2);
        }
    }
    assert_true(runs[0]->count > 50 && runs[0]->count == runs[1]->count);
    for (size_t i = 0; i < runs[0]->count; i++)
        assert_memory_equal(&runs[0]->contacts[i].time, &runs[1]->contacts[i].time, sizeof(double));
    close_stage(runs[0]);
    close_stage(runs[1]);
}

/// A point in a box of 1e21 of its cells: none of their numbers overflows, and it meets what is there.
TEST(a_point_in_a_huge_periodic_box_meets_what_is_there) {
    const bmr_vec2 origin = {0.0, 0.0};
    own_polygon *point = made_polygon(&origin, 1);
    const bmr_polygon *b = box(1e-3);
    for (int all = 0; all < 2; all++) {
        own_stage *s = make_stage(BMR_PERIODIC, 2e8);
        s->def.kds.margin = s->def.kds.hysteresis = 1e-11;
        s->def.all_pairs = all;
        for (int i = 0; i < 3; i++)
            add_piece(s, point, flight(0.0, 1e-3 * (i + 2), 0.0, 0.0, 0.0, 0.0), 1.0);
        add_piece(s, b, flight(0.0, -0.5, 0.0, 1.0, 0.0, 0.0), 1e6);
        assert_int_equal(bmr_world_audit(s->world), BMR_OK);
        advance(s, 1.0);
        assert_true(s->count >= 3);
        assert_near(s->contacts[0].time, 0.501, 1e-9);
    }
}

// ---- the clock ----

static bmr_polygon *segment(double half) {
    const bmr_vec2 points[2] = {{0.0, -half}, {0.0, half}};
    return made_polygon(points, 2);
}

/// What is as thin as the margin, at a speed at which failure.tolerance is hundreds of margins' way.
TEST(nobody_is_missed_who_is_faster_than_the_tolerance) {
    enum { PLATES = 200 };
    own_polygon *plate = segment(1.0), *needle = segment(0.5);
    for (int spins = 0; spins < 2; spins++) {
        own_stage *s = make_passing_stage();
        s->def.failure.tolerance = 1e-9;
        for (int i = 0; i < PLATES; i++)
            add_piece(s, plate, flight(0.0, 5.0 * i, 0.0, 0.0, 0.0, spins ? 1e-3 : 0.0), 1.0);
        add_piece(s, needle, flight(0.0, -1e6, 0.1, 1e6, 0.0, 0.0), 1.0);
        advance(s, 1.1);
        assert_int_equal(s->count, PLATES);
    }
}

/// Where no time lies between the two sides of a contact. (Near time 0 it does, however fast they are:
/// test_kinetic_world_cases.c.)
TEST(who_is_faster_than_the_clock_is_an_error) {
    const bmr_polygon *b = box(0.5);
    for (int grid = 0; grid < 2; grid++) {
        own_stage *s = make_stage(BMR_OPEN, 0.0);
        s->def.all_pairs = !grid;
        assert_int_equal(bmr_world_create(&s->def, 1e6, NULL, &s->world), BMR_OK);
        const bmr_body fast = add_piece(s, b, flight(1e6, -3e6, 0.0, 3e6, 0.0, 0.0), 0.0);
        const bmr_body rests = add_piece(s, b, flight(1e6, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0);
        assert_refused(s, 1e6 + 2.0, BMR_TROUBLE_SPEED, fast, rests);
        assert_near(bmr_world_time(s->world), 1e6 + 1.0, 1e-5);
        // It is so until one of them is gone, or slower.
        assert_int_equal(bmr_world_advance(s->world, 1e6 + 2.0), BMR_ERROR_OUT_OF_RANGE);
        send(s, fast, 10.0, 0.0, 0.0);
        advance(s, 1e6 + 2.0);
        assert_int_equal(s->count, 1);
        assert_trouble(s, BMR_OK, BMR_TROUBLE_NONE, BMR_NO_BODY, BMR_NO_BODY);
    }
}

/// With a margin that is wide beside the rounding of curves; and no pair may have events for ever.
static stage *make_curves_stage(void) {
    stage *s = make_passing_stage();
    s->def.kds.margin = 1e-4;
    s->def.most_events = 1000;
    return s;
}

static bmr_motion_piece curve(double time, bmr_vec2 quadratic, double cubic) {
    return test_algebraic(time, (bmr_algebraic_piece){.degree = cubic != 0.0 ? 3 : 2,
                                                      .x = {0.0, 0.0, quadratic.x, cubic},
                                                      .y = {0.0, 0.0, quadratic.y}});
}

/// Beside a body that accelerates gently, at times and speeds whose product is up to 1e10: once the rounding
/// of the disks' times was that of the product, and the disks met and parted in turn for ever.
TEST(who_flies_past_a_curve_is_met_once) {
    const bmr_polygon *b = box(0.2);
    for (double time = 1e3; time < 1e6; time *= 10.0)
        for (double speed = 10.0; speed < 2e4; speed *= 10.0) {
            own_stage *s = make_curves_stage();
            assert_int_equal(bmr_world_create(&s->def, time, NULL, &s->world), BMR_OK);
            add_piece(s, b, curve(time, bmr_vec2_make(0.0, 0.5), 0.0), 0.0);
            add_piece(s, b, flight(time, -speed, 0.5, speed, 0.0, 0.0), 0.0);
            advance(s, time + 2.0);
            assert_int_equal(s->count, 1);
            assert_int_equal(s->events[BMR_WORLD_NEAR], 1);
            assert_near(s->contacts[0].time, time + 1.0, 0.41 / speed);
        }
}

/// A cube of time is so long after its epoch, and so fast then, that it passes in a part of 1e7 of the time
/// that one step of the search takes: it is met, or the clock is said to be too coarse.
TEST(who_comes_from_afar_on_a_curve_is_not_missed) {
    const bmr_polygon *b = box(30.0);
    size_t met = 0, errors = 0;
    for (double after = 100.0; after < 2e5; after *= 1.7) {
        own_stage *s = make_passing_stage();
        s->def.most_events = 1000;
        const bmr_body cubic = add_piece(s, b, curve(0.0, bmr_vec2_make(0.0, 0.0), 1.0), 0.0);
        const bmr_body target = fly(s, b, after * after * after, 0.0, 0.0, 0.0, 0.0);
        const bmr_error error = bmr_world_advance(s->world, 1.001 * after);
        if (error == BMR_OK) {
            assert_int_equal(s->count, 1);
            assert_near(s->contacts[0].time, after, 62.0 / (3.0 * after * after) + 1e-15 * after);
            met++;
        } else {
            assert_trouble(s, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_SPEED, cubic, target);
            errors++;
        }
    }
    assert_true(met > 0 && errors > 0);
}

/// Two that go nearly the same way, which is long: what they differ by in so much time as they need to meet
/// is known, and what they differ by in the far future is not asked for.
TEST(who_goes_nearly_the_same_way_is_met_in_time) {
    const bmr_polygon *b = box(0.2);
    for (double common = 1.0; common < 200.0; common *= 10.0)
        for (double apart = 1e-8; apart < 1e-3; apart *= 10.0) {
            own_stage *s = make_curves_stage();
            add_piece(s, b, curve(0.0, bmr_vec2_make(0.0, common), 0.0), 0.0);
            bmr_motion_piece other = curve(0.0, bmr_vec2_make(-apart, common), 0.0);
            other.as.algebraic.x[0] = 0.8;
            add_piece(s, b, other, 0.0);
            const double time = sqrt(0.4 / apart);
            advance(s, 1.01 * time);
            assert_int_equal(s->count, 1);
            assert_near(s->contacts[0].time, time, 0.01 * time);
        }
}

/// Who would meet when both are too far away to tell is an error when the world comes there, and no sooner:
/// it may never come there.
TEST(what_the_far_future_does_not_tell_is_no_error_today) {
    const bmr_polygon *b = box(0.2);
    own_stage *s = make_curves_stage();
    s->def.all_pairs = true;
    const bmr_body first = add_piece(s, b, curve(0.0, bmr_vec2_make(0.0, 100.0), 0.0), 0.0);
    bmr_motion_piece other = curve(0.0, bmr_vec2_make(0.0, 100.0), 0.0);
    other.as.algebraic.x[0] = 1000.0;
    other.as.algebraic.x[1] = -0.01;
    const bmr_body second = add_piece(s, b, other, 0.0);
    advance(s, 10.0);
    assert_refused(s, 1.01e5, BMR_TROUBLE_SPEED, first, second);
    assert_true(bmr_world_time(s->world) > 5e4);
}

/// Farther than there are cells: soon, however far a call is to advance.
TEST(who_flies_out_of_the_world_is_an_error) {
    const bmr_polygon *b = box(1.0);
    const double speeds[] = {1.0, 1e20, 1e96, 1e300};
    for (size_t i = 0; i < COUNT_OF(speeds); i++) {
        own_stage *s = make_stage(BMR_OPEN, 0.0);
        const bmr_body flies = fly(s, b, 0.0, 0.0, speeds[i], 0.0, 0.0);
        assert_refused(s, 1e300, BMR_TROUBLE_PLACE, flies, BMR_NO_BODY);
        assert_true(s->events[BMR_WORLD_CROSS] < 300);
    }
    // Two at rest, near each other: nothing ever happens.
    own_stage *s = make_stage(BMR_OPEN, 0.0);
    fly(s, b, 0.0, 0.0, 0.0, 0.0, 0.0);
    fly(s, b, 2.01, 0.0, 0.0, 0.0, 0.0);
    advance(s, 1e300);
    assert_int_equal(s->count, 0);
}

TEST(a_call_has_as_many_events_as_it_may) {
    own_stage *s = make_stage(BMR_WALLED, 1.2);
    s->def.most_events = 10;
    const bmr_polygon *b = box(1.0);
    fly(s, b, 0.0, 0.0, 1.0, 0.3, 0.0);
    size_t calls = 1;
    for (; bmr_world_advance(s->world, 20.0) != BMR_OK; calls++) {
        assert_trouble(s, BMR_ERROR_OUT_OF_RANGE, BMR_TROUBLE_EVENTS, BMR_NO_BODY, BMR_NO_BODY);
        assert_int_equal(bmr_world_audit(s->world), BMR_OK);
    }
    // The same contacts as in one call.
    own_stage *whole = make_stage(BMR_WALLED, 1.2);
    fly(whole, b, 0.0, 0.0, 1.0, 0.3, 0.0);
    advance(whole, 20.0);
    assert_true(calls > 5 && s->count == whole->count);
    assert_true(s->contacts[s->count - 1].time == whole->contacts[s->count - 1].time);
}

// ---- contacts that nothing ends, and short ones ----

/// Two boxes that meet flat on a stretch from a tenth down to 1e-9: what elastic impulses keep stays, to
/// rounding.
TEST(an_impulse_on_a_short_stretch_keeps_the_energy) {
    const bmr_polygon *b = box(0.5);
    size_t flat = 0;
    for (double stretch = 0.1; stretch > 1e-9; stretch *= 0.1)
        for (int turn = 0; turn < 30; turn++) {
            own_stage *s = make_stage(BMR_OPEN, 0.0);
            const bmr_pose first = bmr_pose_from_angle(bmr_vec2_make(0.0, 0.0), 0.37 * turn);
            const bmr_pose second = {bmr_rotate(&first, bmr_vec2_make(2.0, 1.0 - stretch)), first.c, first.s};
            add_piece(s, b, bmr_piece_rest(first), 0.0);
            add_piece(s, b, bmr_piece_screw(0.0, second, bmr_vec2_make(-first.c, -first.s), 0.0), 0.0);
            const bmr_world_totals before = bmr_world_get_totals(s->world);
            advance(s, 1.5);
            const bmr_world_totals after = bmr_world_get_totals(s->world);
            assert_true(s->count >= 1);
            flat += s->contacts[0].count == 2;
            assert_near(after.energy, before.energy, 1e-14);
            assert_near(after.momentum.x, before.momentum.x, 1e-14);
            assert_near(after.momentum.y, before.momentum.y, 1e-14);
            assert_near(after.angular, before.angular, 1e-14);
            // Control: something happened.
            assert_true(fabs(state_of(s, 0).spin) > 0.1);
        }
    assert_true(flat > 60);
}

/// Between two that nothing moves and that come together: no answer parts them, and who they are is said.
TEST(what_is_pushed_together_for_good_is_an_error) {
    for (bmr_zeno_policy zeno = BMR_ZENO_ERROR; zeno <= BMR_ZENO_ELASTIC; zeno++) {
        own_stage *s = make_stage(BMR_OPEN, 0.0);
        s->def.zeno = zeno;
        const bmr_polygon *b = box(1.0);
        const bmr_body left = add_piece(s, b, flight(0.0, -5.0, 0.0, 1.0, 0.0, 0.0), INFINITY);
        const bmr_body middle = add_piece(s, b, flight(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 1.0);
        const bmr_body right = add_piece(s, b, flight(0.0, 5.0, 0.0, -1.0, 0.0, 0.0), INFINITY);
        assert_int_equal(bmr_world_advance(s->world, 10.0), BMR_ERROR_STALLED);
        const bmr_world_trouble trouble = bmr_world_get_trouble(s->world);
        assert_true(trouble.kind == BMR_TROUBLE_CONTACTS || trouble.kind == BMR_TROUBLE_REPAIRS);
        assert_true(trouble.a == left || trouble.a == middle);
        assert_true(trouble.b == middle || trouble.b == right);
        assert_near(trouble.time, 3.0, 0.1);
    }
}

// ---- what a world claims ----

/// Three bodies at rest, of which the first two have a structure, and the third is a candidate of both; and
/// one that moves.
typedef struct claims {
    bmr_world_body body[3];
    bmr_body_pair near, candidate;
    bmr_event_entry first;
} claims;

TEST(an_audit_finds_every_false_claim) {
    own_stage *s = make_stage(BMR_OPEN, 0.0);
    const bmr_polygon *b = box(0.5);
    const bmr_body ids[] = {fly(s, b, 0.25, 0.25, 0.0, 0.0, 0.0), fly(s, b, 1.55, 0.25, 0.0, 0.0, 0.0),
                            fly(s, b, 0.25, 2.0, 0.0, 0.0, 0.0)};
    fly(s, b, 40.0, 40.0, 0.1, 0.0, 0.0);
    advance(s, 1.0);
    bmr_world_body *body[3];
    for (size_t i = 0; i < 3; i++)
        body[i] = bmr_world_find(s->world, ids[i]);
    bmr_body_pair *near = NULL, *candidate = NULL;
    for (bmr_body_pair *pair = body[0]->first; pair; pair = pair->after[bmr_body_pair_side(pair, body[0])])
        *(pair->side[1] == body[1] ? &near : &candidate) = pair;
    assert_true(near && near->watch == BMR_WATCH_STRUCTURE);
    assert_true(candidate && candidate->watch == BMR_WATCH_DISKS);
    bmr_event_entry *const first = s->world->queue.heap;
    const claims truth = {{*body[0], *body[1], *body[2]}, *near, *candidate, *first};
#define FINDS(error, falsify)                                                                                \
    do {                                                                                                     \
        falsify;                                                                                             \
        assert_int_equal(bmr_world_audit(s->world), error);                                                  \
        for (size_t i = 0; i < 3; i++)                                                                       \
            *body[i] = truth.body[i];                                                                        \
        *near = truth.near;                                                                                  \
        *candidate = truth.candidate;                                                                        \
        *first = truth.first;                                                                                \
        first->item->place = 0;                                                                              \
    } while (0)
    FINDS(BMR_ERROR_FALSE_CERTIFICATE, body[1]->now.piece.as.screw.start.position.x -= 0.5); // the structure
    FINDS(BMR_ERROR_FALSE_CERTIFICATE, body[2]->now.piece.as.screw.start.position.y -= 1.0); // the disks
    FINDS(BMR_ERROR_FALSE_CERTIFICATE, body[2]->column += 5);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, body[0]->pairs++);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, candidate->neighbours = false);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, candidate->image[0] = 1);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, near->watch = BMR_WATCH_DISKS);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, first->item->place++);
    FINDS(BMR_ERROR_INVALID_STRUCTURE, first->time = INFINITY);
    assert_int_equal(bmr_world_audit(s->world), BMR_OK);
}
