// SPDX-License-Identifier: MIT
// Bodies as the caller has them: by an id, added, removed, and sent elsewhere at any time.
#include "world/parts.h"

#include <math.h>
#include <string.h>

#include "geometry/memory.h"
#include "kinetic/motion.h"

bmr_resident *bmr_world_find(const bmr_world *w, bmr_body id) {
    const size_t place = (size_t)(id & UINT32_MAX);
    if (place >= w->places || !w->residents[place] || w->residents[place]->id != id)
        return NULL;
    return w->residents[place];
}

/// A place in the table of ids, whose ids are not used up; the table grows by doubling, and is never given
/// back before the world is.
static bmr_error find_place(bmr_world *w, size_t *place) {
    while (w->free_place < w->places &&
           (w->residents[w->free_place] || w->generations[w->free_place] == BMR_NO_GENERATION))
        w->free_place++;
    *place = w->free_place;
    if (w->free_place < w->places)
        return BMR_OK;
    if (w->places == w->capacity) {
        const size_t capacity = w->capacity ? 2 * w->capacity : 16;
        size_t bytes;
        if (w->capacity > UINT32_MAX / 4 || !bmr_size_product(capacity, BMR_PLACE_BYTES, SIZE_MAX, &bytes))
            return BMR_ERROR_TOO_LARGE;
        bmr_resident **residents = bmr_world_take(w, bytes);
        if (!residents)
            return BMR_ERROR_NO_MEMORY;
        uint32_t *generations = (uint32_t *)(void *)(residents + capacity);
        memset(residents, 0, bytes);
        if (w->residents) {
            memcpy(residents, w->residents, w->places * sizeof(bmr_resident *));
            memcpy(generations, w->generations, w->places * sizeof *generations);
            bmr_world_give(w, w->residents, w->capacity * BMR_PLACE_BYTES);
        }
        w->residents = residents;
        w->generations = generations;
        w->capacity = capacity;
    }
    return BMR_OK;
}

static bmr_error plan_of(bmr_world *w, const bmr_motion *motion, bmr_motion_piece *piece, double *until,
                         bmr_motion **plan) {
    *piece = *bmr_motion_piece_at(motion, w->time, until);
    *plan = NULL;
    return *until < INFINITY ? bmr_motion_copy_from(motion, w->time, &w->counted, plan) : BMR_OK;
}

static double radius_of(const bmr_polygon *polygon) {
    double most = 0.0;
    for (uint32_t i = 0; i < polygon->count; i++)
        most = fmax(most, hypot(polygon->vertices[i].x, polygon->vertices[i].y));
    return most * (1.0 + 0x1p-50);
}

/// Where it is to live, and a first look at its shape: what a structure would say of it.
static bmr_error check_body(bmr_world *w, const bmr_body_def *def, bmr_resident *r, int *level) {
    if (!(def->mass > 0.0) || !(def->inertia > 0.0))
        return isnan(def->mass) || isnan(def->inertia) ? BMR_ERROR_NOT_FINITE : BMR_ERROR_OUT_OF_RANGE;
    bmr_kds *kds;
    bmr_error error = bmr_kds_create(w->def.structure, &w->def.kds, &r->shape, &r->shape, &w->counted, &kds);
    if (error != BMR_OK)
        return error;
    bmr_kds_destroy(kds, &w->counted);
    if (w->unit_x == 0.0)
        w->unit_x = w->unit_y = bmr_grid_need(w, r->radius);
    const bmr_vec2 position = bmr_path_position(&r->now.piece, w->time);
    error = bmr_grid_level(w, r->radius, position, level);
    if (error == BMR_OK && w->def.boundary == BMR_WALLED)
        error = bmr_walls_beside(w, r->radius, &r->beside);
    if (error == BMR_OK && w->def.boundary == BMR_PERIODIC &&
        8.0 * r->radius >= fmin(w->def.high.x - w->def.low.x, w->def.high.y - w->def.low.y))
        error = BMR_ERROR_OUT_OF_RANGE;
    return error;
}

