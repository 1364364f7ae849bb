// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_WORLD_PLAY_H
#define BMR_TEST_WORLD_PLAY_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "boomerang/distance.h"
#include "boomerang/world.h"
#include "motions.h"
#include "polygons.h"

/// @file
/// Random kinetic worlds, played from a seed: bodies of all sizes and motions, added, removed and sent
/// another way, between advances and inside of contacts, which are answered in every way. What is played
/// depends on the seed and on the contacts so far alone. In C only.

#define PLAY_SHAPES 12
#define PLAY_MOST_CONTACTS 20000

typedef struct play_shapes {
    bmr_polygon *polygons[PLAY_SHAPES];
    bmr_shape shapes[PLAY_SHAPES];
} play_shapes;

/// One contact, as numbers to be compared bit for bit.
typedef struct play_contact {
    bmr_body a, b;
    uint64_t count, flags;
    double numbers[16];
} play_contact;

typedef struct play {
    test_random random; ///< of what is played between advances
    test_random inner;  ///< of what contacts are answered with
    const play_shapes *shapes;
    bmr_world *world;
    bool all_pass; ///< every contact is answered with PASS, and nothing changes inside
    bmr_boundary boundary;
    double size;    ///< half the side of where bodies begin
    bmr_vec2 place; ///< .. and its middle
    size_t stalls;  ///< advances that ended with STALLED
    bmr_error error;
    size_t contact_count;
    play_contact *contacts; ///< NULL: not kept
    double last_time;
    size_t out_of_order;
} play;

static inline double play_in(test_random *random, double low, double high) {
    return test_random_uniform(random, low, high);
}

