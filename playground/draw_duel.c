// SPDX-License-Identifier: MIT
#include <math.h>

#include "boomerang/distance.h"
#include "draw.h"
#include "words.h"

/// Poses of a course that its frame is made of.
#define FRAME_SAMPLES 128
/// Around a frame, in parts of its larger side.
#define FRAME_BORDER 0.06
/// Length of the window's sides, in radii of the body.
#define WINDOW_LENGTH 0.55

static void draw_envelope(play_display *display, const bmr_hierarchy *hierarchy, uint32_t level,
                          const bmr_pose *pose, play_ink ink, double strength) {
    bmr_vec2 corners[PLAY_MOST_ENVELOPE];
    const size_t count = play_envelope(hierarchy, level, pose, corners);
    play_display_add(display, PLAY_AREA, ink, strength, PLAY_NO_LABEL, corners, count);
}

static void draw_body(play_display *display, const play_duel *duel, int body) {
    bmr_vec2 corners[PLAY_MOST_CORNERS];
    const bmr_polygon *polygon = duel->def.bodies[body]->polygon;
    const bmr_pose pose = play_duel_pose(duel, body);
    for (uint32_t i = 0; i < polygon->count; ++i)
        corners[i] = bmr_transform(&pose, polygon->vertices[i]);
    play_display_add(display, PLAY_AREA, body == 0 ? PLAY_INK_A : PLAY_INK_B, 1.0, PLAY_NO_LABEL, corners,
                     polygon->count);
}

static void draw_levels(play_display *display, const play_duel *duel, play_shown_levels shown) {
    const int kind = duel->def.structure->hierarchy;
    const play_levels levels = play_levels_of(duel);
    if (shown == PLAY_NO_LEVELS || kind < 0)
        return;
    for (int body = 0; body < 2; ++body) {
        const bmr_hierarchy *hierarchy = duel->def.bodies[body]->hierarchies[kind];
        const bmr_pose pose = play_duel_pose(duel, body);
        const int depth = (int)bmr_hierarchy_depth(hierarchy);
        for (int level = 0; shown == PLAY_ALL_LEVELS && level < depth; ++level)
            if (level != levels.level)
                draw_envelope(display, hierarchy, (uint32_t)level, &pose,
                              body == 0 ? PLAY_INK_LEVEL_A : PLAY_INK_LEVEL_B, 1.0);
        if (levels.level >= 0)
            draw_envelope(display, hierarchy, (uint32_t)levels.level, &pose,
                          body == 0 ? PLAY_INK_ENVELOPE_A : PLAY_INK_ENVELOPE_B, 1.0);
    }
}

/// The line of a proof at the present poses, as long as the frame is wide and high.
static void draw_line(play_display *display, const play_duel *duel, const bmr_kds_proof *proof, play_ink ink,
                      double strength, const play_frame *frame) {
    const bmr_pose owner = play_duel_pose(duel, proof->owner), other = play_duel_pose(duel, 1 - proof->owner);
    const bmr_vec2 normal = bmr_rotate(&owner, proof->line.normal);
    const bmr_vec2 corner = bmr_transform(&other, proof->nearest);
    const double offset = proof->line.offset + bmr_dot(normal, owner.position);
    const bmr_vec2 foot = bmr_sub(corner, bmr_scale(bmr_dot(normal, corner) - offset, normal));
    const double reach = hypot(frame->high.x - frame->low.x, frame->high.y - frame->low.y);
    const bmr_vec2 ends[2] = {bmr_add(foot, bmr_scale(reach, bmr_left(normal))),
                              bmr_sub(foot, bmr_scale(reach, bmr_left(normal)))};
    play_display_add(display, PLAY_PATH, ink, strength, PLAY_NO_LABEL, ends, 2);
}

/// Each watched corner with the way that it has to the line, and the sides of the window at the nearest.
static void draw_watched(play_display *display, const play_duel *duel, const bmr_kds_proof *proof) {
    bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
    const size_t count = bmr_kds_conditions(play_duel_kds(duel), conditions);
    const bmr_pose poses[2] = {play_duel_pose(duel, 0), play_duel_pose(duel, 1)};
    const bmr_vec2 normal = bmr_rotate(&poses[proof->owner], proof->line.normal);
    const bmr_vec2 nearest = bmr_transform(&poses[1 - proof->owner], proof->nearest);
    const double length = WINDOW_LENGTH * duel->def.bodies[1 - proof->owner]->polygon->radius;
    bmr_vec2 cone[3];
    size_t sides = 0;
    cone[1] = nearest;
    for (size_t i = 0; i < count; ++i) {
        const bmr_condition *k = &conditions[i];
        const bmr_pose *owner = &poses[k->owner], *other = &poses[1 - k->owner];
        if (k->kind == BMR_CONDITION_BEYOND) {
            const bmr_vec2 point = bmr_transform(other, k->point);
            const bmr_vec2 n = bmr_rotate(owner, k->normal);
            const double beyond = bmr_dot(n, bmr_sub(point, owner->position)) - k->offset;
            const bmr_vec2 way[2] = {point, bmr_sub(point, bmr_scale(beyond, n))};
            play_display_add(display, PLAY_PATH, PLAY_INK_WATCHED, 1.0, PLAY_NO_LABEL, way, 2);
            play_display_add(display, PLAY_DOT, PLAY_INK_WATCHED, 1.0, PLAY_NO_LABEL, way, 1);
        } else if (k->kind == BMR_CONDITION_TURN && sides < 2) {
            // Towards the owner, as the line's normal seen from the corner.
            bmr_vec2 side = bmr_rotate(other, k->point);
            if (bmr_dot(side, normal) > 0.0)
                side = bmr_neg(side);
            cone[2 * sides++] = bmr_add(nearest, bmr_scale(length, side));
        }
    }
    if (sides == 2)
        play_display_add(display, PLAY_PATH, PLAY_INK_WINDOW, 1.0, PLAY_NO_LABEL, cone, 3);
}

