// SPDX-License-Identifier: MIT
#include "boomerang/motion.h"

#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "kinetic/motion.h"

/// Room for pieces is doubled from here.
#define FIRST_CAPACITY 2

bmr_pose bmr_screw_motion_pose(const bmr_screw_motion *motion, double time) {
    const double angle = motion->spin * time;
    const double c = cos(angle), s = sin(angle);
    bmr_pose pose;
    pose.position = bmr_add(motion->start.position, bmr_scale(time, motion->velocity));
    pose.c = c * motion->start.c - s * motion->start.s;
    pose.s = s * motion->start.c + c * motion->start.s;
    return pose;
}

bmr_motion_piece bmr_piece_rest(bmr_pose pose) {
    return bmr_piece_screw(0.0, pose, bmr_vec2_make(0.0, 0.0), 0.0);
}

bmr_motion_piece bmr_piece_screw(double origin, bmr_pose pose, bmr_vec2 velocity, double spin) {
    bmr_motion_piece piece;
    memset(&piece, 0, sizeof piece);
    piece.kind = BMR_PIECE_SCREW;
    piece.origin = origin;
    piece.as.screw.start = pose;
    piece.as.screw.velocity = velocity;
    piece.as.screw.spin = spin;
    return piece;
}

static bmr_error make_motion(size_t capacity, const bmr_allocator *allocator, bmr_motion **motion) {
    size_t bytes;
    if (!bmr_size_product(capacity, sizeof(bmr_timed_piece), SIZE_MAX, &bytes))
        return BMR_ERROR_TOO_LARGE;
    bmr_motion *made = bmr_allocate(allocator, sizeof *made);
    bmr_timed_piece *pieces = made ? bmr_allocate(allocator, bytes) : NULL;
    if (!pieces) {
        if (made)
            bmr_release(allocator, made, sizeof *made);
        return BMR_ERROR_NO_MEMORY;
    }
    made->allocator = allocator;
    made->count = 0;
    made->capacity = capacity;
    made->pieces = pieces;
    *motion = made;
    return BMR_OK;
}

static void normalize(double *c, double *s) {
    const double length = hypot(*c, *s);
    *c /= length;
    *s /= length;
}

void bmr_timed_piece_set(bmr_timed_piece *timed, double from, const bmr_motion_piece *piece) {
    timed->from = from;
    timed->piece = *piece;
    if (piece->kind == BMR_PIECE_ALGEBRAIC)
        normalize(&timed->piece.as.algebraic.start_c, &timed->piece.as.algebraic.start_s);
    else
        normalize(&timed->piece.as.screw.start.c, &timed->piece.as.screw.start.s);
}

static void append(bmr_motion *motion, double from, const bmr_motion_piece *piece) {
    bmr_timed_piece_set(&motion->pieces[motion->count++], from, piece);
}

