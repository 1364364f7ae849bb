// SPDX-License-Identifier: MIT
#include "page.h"

#include <math.h>
#include <stdlib.h>

#include "boomerang/distance.h"
#include "draw.h"
#include "words.h"

#define TEXT_SIZE 1024u
/// The largest whole number that a seed may be: all of them are exact in a double.
#define MOST_SEED 4294967295.0

struct play_page {
    play_body *bodies[2];
    play_duel *duel;
    play_crowd *crowd;
    bmr_vec2 sketch[PLAY_MOST_CORNERS];
    size_t sketched;
    play_display display;
    double frame[4];
    char text[TEXT_SIZE];
};

play_page *play_open(void) {
    return calloc(1, sizeof(play_page));
}

void play_close(play_page *page) {
    if (!page)
        return;
    play_duel_destroy(page->duel);
    play_crowd_destroy(page->crowd);
    play_body_destroy(page->bodies[0]);
    play_body_destroy(page->bodies[1]);
    play_display_free(&page->display);
    free(page);
}

// ---- choices ----

static const bmr_kds_info *structure_at(int structure) {
    return structure < 0 ? NULL : bmr_kds_at((size_t)structure);
}
static uint64_t seed_of(double seed) {
    return seed >= 0.0 && seed <= MOST_SEED ? (uint64_t)seed : 1;
}

int play_structure_count(void) {
    return (int)bmr_kds_count();
}
const char *play_structure_name(int structure) {
    const bmr_kds_info *info = structure_at(structure);
    return info ? info->name : NULL;
}
const char *play_structure_title(int structure) {
    const bmr_kds_info *info = structure_at(structure);
    return info ? info->title : NULL;
}
int play_structure_is_offered(int structure) {
    const bmr_kds_info *info = structure_at(structure);
    return info && info->domain == BMR_KDS_RIGID;
}
int play_structure_role(int structure) {
    const bmr_kds_info *info = structure_at(structure);
    return info ? (int)info->role : 0;
}
int play_structure_find(const char *name) {
    for (int i = 0; i < play_structure_count(); ++i) {
        const bmr_kds_info *found;
        if (bmr_kds_find(name, &found) == BMR_OK && found == structure_at(i))
            return i;
    }
    return -1;
}
int play_family_count(void) {
    return BMR_FAMILY_COUNT;
}
const char *play_family_name(int family) {
    return bmr_family_name((bmr_family)family);
}
int play_ngon_count(void) {
    return BMR_NGON_COUNT;
}
const char *play_ngon_name(int ngon) {
    return bmr_ngon_name((bmr_ngon)ngon);
}
const char *play_event_name(int kind) {
    return bmr_kds_event_name((bmr_kds_event_kind)kind);
}
const char *play_event_meaning(int kind, int cell) {
    return play_explain((bmr_kds_event_kind)kind, cell != 0);
}

// ---- bodies ----

static void end_duel(play_page *page) {
    play_duel_destroy(page->duel);
    page->duel = NULL;
}

static void put_body(play_page *page, int body, play_body *made) {
    end_duel(page);
    play_body_destroy(page->bodies[body]);
    page->bodies[body] = made;
}

static bool is_body(int body) {
    return body == 0 || body == 1;
}

int play_set_ngon(play_page *page, int body, int ngon, int n, double seed) {
    play_body *made;
    if (!is_body(body) || n < 3 || ngon < 0 || ngon >= BMR_NGON_COUNT)
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_error error = play_body_create_ngon((bmr_ngon)ngon, (size_t)n, seed_of(seed), 1.0, &made);
    if (error == BMR_OK)
        put_body(page, body, made);
    return (int)error;
}

void play_sketch_clear(play_page *page) {
    page->sketched = 0;
}

int play_sketch_add(play_page *page, double x, double y) {
    if (isfinite(x + y) && page->sketched < PLAY_MOST_CORNERS)
        page->sketch[page->sketched++] = bmr_vec2_make(x, y);
    return (int)page->sketched;
}

int play_sketch_take(play_page *page, int body) {
    play_body *made;
    if (!is_body(body))
        return BMR_ERROR_OUT_OF_RANGE;
    const bmr_error error = play_body_create(page->sketch, page->sketched, 1.0, &made);
    if (error == BMR_OK)
        put_body(page, body, made);
    return (int)error;
}

// ---- two bodies ----

static int use(play_page *page, play_duel_def *def) {
    if (!page->bodies[0] || !page->bodies[1] || !def->structure || def->structure->domain != BMR_KDS_RIGID)
        return BMR_ERROR_OUT_OF_RANGE;
    def->bodies[0] = page->bodies[0];
    def->bodies[1] = page->bodies[1];
    play_duel *made;
    const bmr_error error = play_duel_create(def, &made);
    if (error != BMR_OK)
        return (int)error;
    end_duel(page);
    page->duel = made;
    return BMR_OK;
}