static double strength_of(const play_event *event) {
    return event ? fmax(0.0, 1.0 - event->age / PLAY_EVENT_SECONDS) : 0.0;
}

bool play_draw_event_at(play_display *display, const play_duel *duel, bmr_vec2 where) {
    const play_event *event = play_duel_latest(duel);
    const double strength = strength_of(event);
    if (!(strength > 0.0))
        return false;
    const play_ink ink = event->report.kind == BMR_KDS_CONTACT ? PLAY_INK_CONTACT : PLAY_INK_EVENT;
    play_display_add(display, PLAY_RING, ink, strength, PLAY_NO_LABEL, &where, 1);
    play_display_add(display, PLAY_LABEL, ink, strength, (int)event->report.kind, &where, 1);
    return true;
}

/// Where an event happened: the corner that crossed, or the one that is the nearest now; of a contact where
/// they touch.
static bmr_vec2 place_of(const play_duel *duel, const play_event *event) {
    const bmr_pose poses[2] = {play_duel_pose(duel, 0), play_duel_pose(duel, 1)};
    bmr_closest_points closest;
    if (event->report.kind == BMR_KDS_CONTACT &&
        bmr_distance(duel->def.bodies[0]->polygon, &poses[0], duel->def.bodies[1]->polygon, &poses[1],
                     &closest) == BMR_OK)
        return closest.point_a;
    const bool crossed = event->failed.kind == BMR_CONDITION_BEYOND && event->report.kind != BMR_KDS_LEAVE;
    return crossed ? bmr_transform(&poses[1 - event->failed.owner], event->failed.point)
                   : bmr_transform(&poses[1 - event->after.owner], event->after.nearest);
}

static void draw_event(play_display *display, const play_duel *duel, const play_frame *frame) {
    const play_event *event = play_duel_latest(duel);
    const double strength = strength_of(event);
    if (!(strength > 0.0))
        return;
    const bmr_kds_event_kind kind = event->report.kind;
    if (kind != BMR_KDS_LEAVE && event->report.line_changed)
        draw_line(display, duel, &event->before, PLAY_INK_OLD_LINE, strength, frame);
    play_draw_event_at(display, duel, place_of(duel, event));
}

void play_draw_duel(play_display *display, const play_duel *duel, play_shown_levels shown,
                    const play_frame *frame) {
    bmr_kds_proof proof;
    const bmr_kds *kds = play_duel_kds(duel);
    const bool apart = kds && bmr_kds_get_proof(kds, &proof);
    draw_levels(display, duel, shown);
    for (int body = 0; body < 2; ++body)
        draw_body(display, duel, body);
    if (apart)
        draw_line(display, duel, &proof, PLAY_INK_LINE, 1.0, frame);
    if (apart && !play_is_cell(duel->def.structure)) // a cell's conditions are to be seen as its sides
        draw_watched(display, duel, &proof);
    draw_event(display, duel, frame);
    for (int body = 0; body < 2; ++body) {
        const bmr_vec2 middle = play_duel_pose(duel, body).position;
        play_display_add(display, PLAY_LABEL, body == 0 ? PLAY_INK_A : PLAY_INK_B, 1.0, PLAY_LABEL_A + body,
                         &middle, 1);
    }
}

static void widen(play_frame *frame, bmr_vec2 middle, double radius) {
    frame->low.x = fmin(frame->low.x, middle.x - radius);
    frame->low.y = fmin(frame->low.y, middle.y - radius);
    frame->high.x = fmax(frame->high.x, middle.x + radius);
    frame->high.y = fmax(frame->high.y, middle.y + radius);
}

play_frame play_frame_of_duel(const play_duel *duel, bool now) {
    play_frame frame = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    const bool course = duel->def.course != PLAY_BY_HAND && !now;
    for (int i = 0; i <= (course ? FRAME_SAMPLES : 0); ++i) {
        const double part = (double)i / FRAME_SAMPLES;
        const double time = course ? part * duel->until : duel->time;
        for (int body = 0; body < 2; ++body) {
            const bmr_polygon *polygon = duel->def.bodies[body]->polygon;
            const bmr_pose pose = bmr_motion_pose(duel->motions[body], time, NULL, NULL);
            widen(&frame, bmr_transform(&pose, polygon->center), polygon->radius);
        }
    }
    const double border = FRAME_BORDER * fmax(frame.high.x - frame.low.x, frame.high.y - frame.low.y);
    widen(&frame, frame.low, border);
    widen(&frame, frame.high, border);
    return frame;
}
