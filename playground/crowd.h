// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_CROWD_H
#define BOOMERANG_PLAYGROUND_CROWD_H

#include "body.h"
#include "boomerang/world.h"

/// @file
/// Many bodies in a box: a bmr_world whose contacts are answered with elastic impulses.

#define PLAY_MOST_BODIES 1000u
/// Contacts that are still to be seen, at most.
#define PLAY_FLASHES 128u

typedef struct play_crowd_def {
    const bmr_kds_info *structure; ///< of near pairs; for any motion
    size_t bodies;                 ///< 1 .. PLAY_MOST_BODIES
    size_t corners;                ///< of each, 3 .. PLAY_MOST_CORNERS
    double packing;                ///< the disks' area over the box's, (0, 0.5]
    uint64_t seed;
} play_crowd_def;

typedef struct play_flash {
    bmr_vec2 point;
    double age; ///< seconds for the eye
} play_flash;

typedef struct play_crowd {
    play_crowd_def def;
    bmr_world *world;
    play_body *shapes[BMR_NGON_COUNT]; ///< the bodies' polygons, in turn
    double side;                       ///< of the box, which begins at the origin
    double energy;                     ///< at the beginning
    uint64_t contacts;
    play_flash flashes[PLAY_FLASHES]; ///< a ring
    size_t flash_count;               ///< that there ever were
    bmr_error stopped;                ///< what ended the last advance; BMR_OK: nothing
} play_crowd;

/// Errors: NULL_ARGUMENT, OUT_OF_RANGE, those of bmr_world_create and bmr_world_add; then *crowd is
/// untouched. The same def gives the same bits.
bmr_error play_crowd_create(const play_crowd_def *def, play_crowd **crowd);
/// NULL is no error.
void play_crowd_destroy(play_crowd *crowd);
/// Goes on by `time` units of the world, and by `seconds` for the eye. Errors: those of bmr_world_advance.
bmr_error play_crowd_advance(play_crowd *crowd, double time, double seconds);
/// Gives the body that is nearest to a point a velocity, from the present time on: a change of plan. A point
/// or velocity that is not finite changes nothing. Errors: those of bmr_world_set_piece.
bmr_error play_crowd_push(play_crowd *crowd, bmr_vec2 point, bmr_vec2 velocity);

#endif
