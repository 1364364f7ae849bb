// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_WORLD_STAGE_H
#define BMR_TEST_WORLD_STAGE_H

#include "boomerang/world.h"
#include "checks.h"
#include "motions.h"
#include "polygons.h"

/// @file
/// A kinetic world whose contacts and events are written down, and bodies for it. In C.

#define MARGIN 1e-6
#define MOST 4096

typedef struct stage {
    bmr_world *world;
    bmr_world_def def;
    bmr_response response;
    size_t count;
    bmr_contact contacts[MOST];
    uint64_t events[BMR_WORLD_EVENT_KIND_COUNT];
    bmr_body crossed[MOST]; ///< by CROSS events, in their order
    void (*inside)(struct stage *stage, const bmr_contact *contact);
} stage;

static inline bmr_response tell(void *context, bmr_world *world, const bmr_contact *contact) {
    stage *s = context;
    (void)world;
    if (s->count < MOST)
        s->contacts[s->count] = *contact;
    s->count++;
    if (s->inside)
        s->inside(s, contact);
    return s->response;
}

static inline void observe(void *context, bmr_world *world, const bmr_world_event *event) {
    stage *s = context;
    (void)world;
    if (event->kind == BMR_WORLD_CROSS && s->events[BMR_WORLD_CROSS] < MOST)
        s->crossed[s->events[BMR_WORLD_CROSS]] = event->a;
    s->events[event->kind]++;
}

static inline stage *make_stage(bmr_boundary boundary, double size) {
    stage *s = calloc(1, sizeof *s);
    assert_non_null(s);
    s->def = bmr_default_world_def();
    s->def.boundary = boundary;
    s->def.low = bmr_vec2_make(-size, -size);
    s->def.high = bmr_vec2_make(size, size);
    s->def.contact = tell;
    s->def.observer = observe;
    s->def.context = s;
    s->response.kind = BMR_RESPONSE_IMPULSE;
    s->response.restitution = 1.0;
    return s;
}

/// In the open, where bodies pass.
static inline stage *make_passing_stage(void) {
    stage *s = make_stage(BMR_OPEN, 0.0);
    s->response.kind = BMR_RESPONSE_PASS;
    return s;
}

static inline void open_stage(stage *s) {
    assert_int_equal(bmr_world_create(&s->def, 0.0, NULL, &s->world), BMR_OK);
}

static inline void close_stage(stage *s) {
    bmr_world_destroy(s->world);
    free(s);
}
static inline void leave_stage(stage **s) {
    close_stage(*s);
}
#define own_stage OWNED(leave_stage) stage

static inline void advance(stage *s, double time) {
    assert_int_equal(bmr_world_advance(s->world, time), BMR_OK);
    assert_int_equal(bmr_world_audit(s->world), BMR_OK);
}

/// A box of half sides 1 at most, times `scale`. It lives as long as the program.
static inline const bmr_polygon *box(double scale) {
    static bmr_polygon *made[16];
    bmr_polygon **place = made;
    while (*place && (*place)->extent != scale)
        place++;
    assert_true(place < made + 15);
    const bmr_vec2 points[4] = {{-scale, -scale}, {scale, -scale}, {scale, scale}, {-scale, scale}};
    if (!*place)
        assert_int_equal(bmr_polygon_create(points, 4, NULL, place), BMR_OK);
    return *place;
}

static inline bmr_motion_piece flight(double time, double x, double y, double vx, double vy, double spin) {
    return bmr_piece_screw(time, bmr_pose_from_angle(bmr_vec2_make(x, y), 0.0), bmr_vec2_make(vx, vy), spin);
}

/// The world begins with its first body, unless it was opened.
static inline bmr_body add_piece(stage *s, const bmr_polygon *polygon, bmr_motion_piece piece, double mass) {
    if (!s->world)
        open_stage(s);
    bmr_motion *motion = made_motion(piece);
    const bmr_shape shape = {.polygon = polygon};
    bmr_body_def def = bmr_default_body_def(&shape, motion);
    if (mass > 0.0)
        def.mass = mass;
    bmr_body body;
    assert_int_equal(bmr_world_add(s->world, &def, &body), BMR_OK);
    bmr_motion_destroy(motion);
    return body;
}

/// Of its polygon's own mass, from the time 0 on.
static inline bmr_body fly(stage *s, const bmr_polygon *polygon, double x, double y, double vx, double vy,
                           double spin) {
    return add_piece(s, polygon, flight(0.0, x, y, vx, vy, spin), 0.0);
}
/// The same with velocities and a spin of up to 1 either way.
static inline bmr_body drift(stage *s, const bmr_polygon *polygon, double x, double y, test_random *random) {
    const double vx = test_random_uniform(random, -1.0, 1.0), vy = test_random_uniform(random, -1.0, 1.0);
    return fly(s, polygon, x, y, vx, vy, test_random_uniform(random, -1.0, 1.0));
}

static inline bmr_body_state state_of(const stage *s, bmr_body body) {
    bmr_body_state state;
    assert_int_equal(bmr_world_get(s->world, body, &state), BMR_OK);
    return state;
}

/// From now on, and from where it is.
static inline void send(stage *s, bmr_body body, double vx, double vy, double spin) {
    const bmr_motion_piece piece =
        bmr_piece_screw(bmr_world_time(s->world), state_of(s, body).pose, bmr_vec2_make(vx, vy), spin);
    assert_int_equal(bmr_world_set_piece(s->world, body, &piece), BMR_OK);
}

static inline void assert_near(double value, double expected, double room) {
    if (!(fabs(value - expected) <= room))
        fail_msg("%.17g is not %.17g", value, expected);
}

#endif