int play_use_lesson(play_page *page, int structure) {
    for (int body = 0; body < 2; ++body) {
        play_body *made;
        const bmr_error error = play_lesson_body(body, &made);
        if (error != BMR_OK)
            return (int)error;
        put_body(page, body, made);
    }
    play_duel_def def = play_lesson_def();
    def.structure = structure_at(structure);
    return use(page, &def);
}

int play_use_family(play_page *page, int structure, int family, double ratio, double seed) {
    if (family < 0 || family >= BMR_FAMILY_COUNT)
        return BMR_ERROR_OUT_OF_RANGE;
    play_duel_def def = {.structure = structure_at(structure), .course = PLAY_FAMILY};
    def.family = (bmr_family_def){.family = (bmr_family)family, .ratio = ratio, .seed = seed_of(seed)};
    return use(page, &def);
}

int play_use_hand(play_page *page, int structure, double ax, double ay, double a_angle, double bx, double by,
                  double b_angle) {
    play_duel_def def = {.structure = structure_at(structure), .course = PLAY_BY_HAND};
    def.poses[0] = bmr_pose_from_angle(bmr_vec2_make(ax, ay), a_angle);
    def.poses[1] = bmr_pose_from_angle(bmr_vec2_make(bx, by), b_angle);
    return use(page, &def);
}

int play_seek(play_page *page, double time) {
    return page->duel ? (int)play_duel_seek(page->duel, time) : BMR_ERROR_OUT_OF_RANGE;
}

int play_hold(play_page *page, int body, double x, double y, double angle) {
    const bmr_pose pose = bmr_pose_from_angle(bmr_vec2_make(x, y), angle);
    return page->duel ? (int)play_duel_hold(page->duel, body, &pose) : BMR_ERROR_OUT_OF_RANGE;
}

void play_grow_old(play_page *page, double seconds) {
    if (page->duel)
        play_duel_grow_old(page->duel, seconds);
}

double play_time(const play_page *page) {
    return page->duel ? page->duel->time : 0.0;
}
double play_until(const play_page *page) {
    return page->duel ? page->duel->until : 0.0;
}
double play_next_event(const play_page *page) {
    return page->duel ? play_duel_next_event(page->duel) : 0.0;
}

double play_place(const play_page *page, int body, int which) {
    if (!page->duel || !is_body(body))
        return 0.0;
    const bmr_pose pose = play_duel_pose(page->duel, body);
    switch (which) {
    case 0:
        return pose.position.x;
    case 1:
        return pose.position.y;
    case 2:
        return atan2(pose.s, pose.c);
    case 3:
        return page->bodies[body]->polygon->radius;
    case 4:
        return (double)page->bodies[body]->polygon->count;
    default:
        return 0.0;
    }
}

double play_distance(const play_page *page) {
    bmr_closest_points closest;
    if (!page->duel)
        return 0.0;
    const bmr_pose a = play_duel_pose(page->duel, 0), b = play_duel_pose(page->duel, 1);
    const bmr_error error =
        bmr_distance(page->bodies[0]->polygon, &a, page->bodies[1]->polygon, &b, &closest);
    return error == BMR_OK ? closest.distance : 0.0;
}

double play_diameter(const play_page *page) {
    if (!page->duel)
        return 0.0;
    return fmax(bmr_polygon_diameter(page->bodies[0]->polygon),
                bmr_polygon_diameter(page->bodies[1]->polygon));
}

int play_level(const play_page *page) {
    return page->duel ? play_levels_of(page->duel).level : -1;
}
int play_deepest(const play_page *page) {
    return page->duel ? play_levels_of(page->duel).deepest : 0;
}

int play_follower_count(void) {
    return PLAY_FOLLOWERS;
}

static const play_follower *follower_at(const play_page *page, int follower) {
    return page->duel && follower >= 0 && follower < (int)PLAY_FOLLOWERS ? &page->duel->followers[follower]
                                                                         : NULL;
}
static bool is_kind(int kind) {
    return kind >= 0 && kind < BMR_KDS_EVENT_KIND_COUNT;
}

int play_follower_structure(const play_page *page, int follower) {
    const play_follower *f = follower_at(page, follower);
    return f ? play_structure_find(f->info->name) : -1;
}
double play_events(const play_page *page, int follower, int kind) {
    return follower_at(page, follower) && is_kind(kind)
               ? (double)play_duel_count(page->duel, (size_t)follower, (bmr_kds_event_kind)kind)
               : 0.0;
}
double play_events_in_all(const play_page *page, int follower, int kind) {
    const play_follower *f = follower_at(page, follower);
    return f && is_kind(kind) ? (double)f->total[kind] : 0.0;
}
int play_counts(int kind) {
    return is_kind(kind) && play_is_repair((bmr_kds_event_kind)kind);
}
const double *play_marks(const play_page *page, int follower) {
    const play_follower *f = follower_at(page, follower);
    return f && f->marks ? &f->marks->time : NULL;
}
int play_mark_count(const play_page *page, int follower) {
    const play_follower *f = follower_at(page, follower);
    return f ? (int)f->mark_count : 0;
}
double play_event_count(const play_page *page) {
    return page->duel ? (double)page->duel->event_count : 0.0;
}
int play_latest(const play_page *page) {
    const play_event *event = page->duel ? play_duel_latest(page->duel) : NULL;
    return event ? (int)event->report.kind : -1;
}

