// SPDX-License-Identifier: MIT
#include <math.h>

#include "draw.h"

/// How long a contact is to be seen, in seconds.
#define FLASH_SECONDS 0.6

typedef struct pair_drawing {
    play_display *display;
    const play_crowd *crowd;
    unsigned shown;
} pair_drawing;

static void draw_pair(void *context, const bmr_world_pair *pair) {
    const pair_drawing *drawing = context;
    const bool near = pair->watch != BMR_WATCH_DISKS;
    bmr_body_state a, b;
    if (!(drawing->shown & (near ? PLAY_SHOW_PROOFS : PLAY_SHOW_CANDIDATES)) ||
        bmr_world_get(drawing->crowd->world, pair->a, &a) != BMR_OK ||
        bmr_world_get(drawing->crowd->world, pair->b, &b) != BMR_OK) // a wall
        return;
    const bmr_vec2 ends[2] = {a.pose.position, b.pose.position};
    play_display_add(drawing->display, PLAY_PATH, near ? PLAY_INK_NEAR : PLAY_INK_CANDIDATE, 1.0, -1, ends,
                     2);
}

static void draw_cell(void *context, const bmr_world_cell *cell) {
    const pair_drawing *drawing = context;
    const bmr_vec2 corners[4] = {cell->low, bmr_vec2_make(cell->high.x, cell->low.y), cell->high,
                                 bmr_vec2_make(cell->low.x, cell->high.y)};
    play_display_add(drawing->display, PLAY_AREA, PLAY_INK_GRID, 1.0, PLAY_NO_LABEL, corners, 4);
}

static void draw_bodies(play_display *display, const play_crowd *crowd) {
    bmr_vec2 corners[PLAY_MOST_CORNERS];
    size_t place = 0;
    for (bmr_body body; (body = bmr_world_next_body(crowd->world, &place)) != BMR_NO_BODY;) {
        bmr_body_state state;
        if (bmr_world_get(crowd->world, body, &state) != BMR_OK)
            continue;
        const bmr_polygon *polygon = state.shape->polygon;
        for (uint32_t i = 0; i < polygon->count; ++i)
            corners[i] = bmr_transform(&state.pose, polygon->vertices[i]);
        play_display_add(display, PLAY_AREA, body % 2 == 0 ? PLAY_INK_A : PLAY_INK_B, 1.0, PLAY_NO_LABEL,
                         corners, polygon->count);
    }
}

void play_draw_crowd(play_display *display, const play_crowd *crowd, unsigned shown) {
    pair_drawing drawing = {display, crowd, shown};
    if (shown & PLAY_SHOW_CELLS)
        bmr_world_each_cell(crowd->world, draw_cell, &drawing);
    const bmr_vec2 walls[5] = {bmr_vec2_make(0.0, 0.0), bmr_vec2_make(crowd->side, 0.0),
                               bmr_vec2_make(crowd->side, crowd->side), bmr_vec2_make(0.0, crowd->side),
                               bmr_vec2_make(0.0, 0.0)};
    play_display_add(display, PLAY_PATH, PLAY_INK_BOX, 1.0, PLAY_NO_LABEL, walls, 5);
    draw_bodies(display, crowd);
    if (shown & (PLAY_SHOW_CANDIDATES | PLAY_SHOW_PROOFS))
        bmr_world_each_pair(crowd->world, draw_pair, &drawing);
    const size_t kept = crowd->flash_count < PLAY_FLASHES ? crowd->flash_count : PLAY_FLASHES;
    for (size_t i = 0; i < kept; ++i) {
        const double strength = 1.0 - crowd->flashes[i].age / FLASH_SECONDS;
        if (strength > 0.0)
            play_display_add(display, PLAY_RING, PLAY_INK_CONTACT, strength, PLAY_NO_LABEL,
                             &crowd->flashes[i].point, 1);
    }
}

play_frame play_frame_of_crowd(const play_crowd *crowd) {
    const double border = 0.02 * crowd->side;
    return (play_frame){{-border, -border}, {crowd->side + border, crowd->side + border}};
}