bmr_error bmr_motion_create(const bmr_motion_piece *piece, const bmr_allocator *allocator,
                            bmr_motion **motion) {
    if (!piece || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = bmr_piece_check(piece);
    if (error == BMR_OK)
        error = make_motion(FIRST_CAPACITY, allocator, motion);
    if (error == BMR_OK)
        append(*motion, -INFINITY, piece);
    return error;
}

/// The screw from one sample to the next, turning the shorter way round.
static bmr_motion_piece between(double from, const bmr_pose *a, double to, const bmr_pose *b) {
    const double duration = to - from;
    const bmr_vec2 way = bmr_sub(b->position, a->position);
    const double turn = atan2(a->c * b->s - a->s * b->c, a->c * b->c + a->s * b->s);
    return bmr_piece_screw(from, *a, bmr_vec2_make(way.x / duration, way.y / duration), turn / duration);
}

static bmr_error check_samples(const double *times, const bmr_pose *poses, size_t count) {
    for (size_t i = 0; i < count; i++) {
        const bmr_motion_piece rest = bmr_piece_rest(poses[i]);
        const bmr_error error = bmr_piece_check(&rest);
        if (!isfinite(times[i]))
            return BMR_ERROR_NOT_FINITE;
        if (error != BMR_OK)
            return error;
        if (i == 0)
            continue;
        if (!(times[i] > times[i - 1]))
            return BMR_ERROR_OUT_OF_RANGE;
        // Samples so close in time that the speed overflows are no motion.
        const bmr_motion_piece piece = between(times[i - 1], &poses[i - 1], times[i], &poses[i]);
        if (bmr_piece_check(&piece) != BMR_OK)
            return BMR_ERROR_OUT_OF_RANGE;
    }
    return BMR_OK;
}

bmr_error bmr_motion_create_sampled(const double *times, const bmr_pose *poses, size_t count,
                                    const bmr_allocator *allocator, bmr_motion **motion) {
    if (!times || !poses || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    if (count == 0)
        return BMR_ERROR_NO_POINTS;
    bmr_error error = check_samples(times, poses, count);
    if (error == BMR_OK)
        error = make_motion(count + 1, allocator, motion);
    if (error != BMR_OK)
        return error;
    bmr_motion_piece piece = bmr_piece_rest(poses[0]);
    append(*motion, -INFINITY, &piece);
    for (size_t i = 0; i + 1 < count; i++) {
        piece = between(times[i], &poses[i], times[i + 1], &poses[i + 1]);
        append(*motion, times[i], &piece);
    }
    piece = bmr_piece_rest(poses[count - 1]);
    append(*motion, times[count - 1], &piece);
    return BMR_OK;
}

void bmr_motion_destroy(bmr_motion *motion) {
    if (!motion)
        return;
    const bmr_allocator *allocator = motion->allocator;
    bmr_release(allocator, motion->pieces, motion->capacity * sizeof *motion->pieces);
    bmr_release(allocator, motion, sizeof *motion);
}

/// Index of the last piece that begins at or before `time`.
static size_t find(const bmr_motion *motion, double time) {
    size_t low = 0, high = motion->count; // pieces[low].from <= time < pieces[high].from
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (motion->pieces[middle].from <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static bmr_error grow(bmr_motion *motion) {
    const size_t size = sizeof *motion->pieces;
    size_t bytes;
    if (!bmr_size_product(motion->capacity, 2 * size, SIZE_MAX, &bytes))
        return BMR_ERROR_TOO_LARGE;
    const size_t capacity = 2 * motion->capacity;
    bmr_timed_piece *pieces = bmr_allocate(motion->allocator, bytes);
    if (!pieces)
        return BMR_ERROR_NO_MEMORY;
    memcpy(pieces, motion->pieces, motion->count * size);
    bmr_release(motion->allocator, motion->pieces, motion->capacity * size);
    motion->pieces = pieces;
    motion->capacity = capacity;
    return BMR_OK;
}

bmr_error bmr_motion_change(bmr_motion *motion, double time, const bmr_motion_piece *piece) {
    if (!motion || !piece)
        return BMR_ERROR_NULL_ARGUMENT;
    if (!isfinite(time))
        return BMR_ERROR_NOT_FINITE;
    bmr_error error = bmr_piece_check(piece);
    if (error != BMR_OK)
        return error;
    const size_t last = find(motion, time);
    const size_t keep = motion->pieces[last].from == time ? last : last + 1;
    if (keep == motion->capacity)
        error = grow(motion);
    if (error == BMR_OK) {
        motion->count = keep;
        append(motion, time, piece);
    }
    return error;
}

bmr_error bmr_motion_copy_from(const bmr_motion *motion, double time, const bmr_allocator *allocator,
                               bmr_motion **copy) {
    const size_t first = find(motion, time), count = motion->count - first;
    bmr_motion *made;
    const bmr_error error = make_motion(count, allocator, &made);
    if (error != BMR_OK)
        return error;
    memcpy(made->pieces, motion->pieces + first, count * sizeof *made->pieces);
    made->pieces[0].from = -INFINITY;
    made->count = count;
    *copy = made;
    return BMR_OK;
}

const bmr_motion_piece *bmr_motion_piece_at(const bmr_motion *motion, double time, double *end) {
    const size_t i = find(motion, time);
    if (end)
        *end = i + 1 < motion->count ? motion->pieces[i + 1].from : INFINITY;
    return &motion->pieces[i].piece;
}

size_t bmr_motion_piece_count(const bmr_motion *motion) {
    return motion->count;
}

bmr_pose bmr_motion_pose(const bmr_motion *motion, double time, bmr_vec2 *velocity, double *spin) {
    const bmr_instant now = bmr_piece_instant(bmr_motion_piece_at(motion, time, NULL), time);
    if (velocity)
        *velocity = now.velocity;
    if (spin)
        *spin = now.spin;
    return now.pose;
}
