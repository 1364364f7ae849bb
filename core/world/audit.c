// SPDX-License-Identifier: MIT
// Everything that a world claims, proved from scratch.
#include <math.h>

#include "world/parts.h"

/// What places may be off their cells, and disks be nearer, by rounding: parts of a cell, and of the reach.
#define ROOM 1e-6

static bool in_cell(const bmr_world *w, const bmr_resident *r) {
    if (!r->cell)
        return w->def.all_pairs && w->def.boundary != BMR_PERIODIC;
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    const bool periodic = w->def.boundary == BMR_PERIODIC;
    const bmr_vec2 at = periodic ? bmr_sub(position, w->def.low) : position;
    const double x = at.x / bmr_cell_width(w, r->cell->level) - (double)r->column;
    const double y = at.y / bmr_cell_height(w, r->cell->level) - (double)r->row;
    const double room = BMR_CELL_HYSTERESIS + ROOM;
    return x >= -room && x <= 1.0 + room && y >= -room && y <= 1.0 + room;
}

static bool near_by(int64_t a, int64_t b, int64_t size, int64_t *image) {
    const int64_t apart = a - b;
    *image = size > 0 ? (int64_t)floor((double)apart / (double)size + 0.5) : 0;
    const int64_t rest = apart - *image * size;
    return rest >= -1 && rest <= 1;
}

/// Are their cells neighbours on the coarser one's level? `image`: of b as seen from a.
static bool are_neighbours(const bmr_world *w, const bmr_resident *a, const bmr_resident *b,
                           int64_t image[2]) {
    image[0] = image[1] = 0;
    if (!a->cell)
        return true;
    const int la = a->cell->level, lb = b->cell->level, level = la > lb ? la : lb;
    const int64_t x = w->around_x > 0 ? w->around_x << -level : 0;
    const int64_t y = w->around_y > 0 ? w->around_y << -level : 0;
    return near_by(bmr_place_above(a->column, level - la), bmr_place_above(b->column, level - lb), x,
                   &image[0]) &&
           near_by(bmr_place_above(a->row, level - la), bmr_place_above(b->row, level - lb), y, &image[1]);
}

static const bmr_couple *couple_of(const bmr_resident *a, const bmr_resident *b, const int64_t image[2]) {
    for (const bmr_couple *c = a->first; c; c = c->after[bmr_couple_side(c, a)]) {
        const int sign = c->side[0] == a ? 1 : -1;
        if (c->side[1 - bmr_couple_side(c, a)] == b && sign * c->image[0] == image[0] &&
            sign * c->image[1] == image[1])
            return c;
    }
    return NULL;
}

/// Each two: if their cells are neighbours they are a couple, and if they are none their disks, and those of
/// all images around, are apart.
static bmr_error audit_two(const bmr_world *w, const bmr_resident *a, const bmr_resident *b) {
    int64_t image[2];
    const bool neighbours = are_neighbours(w, a, b, image);
    const bmr_couple *c = couple_of(a, b, image);
    if (neighbours && (!c || !c->neighbours))
        return BMR_ERROR_INVALID_STRUCTURE;
    const bmr_vec2 size = bmr_sub(w->def.high, w->def.low);
    const bmr_vec2 way =
        bmr_sub(bmr_path_position(&b->now.piece, w->time), bmr_path_position(&a->now.piece, w->time));
    const bool periodic = w->def.boundary == BMR_PERIODIC;
    const int64_t around = periodic ? 1 : 0;
    const int64_t base[2] = {periodic ? (int64_t)floor(0.5 - way.x / size.x) : 0,
                             periodic ? (int64_t)floor(0.5 - way.y / size.y) : 0};
    for (int64_t i = base[0] - around; i <= base[0] + around; i++)
        for (int64_t j = base[1] - around; j <= base[1] + around; j++) {
            const int64_t here[2] = {i, j};
            const bmr_vec2 apart = bmr_vec2_make(way.x + (periodic ? (double)i * size.x : 0.0),
                                                 way.y + (periodic ? (double)j * size.y : 0.0));
            if (hypot(apart.x, apart.y) <= a->radius + b->radius + w->def.kds.margin &&
                !couple_of(a, b, here))
                return BMR_ERROR_FALSE_CERTIFICATE;
        }
    return BMR_OK;
}

static bmr_error audit_couple(const bmr_world *w, const bmr_couple *c) {
    if (!c->neighbours && c->watch == BMR_WATCH_DISKS)
        return BMR_ERROR_INVALID_STRUCTURE;
    if ((c->watch == BMR_WATCH_DISKS) != (c->near == NULL))
        return BMR_ERROR_INVALID_STRUCTURE;
    const bool due =
        c->head.item.place != BMR_NOT_QUEUED && w->queue.heap[c->head.item.place].time <= w->time;
    if (due) // it has not been told yet
        return BMR_OK;
    if (c->watch == BMR_WATCH_DISKS)
        return bmr_gate_distance(w, c, w->time) > (1.0 - ROOM) * bmr_gate_reach(w, c)
                   ? BMR_OK
                   : BMR_ERROR_FALSE_CERTIFICATE;
    if (c->watch == BMR_WATCH_PASSING)
        return BMR_OK;
    bmr_couple_view view;
    const bmr_pair_motion motion = bmr_couple_motion(w, c, &view);
    const bmr_pose pose = bmr_pair_instant(&motion, w->time).pose;
    return bmr_kds_in_contact(c->near->kds) ? BMR_ERROR_INVALID_STRUCTURE
                                            : bmr_kds_audit(c->near->kds, &pose);
}

static bmr_error audit_queue(const bmr_world *w) {
    for (size_t i = 0; i < w->queue.count; i++) {
        const bmr_event_entry *entry = &w->queue.heap[i], *above = &w->queue.heap[i ? (i - 1) / 2 : 0];
        if (entry->item->place != i || entry->time < above->time || !(entry->time < INFINITY))
            return BMR_ERROR_INVALID_STRUCTURE;
    }
    return BMR_OK;
}

/// A body's list of couples, and its cell.
static bmr_error audit_resident(const bmr_world *w, const bmr_resident *r) {
    const bool due =
        r->head.item.place != BMR_NOT_QUEUED && w->queue.heap[r->head.item.place].time <= w->time;
    if (!due && !in_cell(w, r))
        return BMR_ERROR_FALSE_CERTIFICATE;
    size_t couples = 0;
    for (const bmr_couple *c = r->first; c; c = c->after[bmr_couple_side(c, r)], couples++) {
        const bmr_error error = c->side[0] == r ? audit_couple(w, c) : BMR_OK;
        if (error != BMR_OK)
            return error;
    }
    return couples == r->couples ? BMR_OK : BMR_ERROR_INVALID_STRUCTURE;
}

bmr_error bmr_world_audit(const bmr_world *w) {
    if (!w)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_error error = audit_queue(w);
    for (size_t i = 0; i < w->places && error == BMR_OK; i++) {
        const bmr_resident *a = w->residents[i];
        if (!a)
            continue;
        error = audit_resident(w, a);
        for (size_t j = i + 1; j < w->places && error == BMR_OK; j++)
            if (w->residents[j])
                error = audit_two(w, a, w->residents[j]);
    }
    return error;
}
