// SPDX-License-Identifier: MIT
// Kinetic worlds: first contacts are those that two bodies alone would have; energy and momentum stay. That
// nothing overlaps, and that contacts are those of all pairs, bit for bit: tests/random/fuzz_world.c.
#include "boomerang/distance.h"
#include "boomerang/time_of_contact.h"
#include "boomerang/world.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

#define PLAY_SHAPES 12
#define SIZE 5.0 // half the side of the square in which bodies begin

typedef struct play_shapes {
    bmr_polygon *polygons[PLAY_SHAPES];
    bmr_shape shapes[PLAY_SHAPES];
} play_shapes;

static double play_in(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

/// A point, a segment, a triangle, and polygons about their centres of mass; of radii from 0.02 to 4, and one
/// of 20.
static void play_make_shapes(play_shapes *s, test_random *random) {
    static const double sizes[PLAY_SHAPES] = {1.0, 0.5, 0.3, 0.7, 1.0, 0.02, 4.0, 1.0, 0.4, 20.0, 0.1, 0.6};
    memset(s, 0, sizeof *s);
    for (size_t i = 0; i < PLAY_SHAPES; i++) {
        bmr_vec2 points[64];
        size_t count = i == 1 ? 1 : i == 2 ? 2 : 3 + test_random_below(random, i == 3 ? 1 : 20);
        for (size_t k = 0; k < count; k++) {
            const double angle = 6.283185307179586 * ((double)k + play_in(random, -0.3, 0.3)) / (double)count;
            const double radius = sizes[i] * (count > 2 ? 1.0 : play_in(random, 0.3, 1.0));
            points[k] = bmr_vec2_make(radius * cos(angle), radius * sin(angle));
        }
        bmr_polygon *first = NULL;
        bmr_mass mass;
        if (bmr_polygon_create(points, count, NULL, &first) != BMR_OK)
            abort();
        if (bmr_polygon_mass(first, &mass) == BMR_OK) {
            count = first->count;
            for (size_t k = 0; k < count; k++)
                points[k] = bmr_sub(first->vertices[k], mass.centroid);
        }
        bmr_polygon_destroy(first, NULL);
        if (bmr_polygon_create(points, count, NULL, &s->polygons[i]) != BMR_OK)
            abort();
        s->shapes[i].polygon = s->polygons[i];
    }
}

static void play_drop_shapes(play_shapes *s) {
    for (size_t i = 0; i < PLAY_SHAPES; i++)
        bmr_polygon_destroy(s->polygons[i], NULL);
}

static bmr_pose play_place(test_random *random) {
    const bmr_vec2 at = {SIZE * play_in(random, -1.0, 1.0), SIZE * play_in(random, -1.0, 1.0)};
    return bmr_pose_from_angle(at, play_in(random, -3.0, 3.0));
}

/// A screw, with a spin or without, or an algebraic piece, from a pose at a time.
static bmr_motion_piece play_piece(test_random *random, double time, bmr_pose pose) {
    const double fast = test_random_below(random, 12) == 0 ? 30.0 : 1.5;
    const bmr_vec2 velocity = {play_in(random, -fast, fast), play_in(random, -fast, fast)};
    const uint32_t kind = test_random_below(random, 8);
    if (kind > 1)
        return bmr_piece_screw(time, pose, kind == 7 ? bmr_vec2_make(0.0, 0.0) : velocity,
                               kind > 3 ? play_in(random, -2.0, 2.0) : 0.0);
    bmr_algebraic_piece a = {.degree = 2 + test_random_below(random, 2),
                             .x = {0.0, velocity.x},
                             .y = {0.0, velocity.y},
                             .rotation_degree = kind};
    for (size_t k = 2; k <= a.degree; k++) {
        a.x[k] = play_in(random, -0.2, 0.2);
        a.y[k] = play_in(random, -0.2, 0.2);
    }
    a.b[1] = play_in(random, -0.5, 0.5);
    bmr_motion_piece piece = test_algebraic(time, a);
    test_piece_begin(&piece, time, pose);
    return piece;
}

/// One piece from there, or one with a second one after some time, which may jump.
static bmr_motion *play_motion(test_random *random, double time, bmr_pose pose) {
    bmr_motion_piece piece = play_piece(random, time, pose);
    bmr_motion *motion = NULL;
    if (bmr_motion_create(&piece, NULL, &motion) != BMR_OK)
        abort();
    for (uint32_t more = test_random_below(random, 4); more > 2; more--) {
        time += play_in(random, 0.1, 3.0);
        pose = bmr_motion_pose(motion, time, NULL, NULL);
        if (test_random_below(random, 6) == 0)
            pose = play_place(random);
        piece = play_piece(random, time, pose);
        if (bmr_motion_change(motion, time, &piece) != BMR_OK)
            abort();
    }
    return motion;
}

#define SECONDS 4.0
#define STEPS 8

// ---- contacts of two alone ----

#define CAST 16
typedef struct first_contacts {
    double time[CAST][CAST];
} first_contacts;

static bmr_response note_first(void *context, bmr_world *world, const bmr_contact *c) {
    (void)world;
    first_contacts *first = context;
    if (first->time[c->a][c->b] == INFINITY)
        first->time[c->a][c->b] = c->time;
    const bmr_response pass = {BMR_RESPONSE_PASS, 1.0};
    return pass;
}

TEST(first_contacts_are_those_of_two_bodies_alone) {
    const size_t worlds = test_scaled(40);
    test_random random = {77};
    play_shapes shapes;
    play_make_shapes(&shapes, &random);
    size_t contacts = 0, none = 0;
    for (size_t world = 0; world < worlds; world++) {
        first_contacts first;
        bmr_world_def def = bmr_default_world_def();
        def.contact = note_first;
        def.context = &first;
        bmr_world *w;
        assert_int_equal(bmr_world_create(&def, 0.0, NULL, &w), BMR_OK);
        bmr_motion *motions[CAST];
        bmr_shape own[CAST];
        for (size_t i = 0; i < CAST; i++) {
            own[i] = shapes.shapes[i % 9];
            motions[i] = play_motion(&random, 0.0, play_place(&random));
            const bmr_body_def body = bmr_default_body_def(&own[i], motions[i]);
            bmr_body id;
            assert_int_equal(bmr_world_add(w, &body, &id), BMR_OK);
            assert_int_equal(id, i);
            for (size_t k = 0; k < CAST; k++)
                first.time[i][k] = INFINITY;
        }
        assert_int_equal(bmr_world_advance(w, SECONDS), BMR_OK);
        bmr_world_destroy(w);
        for (size_t a = 0; a < CAST; a++)
            for (size_t b = a + 1; b < CAST; b++) {
                double alone;
                assert_int_equal(bmr_time_of_contact(&own[a], motions[a], &own[b], motions[b], 0.0, SECONDS,
                                                     def.kds.margin, NULL, &alone),
                                 BMR_OK);
                const double here = first.time[a][b];
                if (alone == INFINITY && here == INFINITY) {
                    none++;
                    continue;
                }
                contacts++;
                // A pair that only grazes the margin may be taken either way.
                if (!(fabs(alone - here) <= 1e-8))
                    fail_msg("world %zu: %zu and %zu touch at %.12g, alone at %.12g", world, a, b, here,
                             alone);
            }
        for (size_t i = 0; i < CAST; i++)
            bmr_motion_destroy(motions[i]);
    }
    printf("%zu pairs touch, %zu do not\n", contacts, none);
    assert_true(contacts > worlds && none > worlds);
    play_drop_shapes(&shapes);
}

// ---- conservation ----

/// side * side polygons of radius 1 at random velocities, 2.4 apart, whose contacts are elastic.
static bmr_world *make_gas(const play_shapes *shapes, int side, bmr_boundary boundary, bool all_pairs) {
    test_random random = {5};
    bmr_world_def def = bmr_default_world_def();
    def.boundary = boundary;
    def.high = bmr_vec2_make(2.4 * side, 2.4 * side);
    def.all_pairs = all_pairs;
    bmr_world *w;
    assert_int_equal(bmr_world_create(&def, 0.0, NULL, &w), BMR_OK);
    for (int i = 0; i < side * side; i++) {
        const bmr_vec2 at = {2.4 * (i % side + 0.5), 2.4 * (i / side + 0.5)};
        const bmr_vec2 velocity = {play_in(&random, -1.0, 1.0), play_in(&random, -1.0, 1.0)};
        const bmr_motion_piece piece = bmr_piece_screw(
            0.0, bmr_pose_from_angle(at, play_in(&random, -3.0, 3.0)), velocity, play_in(&random, -1.0, 1.0));
        own_motion *motion = made_motion(piece);
        const bmr_body_def body = bmr_default_body_def(&shapes->shapes[i % 3 == 0 ? 0 : 7], motion);
        bmr_body id;
        assert_int_equal(bmr_world_add(w, &body, &id), BMR_OK);
    }
    return w;
}

TEST(a_gas_keeps_its_energy_and_momentum) {
    enum { SIDE = 12 };
    const bmr_vec2 size = {2.4 * SIDE, 2.4 * SIDE};
    const double seconds = 4.0 * (double)test_scaled(10);
    test_random random = {5};
    play_shapes shapes;
    play_make_shapes(&shapes, &random);
    for (int boundary = 0; boundary < 3; boundary++) {
        own_world *w = make_gas(&shapes, SIDE, (bmr_boundary)boundary, false);
        const bmr_world_totals before = bmr_world_get_totals(w);
        for (int step = 1; step <= 4; step++) {
            assert_int_equal(bmr_world_advance(w, seconds * step / 4), BMR_OK);
            assert_int_equal(bmr_world_audit(w), BMR_OK);
        }
        const bmr_world_totals after = bmr_world_get_totals(w);
        const bmr_world_counts counts = bmr_world_get_counts(w);
        const double scale = sqrt(before.energy) * size.x * SIDE * SIDE;
        const double energy = fabs(after.energy - before.energy) / before.energy;
        const double momentum =
            hypot(after.momentum.x - before.momentum.x, after.momentum.y - before.momentum.y);
        const double angular = fabs(after.angular - before.angular);
        static const char *const names[] = {"open", "walls", "periodic"};
        printf("%s: %llu impulses, energy %.1e, momentum %.1e, angular %.1e\n", names[boundary],
               (unsigned long long)counts.impulses, energy, momentum, angular);
        assert_true(counts.impulses > 50 && counts.softened == 0);
        assert_true(energy < 1e-12);
        // Controls: walls take momentum, and a box has no centre to turn about.
        assert_true((momentum < 1e-12 * scale) == (boundary != BMR_WALLED));
        assert_true((angular < 1e-12 * scale) == (boundary == BMR_OPEN));
    }
    play_drop_shapes(&shapes);
}

/// Events and candidates of a body in a unit of time; its memory.
static void figures(const play_shapes *shapes, int side, bool all_pairs, double figure[3]) {
    own_world *w = make_gas(shapes, side, BMR_PERIODIC, all_pairs);
    assert_int_equal(bmr_world_advance(w, 2.0), BMR_OK);
    const bmr_world_counts counts = bmr_world_get_counts(w);
    uint64_t events = 0;
    for (int i = 0; i < BMR_WORLD_EVENT_KIND_COUNT; i++)
        events += counts.events[i];
    const double bodies = side * side;
    figure[0] = (double)events / (2.0 * bodies);
    figure[1] = (double)counts.pairs / bodies;
    figure[2] = (double)counts.most_bytes / bodies;
}

TEST(what_a_body_costs_does_not_grow_with_the_world) {
    test_random random = {5};
    play_shapes shapes;
    play_make_shapes(&shapes, &random);
    double few[3], many[3], all_few[3], all_many[3];
    figures(&shapes, 14, false, few);
    figures(&shapes, 28, false, many);
    printf("events %.2f and %.2f, pairs %.2f and %.2f, bytes %.0f and %.0f\n", few[0], many[0], few[1],
           many[1], few[2], many[2]);
    assert_true(fabs(many[0] / few[0] - 1.0) < 0.2);
    assert_true(many[1] < 16.0 && few[1] < 16.0); // about one body a cell, each pair once
    assert_true(many[2] / few[2] < 1.5);
    // Control: of all pairs a body has as many as there are others.
    figures(&shapes, 7, true, all_few);
    figures(&shapes, 14, true, all_many);
    assert_true(all_many[1] > 3.5 * all_few[1] && all_many[2] > 3.0 * all_few[2]);
    play_drop_shapes(&shapes);
}
