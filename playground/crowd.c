// SPDX-License-Identifier: MIT
#include "crowd.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
/// A body's disk has this radius.
#define RADIUS 0.5
/// Of the side of a body's own square at the start: how far from its middle it may be.
#define JITTER 0.05
#define MOST_SPEED 1.5
#define MOST_SPIN 2.0
#define MARGIN 1e-4

/// The next of a row of numbers in [0, 1): splitmix64.
static double random_part(uint64_t *state) {
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return ldexp((double)((z ^ (z >> 31)) >> 11), -53);
}
static double random_between(uint64_t *state, double low, double high) {
    return low + (high - low) * random_part(state);
}

static bmr_response collide(void *context, bmr_world *world, const bmr_contact *contact) {
    play_crowd *crowd = context;
    (void)world;
    ++crowd->contacts;
    crowd->flashes[crowd->flash_count++ % PLAY_FLASHES] = (play_flash){contact->points[0], 0.0};
    return (bmr_response){BMR_RESPONSE_IMPULSE, 1.0};
}

static bmr_error add_body(play_crowd *crowd, size_t index, size_t columns, uint64_t *dice) {
    const double cell = crowd->side / (double)columns;
    const size_t column = index % columns, row = index / columns;
    const bmr_vec2 middle = bmr_vec2_make(((double)column + 0.5) * cell, ((double)row + 0.5) * cell);
    const double jitter = JITTER * (cell - 2.0 * RADIUS);
    const bmr_vec2 place = bmr_add(
        middle, bmr_vec2_make(random_between(dice, -jitter, jitter), random_between(dice, -jitter, jitter)));
    const double heading = random_between(dice, 0.0, 2.0 * PI);
    const double speed = random_between(dice, 0.3 * MOST_SPEED, MOST_SPEED);
    const bmr_pose pose = bmr_pose_from_angle(place, random_between(dice, 0.0, 2.0 * PI));
    const bmr_motion_piece piece =
        bmr_piece_screw(0.0, pose, bmr_vec2_make(speed * cos(heading), speed * sin(heading)),
                        random_between(dice, -MOST_SPIN, MOST_SPIN));
    bmr_motion *motion;
    bmr_error error = bmr_motion_create(&piece, NULL, &motion);
    if (error != BMR_OK)
        return error;
    const bmr_shape shape = play_body_shape(crowd->shapes[index % BMR_NGON_COUNT]);
    const bmr_body_def def = bmr_default_body_def(&shape, motion);
    bmr_body body;
    error = bmr_world_add(crowd->world, &def, &body);
    bmr_motion_destroy(motion);
    return error;
}

static bmr_error open_crowd(play_crowd *crowd) {
    const play_crowd_def *def = &crowd->def;
    bmr_error error = BMR_OK;
    for (int ngon = 0; ngon < BMR_NGON_COUNT && error == BMR_OK; ++ngon) {
        error = play_body_create_ngon((bmr_ngon)ngon, def->corners, def->seed, 1.0, &crowd->shapes[ngon]);
        if (error != BMR_OK)
            break;
        // Each as large as its disk may be.
        const double scale = RADIUS / crowd->shapes[ngon]->polygon->radius;
        play_body_destroy(crowd->shapes[ngon]);
        crowd->shapes[ngon] = NULL;
        error = play_body_create_ngon((bmr_ngon)ngon, def->corners, def->seed, scale, &crowd->shapes[ngon]);
    }
    if (error != BMR_OK)
        return error;
    const size_t columns = (size_t)ceil(sqrt((double)def->bodies));
    crowd->side = 2.0 * RADIUS * (double)columns * sqrt(0.25 * PI / def->packing);
    bmr_world_def world = bmr_default_world_def();
    world.structure = def->structure;
    world.kds.margin = MARGIN;
    world.kds.hysteresis = MARGIN;
    world.boundary = BMR_WALLED;
    world.high = bmr_vec2_make(crowd->side, crowd->side);
    world.zeno = BMR_ZENO_ELASTIC;
    world.contact = collide;
    world.context = crowd;
    error = bmr_world_create(&world, 0.0, NULL, &crowd->world);
    uint64_t dice = def->seed;
    for (size_t i = 0; i < def->bodies && error == BMR_OK; ++i)
        error = add_body(crowd, i, columns, &dice);
    if (error == BMR_OK)
        crowd->energy = bmr_world_get_totals(crowd->world).energy;
    return error;
}

bmr_error play_crowd_create(const play_crowd_def *def, play_crowd **crowd) {
    if (!def || !crowd || !def->structure)
        return BMR_ERROR_NULL_ARGUMENT;
    if (def->bodies == 0 || def->bodies > PLAY_MOST_BODIES || !(def->packing > 0.0 && def->packing <= 0.5))
        return BMR_ERROR_OUT_OF_RANGE;
    play_crowd *made = calloc(1, sizeof *made);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    made->def = *def;
    const bmr_error error = open_crowd(made);
    if (error == BMR_OK)
        *crowd = made;
    else
        play_crowd_destroy(made);
    return error;
}

void play_crowd_destroy(play_crowd *crowd) {
    if (!crowd)
        return;
    bmr_world_destroy(crowd->world);
    for (int ngon = 0; ngon < BMR_NGON_COUNT; ++ngon)
        play_body_destroy(crowd->shapes[ngon]);
    free(crowd);
}

bmr_error play_crowd_advance(play_crowd *crowd, double time, double seconds) {
    for (size_t i = 0; i < PLAY_FLASHES; ++i)
        crowd->flashes[i].age += seconds;
    crowd->stopped = bmr_world_advance(crowd->world, bmr_world_time(crowd->world) + time);
    return crowd->stopped;
}

bmr_error play_crowd_push(play_crowd *crowd, bmr_vec2 point, bmr_vec2 velocity) {
    if (!isfinite(point.x + point.y) || !isfinite(velocity.x + velocity.y))
        return BMR_OK;
    bmr_body nearest = BMR_NO_BODY;
    bmr_body_state state, best = {0};
    double least = INFINITY;
    size_t place = 0;
    for (bmr_body body; (body = bmr_world_next_body(crowd->world, &place)) != BMR_NO_BODY;) {
        bmr_world_get(crowd->world, body, &state);
        const double distance = hypot(state.pose.position.x - point.x, state.pose.position.y - point.y);
        if (distance < least) {
            least = distance;
            nearest = body;
            best = state;
        }
    }
    if (nearest == BMR_NO_BODY)
        return BMR_OK;
    const bmr_motion_piece piece =
        bmr_piece_screw(bmr_world_time(crowd->world), best.pose, velocity, best.spin);
    return bmr_world_set_piece(crowd->world, nearest, &piece);
}
