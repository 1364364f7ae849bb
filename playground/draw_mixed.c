// SPDX-License-Identifier: MIT
#include <math.h>

#include "boomerang/minkowski.h"
#include "draw.h"
#include "hierarchy/mixed_cells.h"
#include "words.h"

/// The direction that a search for x's cell comes from, where A and B lie on each other.
static const bmr_vec2 any_direction = {1.0, 0.0};

static bmr_mixed mixed_of(const play_duel *duel, bmr_vec2 *x) {
    const int kind = duel->def.structure->hierarchy;
    const bmr_pose pose = play_duel_b_in_a(duel);
    *x = pose.position;
    return bmr_mixed_make(duel->def.bodies[0]->hierarchies[kind], duel->def.bodies[1]->hierarchies[kind],
                          pose.c, pose.s, 0.0);
}

static play_ink ink_of(const bmr_mixed_cell *cell) {
    if (cell->kind != BMR_MIXED_TRIANGLE)
        return PLAY_INK_PARALLELOGRAM;
    return cell->owner == 0 ? PLAY_INK_TRIANGLE_A : PLAY_INK_TRIANGLE_B;
}

static void draw_cell(play_display *display, const bmr_mixed *mixed, const bmr_mixed_cell *cell,
                      play_ink ink) {
    bmr_vec2 corners[BMR_MIXED_MAX_SIDES];
    const size_t count = bmr_mixed_polygon(mixed, cell, corners);
    play_display_add(display, PLAY_AREA, ink, 1.0, PLAY_NO_LABEL, corners, count);
}

/// Where the bodies overlap: all differences of their vertices.
static void draw_sum(play_display *display, const play_duel *duel) {
    const bmr_pose pose = play_duel_b_in_a(duel);
    bmr_polygon *sum;
    if (bmr_minkowski_difference(duel->def.bodies[0]->polygon, duel->def.bodies[1]->polygon,
                                 bmr_vec2_make(pose.c, pose.s), NULL, &sum) != BMR_OK)
        return;
    play_display_add(display, PLAY_AREA, PLAY_INK_SUM, 1.0, PLAY_NO_LABEL, sum->vertices, sum->count);
    bmr_polygon_destroy(sum, NULL);
}

void play_draw_mixed(play_display *display, const play_duel *duel) {
    if (duel->def.structure->hierarchy < 0)
        return;
    bmr_vec2 x;
    const bmr_mixed mixed = mixed_of(duel, &x);
    bmr_mixed_tiling *tiling;
    if (bmr_mixed_tiling_create(&mixed, NULL, &tiling) != BMR_OK)
        return;
    for (uint32_t tile = 0; tile < bmr_mixed_tiling_count(tiling); ++tile) {
        const bmr_mixed_cell *cell = bmr_mixed_tiling_cell(tiling, tile);
        draw_cell(display, &mixed, cell, ink_of(cell));
    }
    bmr_mixed_tiling_destroy(tiling, NULL);
    draw_sum(display, duel);
    bmr_mixed_cell cell;
    const bmr_vec2 from = hypot(x.x, x.y) > 0.0 ? x : any_direction;
    if (bmr_mixed_locate(&mixed, x, from, &cell, NULL) && cell.kind < BMR_MIXED_OUTSIDE)
        draw_cell(display, &mixed, &cell, PLAY_INK_CELL);
    play_display_add(display, PLAY_DOT, PLAY_INK_POINT, 1.0, PLAY_NO_LABEL, &x, 1);
    if (!play_draw_event_at(display, duel, x))
        play_display_add(display, PLAY_LABEL, PLAY_INK_POINT, 1.0, PLAY_LABEL_X, &x, 1);
}

/// The corner of a body's bounding rectangle that is farthest from its origin.
static double reach_of(const play_duel *duel, int body, int kind) {
    bmr_vec2 corners[PLAY_MOST_ENVELOPE];
    const bmr_pose home = bmr_pose_identity();
    const size_t count = play_envelope(duel->def.bodies[body]->hierarchies[kind], 0, &home, corners);
    double reach = 0.0;
    for (size_t i = 0; i < count; ++i)
        reach = fmax(reach, hypot(corners[i].x, corners[i].y));
    return reach;
}

play_frame play_frame_of_mixed(const play_duel *duel) {
    const int kind = duel->def.structure->hierarchy;
    double reach = 1.0;
    if (kind >= 0)
        reach = 1.02 * (reach_of(duel, 0, kind) + reach_of(duel, 1, kind));
    return (play_frame){{-reach, -reach}, {reach, reach}};
}