// ---- many bodies ----

int play_use_crowd(play_page *page, int structure, int bodies, int corners, double packing, double seed) {
    const play_crowd_def def = {.structure = structure_at(structure),
                                .bodies = bodies > 0 ? (size_t)bodies : 0,
                                .corners = corners > 0 ? (size_t)corners : 0,
                                .packing = packing,
                                .seed = seed_of(seed)};
    play_crowd *made;
    const bmr_error error = play_crowd_create(&def, &made);
    if (error != BMR_OK)
        return (int)error;
    play_crowd_destroy(page->crowd);
    page->crowd = made;
    return BMR_OK;
}

int play_crowd_go(play_page *page, double time, double seconds) {
    return page->crowd ? (int)play_crowd_advance(page->crowd, time, seconds) : BMR_ERROR_OUT_OF_RANGE;
}

int play_crowd_kick(play_page *page, double x, double y, double vx, double vy) {
    return page->crowd ? (int)play_crowd_push(page->crowd, bmr_vec2_make(x, y), bmr_vec2_make(vx, vy))
                       : BMR_ERROR_OUT_OF_RANGE;
}

// ---- pictures and words ----

static bool has_picture(const play_page *page, int picture) {
    return picture == PLAY_PICTURE_CROWD ? page->crowd != NULL
                                         : (picture == PLAY_PICTURE_DUEL || picture == PLAY_PICTURE_MIXED ||
                                            picture == PLAY_FRAME_NOW) &&
                                               page->duel;
}

/// The corners, and what they would become.
static void draw_sketch(play_page *page) {
    play_display_add(&page->display, PLAY_DOT, PLAY_INK_SKETCH, 1.0, PLAY_NO_LABEL, page->sketch,
                     page->sketched);
    bmr_polygon *hull;
    if (page->sketched < 2 || bmr_polygon_create(page->sketch, page->sketched, NULL, &hull) != BMR_OK)
        return;
    play_display_add(&page->display, PLAY_PATH, PLAY_INK_SKETCH, 1.0, PLAY_NO_LABEL, hull->vertices,
                     hull->count);
    const bmr_vec2 ends[2] = {hull->vertices[hull->count - 1], hull->vertices[0]};
    play_display_add(&page->display, PLAY_PATH, PLAY_INK_SKETCH, 1.0, PLAY_NO_LABEL, ends, 2);
    bmr_polygon_destroy(hull, NULL);
}

int play_draw(play_page *page, int picture, int option) {
    play_display_clear(&page->display);
    if (!has_picture(page, picture) || picture == PLAY_FRAME_NOW)
        return 0;
    if (picture == PLAY_PICTURE_CROWD) {
        play_draw_crowd(&page->display, page->crowd, (unsigned)option);
    } else if (picture == PLAY_PICTURE_MIXED) {
        play_draw_mixed(&page->display, page->duel);
    } else {
        const play_frame frame = play_frame_of_duel(page->duel, false);
        play_draw_duel(&page->display, page->duel, (play_shown_levels)option, &frame);
        draw_sketch(page);
    }
    return (int)page->display.count;
}

const float *play_numbers(const play_page *page) {
    return page->display.numbers;
}

const double *play_frame_of(play_page *page, int picture) {
    play_frame frame = {{-1.0, -1.0}, {1.0, 1.0}};
    if (has_picture(page, picture))
        frame = picture == PLAY_PICTURE_CROWD   ? play_frame_of_crowd(page->crowd)
                : picture == PLAY_PICTURE_MIXED ? play_frame_of_mixed(page->duel)
                                                : play_frame_of_duel(page->duel, picture == PLAY_FRAME_NOW);
    page->frame[0] = frame.low.x;
    page->frame[1] = frame.low.y;
    page->frame[2] = frame.high.x;
    page->frame[3] = frame.high.y;
    return page->frame;
}

const char *play_text(play_page *page, int which) {
    page->text[0] = '\0';
    if (which == PLAY_TEXT_CROWD) {
        if (page->crowd)
            play_describe_crowd(page->crowd, page->text, TEXT_SIZE);
    } else if (page->duel) {
        if (which == PLAY_TEXT_PROOF)
            play_describe_proof(page->duel, page->text, TEXT_SIZE);
        else if (which == PLAY_TEXT_EVENT)
            play_describe_event(play_duel_latest(page->duel), play_is_cell(page->duel->def.structure),
                                page->text, TEXT_SIZE);
        else if (which == PLAY_TEXT_COUNTS)
            play_describe_counts(page->duel, page->text, TEXT_SIZE);
    }
    return page->text;
}

const char *play_label(int label) {
    return play_label_text(label);
}
const char *play_error_text(int error) {
    return error > 0 && error < BMR_ERROR_COUNT ? bmr_error_describe((bmr_error)error) : "";
}