static bmr_error make_resident(bmr_world *w, const bmr_body_def *def, bmr_resident **resident) {
    bmr_motion_piece piece;
    bmr_motion *plan;
    double until;
    bmr_error error = plan_of(w, def->motion, &piece, &until, &plan);
    if (error != BMR_OK)
        return error;
    bmr_resident *r = bmr_world_take(w, sizeof *r);
    error = r ? bmr_event_queue_promise(&w->queue, &w->counted) : BMR_ERROR_NO_MEMORY;
    if (error != BMR_OK) {
        if (r)
            bmr_world_give(w, r, sizeof *r);
        bmr_motion_destroy(plan);
        return error;
    }
    memset(r, 0, sizeof *r);
    r->head.item.place = BMR_NOT_QUEUED;
    r->shape = *def->shape;
    r->radius = radius_of(def->shape->polygon);
    r->mass = def->mass;
    r->inertia = def->inertia;
    r->user = def->user;
    bmr_resident_take(w, r, &piece, until, plan);
    *resident = r;
    return BMR_OK;
}

bmr_error bmr_world_add(bmr_world *w, const bmr_body_def *def, bmr_body *body) {
    if (!w || !def || !body || !def->shape || !def->shape->polygon || !def->motion)
        return BMR_ERROR_NULL_ARGUMENT;
    size_t place;
    bmr_resident *r;
    bmr_error error = find_place(w, &place);
    if (error == BMR_OK)
        error = make_resident(w, def, &r);
    if (error != BMR_OK)
        return error;
    int level;
    error = check_body(w, def, r, &level);
    r->id = place | (bmr_body)(place < w->places ? w->generations[place] : 0) << 32;
    r->birth = w->births;
    if (error == BMR_OK) {
        int64_t column, row;
        bmr_grid_place(w, level, bmr_path_position(&r->now.piece, w->time), &column, &row);
        error = bmr_resident_settle(w, r, level, column, row);
    }
    if (error != BMR_OK) {
        bmr_resident_destroy(w, r);
        if (w->births == 0 && w->def.boundary != BMR_PERIODIC)
            w->unit_x = w->unit_y = 0.0;
        return error;
    }
    w->births++;
    if (place == w->places)
        w->places++;
    w->residents[place] = r;
    w->counts.bodies++;
    bmr_resident_search_later(w, r, w->time);
    *body = r->id;
    return BMR_OK;
}

bmr_error bmr_world_remove(bmr_world *w, bmr_body body) {
    if (!w)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_resident *const r = bmr_world_find(w, body);
    if (!r)
        return BMR_ERROR_OUT_OF_RANGE;
    const size_t place = (size_t)(body & UINT32_MAX);
    w->residents[place] = NULL;
    w->generations[place]++;
    if (place < w->free_place)
        w->free_place = place;
    w->counts.bodies--;
    bmr_resident_destroy(w, r);
    return BMR_OK;
}

bmr_error bmr_world_set_motion(bmr_world *w, bmr_body body, const bmr_motion *motion) {
    if (!w || !motion)
        return BMR_ERROR_NULL_ARGUMENT;
    bmr_resident *const r = bmr_world_find(w, body);
    if (!r)
        return BMR_ERROR_OUT_OF_RANGE;
    bmr_motion_piece piece;
    bmr_motion *plan;
    double until;
    bmr_error error = plan_of(w, motion, &piece, &until, &plan);
    if (error != BMR_OK)
        return error;
    error = bmr_resident_move(w, r, &piece, until, plan);
    if (error != BMR_OK)
        bmr_motion_destroy(plan);
    return error;
}

bmr_error bmr_world_set_piece(bmr_world *w, bmr_body body, const bmr_motion_piece *piece) {
    if (!w || !piece)
        return BMR_ERROR_NULL_ARGUMENT;
    const bmr_error error = bmr_piece_check(piece);
    if (error != BMR_OK)
        return error;
    bmr_resident *const r = bmr_world_find(w, body);
    return r ? bmr_resident_move(w, r, piece, INFINITY, NULL) : BMR_ERROR_OUT_OF_RANGE;
}