/// A point, a segment, a triangle, and polygons about their centres of mass; of radii from 0.02 to 4, and one
/// of 20.
static inline void play_make_shapes(play_shapes *s, test_random *random) {
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

static inline void play_drop_shapes(play_shapes *s) {
    for (size_t i = 0; i < PLAY_SHAPES; i++)
        bmr_polygon_destroy(s->polygons[i], NULL);
}

static inline bmr_pose play_place(const play *p, test_random *random) {
    const bmr_vec2 at = {p->place.x + p->size * play_in(random, -1.0, 1.0),
                         p->place.y + p->size * play_in(random, -1.0, 1.0)};
    return bmr_pose_from_angle(at, play_in(random, -3.0, 3.0));
}

/// A screw, with a spin or without, or an algebraic piece, from a pose at a time.
static inline bmr_motion_piece play_piece(test_random *random, double time, bmr_pose pose) {
    const double fast = test_random_below(random, 12) == 0 ? 30.0 : 1.5;
    const bmr_vec2 velocity = {play_in(random, -fast, fast), play_in(random, -fast, fast)};
    const uint32_t kind = test_random_below(random, 8);
    if (kind > 1)
        return bmr_piece_screw(time, pose, kind == 7 ? bmr_vec2_make(0.0, 0.0) : velocity,
                               kind > 3 ? play_in(random, -2.0, 2.0) : 0.0);
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = time;
    bmr_algebraic_piece *a = &piece.as.algebraic;
    a->degree = 2 + test_random_below(random, 2);
    a->x[0] = pose.position.x;
    a->y[0] = pose.position.y;
    a->x[1] = velocity.x;
    a->y[1] = velocity.y;
    for (size_t k = 2; k <= a->degree; k++) {
        a->x[k] = play_in(random, -0.2, 0.2);
        a->y[k] = play_in(random, -0.2, 0.2);
    }
    a->rotation_degree = kind;
    a->a[0] = 1.0;
    a->b[1] = play_in(random, -0.5, 0.5);
    a->start_c = pose.c;
    a->start_s = pose.s;
    return piece;
}

/// One piece from there, or one with a second one after some time, which may jump.
static inline bmr_motion *play_motion(const play *p, test_random *random, double time, bmr_pose pose) {
    bmr_motion_piece piece = play_piece(random, time, pose);
    bmr_motion *motion = NULL;
    if (bmr_motion_create(&piece, NULL, &motion) != BMR_OK)
        abort();
    for (uint32_t more = test_random_below(random, 4); more > 2; more--) {
        time += play_in(random, 0.1, 3.0);
        pose = bmr_motion_pose(motion, time, NULL, NULL);
        if (test_random_below(random, 6) == 0)
            pose = play_place(p, random);
        piece = play_piece(random, time, pose);
        if (bmr_motion_change(motion, time, &piece) != BMR_OK)
            abort();
    }
    return motion;
}

static inline void play_note(play *p, bmr_error error) {
    if (error != BMR_OK && p->error == BMR_OK)
        p->error = error;
}

static inline void play_add(play *p, test_random *random) {
    const uint32_t pick = test_random_below(random, 40);
    const size_t shape = pick == 0 ? 9 : pick % 9 + (pick % 9 == 6 && pick > 10 ? 1 : 0);
    bmr_motion *motion = play_motion(p, random, bmr_world_time(p->world), play_place(p, random));
    bmr_body_def def = bmr_default_body_def(&p->shapes->shapes[shape], motion);
    if (test_random_below(random, 10) == 0)
        def.mass = def.inertia = INFINITY;
    bmr_body body;
    const bmr_error error = bmr_world_add(p->world, &def, &body);
    if (error != BMR_ERROR_OUT_OF_RANGE || p->boundary != BMR_PERIODIC) // too large for the box
        play_note(p, error);
    bmr_motion_destroy(motion);
}

static inline bmr_body play_any(const play *p, test_random *random) {
    const size_t count = bmr_world_body_count(p->world);
    if (count == 0)
        return BMR_NO_BODY;
    size_t place = 0;
    bmr_body body = BMR_NO_BODY;
    for (uint32_t i = test_random_below(random, (uint32_t)count) + 1; i > 0; i--)
        body = bmr_world_next_body(p->world, &place);
    return body;
}

/// Adds, removes or redirects a body.
static inline void play_change(play *p, test_random *random) {
    const uint32_t kind = test_random_below(random, 8);
    const bmr_body body = play_any(p, random);
    if (kind == 0 || body == BMR_NO_BODY) {
        play_add(p, random);
        return;
    }
    if (kind == 1) {
        play_note(p, bmr_world_remove(p->world, body));
        return;
    }
    bmr_body_state state;
    play_note(p, bmr_world_get(p->world, body, &state));
    const bmr_pose pose = kind == 2 ? play_place(p, random) : state.pose;
    const double time = bmr_world_time(p->world);
    if (kind < 5) {
        bmr_motion *motion = play_motion(p, random, time, pose);
        play_note(p, bmr_world_set_motion(p->world, body, motion));
        bmr_motion_destroy(motion);
    } else {
        const bmr_motion_piece piece = play_piece(random, time, pose);
        play_note(p, bmr_world_set_piece(p->world, body, &piece));
    }
}

static inline void play_keep(play *p, const bmr_contact *c) {
    if (p->contacts && p->contact_count < PLAY_MOST_CONTACTS) {
        const play_contact kept = {c->a,
                                   c->b,
                                   c->count,
                                   (uint64_t)c->placed + 2u * c->again,
                                   {c->time, c->points[0].x, c->points[0].y, c->points[1].x, c->points[1].y,
                                    c->normal.x, c->normal.y, c->distance, c->velocity[0].x, c->velocity[0].y,
                                    c->velocity[1].x, c->velocity[1].y, c->approach[0], c->approach[1],
                                    c->image.x, c->image.y}};
        p->contacts[p->contact_count] = kept;
    }
    p->contact_count++;
    p->out_of_order += c->time < p->last_time;
    p->last_time = c->time;
}

/// The two go apart along the normal, each at its own speed.
static inline void play_part(play *p, const bmr_contact *c) {
    for (int i = 0; i < 2; i++) {
        const bmr_body body = i == 0 ? c->a : c->b;
        bmr_body_state state;
        if (bmr_is_wall(body) || bmr_world_get(p->world, body, &state) != BMR_OK)
            continue;
        const double speed = (i == 0 ? -1.0 : 1.0) * (0.1 + hypot(state.velocity.x, state.velocity.y));
        const bmr_motion_piece piece = bmr_piece_screw(c->time, state.pose, bmr_scale(speed, c->normal), 0.0);
        play_note(p, bmr_world_set_piece(p->world, body, &piece));
    }
}

static inline bmr_response play_answer(void *context, bmr_world *world, const bmr_contact *c) {
    play *p = context;
    (void)world;
    play_keep(p, c);
    bmr_response response = {BMR_RESPONSE_PASS, 1.0};
    if (p->all_pass)
        return response;
    response.kind = BMR_RESPONSE_IMPULSE;
    switch (test_random_below(&p->inner, 16)) {
    case 0:
    case 1:
        response.restitution = play_in(&p->inner, 0.0, 1.0);
        break;
    case 2:
        response.kind = BMR_RESPONSE_PASS;
        break;
    case 3:
    case 7:
    case 8:
        response.kind = BMR_RESPONSE_STICK;
        break;
    case 4:
        response.kind = BMR_RESPONSE_MINE;
        play_part(p, c);
        break;
    case 5:
        play_note(p, bmr_world_remove(p->world, c->a));
        break;
    case 6:
        play_change(p, &p->inner);
        break;
    default:
        break;
    }
    return response;
}

/// A world of about `bodies` bodies. `seed` says all but whether there is a grid.
static inline void play_begin(play *p, const play_shapes *shapes, uint64_t seed, size_t bodies,
                              bool all_pairs, const bmr_allocator *allocator) {
    p->random.state = seed;
    p->inner.state = seed ^ 0x5555;
    p->shapes = shapes;
    p->size = 1.5 * sqrt((double)bodies) + 2.0;
    const double far = test_random_below(&p->random, 4) == 0 ? 1e6 : 0.0;
    p->place = bmr_vec2_make(far, -far);
    bmr_world_def def = bmr_default_world_def();
    static const char *const structures[] = {"hybrid", "predict", "separating-edge"};
    if (bmr_kds_find(structures[test_random_below(&p->random, 3)], &def.structure) != BMR_OK)
        abort();
    def.boundary = p->boundary = (bmr_boundary)test_random_below(&p->random, 3);
    const double reach = (def.boundary == BMR_PERIODIC ? 1.0 : 1.5) * p->size;
    def.low = bmr_vec2_make(p->place.x - reach, p->place.y - reach);
    def.high = bmr_vec2_make(p->place.x + reach, p->place.y + 1.4 * reach);
    def.zeno = BMR_ZENO_ELASTIC;
    def.all_pairs = all_pairs;
    def.contact = play_answer;
    def.context = p;
    play_note(p, bmr_world_create(&def, 0.0, allocator, &p->world));
    for (size_t i = 0; i < bodies && p->world; i++)
        play_add(p, &p->random);
}

static inline bmr_error play_advance(play *p, double time) {
    bmr_error error = bmr_world_advance(p->world, time);
    for (int i = 0; i < 100 && error == BMR_ERROR_STALLED; i++) {
        p->stalls++;
        error = bmr_world_advance(p->world, time);
    }
    play_note(p, error);
    return error;
}

#endif
