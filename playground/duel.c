// SPDX-License-Identifier: MIT
#include "duel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/// A hand's motions are made anew after so many moves: each is two pieces, 350 bytes each.
#define MOST_HOLDS 2048u
/// Farther than this from the origin, nobody drags a body on purpose.
#define MOST_PLACE 1e3
/// A simulation that is taken on in small steps finds an event by another search than one that runs through,
/// and so at another time, by some failure.tolerance: to be past it, go on by this part of 1 + time.
#define PAST_EVENT 1e-9

static const char *const rivals[PLAY_FOLLOWERS - 1] = {"closest-features", "inner-tangent",
                                                       "separating-edge-walk"};

bool play_is_repair(bmr_kds_event_kind kind) {
    return kind != BMR_KDS_START && kind != BMR_KDS_CONTACT && kind != BMR_KDS_LEAVE && kind != BMR_KDS_NONE;
}

bool play_is_cell(const bmr_kds_info *info) {
    return strncmp(info->name, "active-cell", strlen("active-cell")) == 0;
}

// ---- events ----

static void remember(void *context, const bmr_simulation_event *event) {
    play_duel *duel = context;
    if (event->report.kind == BMR_KDS_START || event->report.kind == BMR_KDS_NONE)
        return;
    duel->latest = (play_event){event->report, event->before, event->after, event->failed, 0.0};
    ++duel->event_count;
}

static void mark(void *context, const bmr_simulation_event *event) {
    play_follower *follower = context;
    ++follower->total[event->report.kind];
    if (event->report.kind != BMR_KDS_START && follower->mark_count < PLAY_MARKS)
        follower->marks[follower->mark_count++] = (play_time_mark){event->time, (double)event->report.kind};
}

// ---- simulations ----

static bmr_error simulate(const play_duel *duel, const bmr_kds_info *info, double time,
                          bmr_simulation_observer observer, void *context, bmr_simulation **simulation) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = info;
    const bmr_shape shapes[2] = {play_body_shape(duel->def.bodies[0]), play_body_shape(duel->def.bodies[1])};
    return bmr_simulation_create(&def, shapes, duel->motions, time, observer, context, NULL, simulation);
}

/// Begins a follower's simulation at the present time; what the one before counted is kept.
static bmr_error begin(play_duel *duel, size_t index) {
    play_follower *follower = &duel->followers[index];
    if (!follower->info)
        return BMR_OK;
    if (follower->simulation) {
        const bmr_simulation_counts counts = bmr_simulation_get_counts(follower->simulation);
        for (int kind = 0; kind < BMR_KDS_EVENT_KIND_COUNT; ++kind)
            follower->ended[kind] += counts.events[kind];
        bmr_simulation_destroy(follower->simulation);
        follower->simulation = NULL;
    }
    return simulate(duel, follower->info, duel->time, index == 0 ? remember : NULL, duel,
                    &follower->simulation);
}

/// Takes a follower to a time. One that stalls (it has event after event at one time) begins anew there.
static bmr_error run(play_duel *duel, size_t index, double time) {
    play_follower *follower = &duel->followers[index];
    if (!follower->simulation)
        return BMR_OK;
    if (bmr_simulation_run(follower->simulation, time) == BMR_OK)
        return BMR_OK;
    duel->time = time;
    return begin(duel, index);
}

/// All of a course, once, for its time line.
static bmr_error survey(play_duel *duel, play_follower *follower) {
    bmr_simulation *simulation;
    if (!follower->info)
        return BMR_OK;
    follower->marks = malloc(PLAY_MARKS * sizeof *follower->marks);
    if (!follower->marks)
        return BMR_ERROR_NO_MEMORY;
    const bmr_error error = simulate(duel, follower->info, 0.0, mark, follower, &simulation);
    if (error != BMR_OK)
        return error;
    bmr_simulation_run(simulation, duel->until); // what stalls has no more marks
    bmr_simulation_destroy(simulation);
    return BMR_OK;
}

// ---- motions ----

static bmr_error rest_at(const bmr_pose *pose, bmr_motion **motion) {
    const bmr_motion_piece piece = bmr_piece_rest(*pose);
    return bmr_motion_create(&piece, NULL, motion);
}

static bmr_error follow_screw(play_duel *duel) {
    const bmr_pose home = bmr_pose_identity();
    const bmr_error error = rest_at(&home, &duel->motions[0]);
    duel->until = duel->def.until;
    return error == BMR_OK ? bmr_motion_create(&duel->def.screw, NULL, &duel->motions[1]) : error;
}

static bmr_error follow_family(play_duel *duel) {
    bmr_family_motion made;
    const bmr_error error = bmr_family_create(&duel->def.family, duel->def.bodies[0]->polygon,
                                              duel->def.bodies[1]->polygon, NULL, &made);
    if (error != BMR_OK)
        return error;
    duel->motions[0] = made.motions[0];
    duel->motions[1] = made.motions[1];
    duel->until = 1.0;
    return BMR_OK;
}

static bmr_error make_motions(play_duel *duel) {
    switch (duel->def.course) {
    case PLAY_SCREW:
        return follow_screw(duel);
    case PLAY_FAMILY:
        return follow_family(duel);
    default:
        break;
    }
    duel->until = INFINITY;
    const bmr_error error = rest_at(&duel->def.poses[0], &duel->motions[0]);
    return error == BMR_OK ? rest_at(&duel->def.poses[1], &duel->motions[1]) : error;
}

// ---- the duel ----

static bmr_error open_duel(play_duel *duel) {
    bmr_error error = make_motions(duel);
    duel->followers[0].info = duel->def.structure;
    for (size_t i = 1; i < PLAY_FOLLOWERS && error == BMR_OK; ++i)
        error = bmr_kds_find(rivals[i - 1], &duel->followers[i].info);
    for (size_t i = 0; i < PLAY_FOLLOWERS && error == BMR_OK; ++i) {
        if (duel->def.course != PLAY_BY_HAND)
            error = survey(duel, &duel->followers[i]);
        if (error == BMR_OK)
            error = begin(duel, i);
    }
    return error;
}

bmr_error play_duel_create(const play_duel_def *def, play_duel **duel) {
    if (!def || !duel || !def->structure || !def->bodies[0] || !def->bodies[1])
        return BMR_ERROR_NULL_ARGUMENT;
    play_duel *made = calloc(1, sizeof *made);
    if (!made)
        return BMR_ERROR_NO_MEMORY;
    made->def = *def;
    const bmr_error error = open_duel(made);
    if (error == BMR_OK)
        *duel = made;
    else
        play_duel_destroy(made);
    return error;
}

void play_duel_destroy(play_duel *duel) {
    if (!duel)
        return;
    for (size_t i = 0; i < PLAY_FOLLOWERS; ++i) {
        bmr_simulation_destroy(duel->followers[i].simulation);
        free(duel->followers[i].marks);
    }
    bmr_motion_destroy(duel->motions[0]);
    bmr_motion_destroy(duel->motions[1]);
    free(duel);
}

/// Back to the beginning of the course: nothing has been counted yet.
static bmr_error rewind_duel(play_duel *duel) {
    duel->time = 0.0;
    duel->latest = (play_event){.report = {.kind = BMR_KDS_START}};
    bmr_error error = BMR_OK;
    for (size_t i = 0; i < PLAY_FOLLOWERS && error == BMR_OK; ++i) {
        error = begin(duel, i);
        memset(duel->followers[i].ended, 0, sizeof duel->followers[i].ended);
    }
    return error;
}

bmr_error play_duel_seek(play_duel *duel, double time) {
    if (isnan(time))
        return BMR_ERROR_NOT_FINITE;
    if (duel->def.course == PLAY_BY_HAND)
        return BMR_OK;
    time = fmin(fmax(time, 0.0), duel->until);
    bmr_error error = time < duel->time ? rewind_duel(duel) : BMR_OK;
    for (size_t i = 0; i < PLAY_FOLLOWERS && error == BMR_OK; ++i)
        error = run(duel, i, time);
    duel->time = time;
    return error;
}

double play_duel_next_event(const play_duel *duel) {
    const play_follower *chosen = &duel->followers[0];
    for (size_t i = 0; i < chosen->mark_count; ++i)
        if (chosen->marks[i].time > duel->time)
            return fmin(chosen->marks[i].time + PAST_EVENT * (1.0 + chosen->marks[i].time), duel->until);
    return duel->until;
}

/// A motion that goes on with nothing but its present pose.
static bmr_error forget_past(play_duel *duel) {
    for (int body = 0; body < 2; ++body) {
        const bmr_pose pose = play_duel_pose(duel, body);
        bmr_motion *fresh;
        const bmr_error error = rest_at(&pose, &fresh);
        if (error != BMR_OK)
            return error;
        // The simulations go by the old motion until they begin anew.
        bmr_motion *const old = duel->motions[body];
        duel->motions[body] = fresh;
        bmr_error begun = BMR_OK;
        for (size_t i = 0; i < PLAY_FOLLOWERS && begun == BMR_OK; ++i)
            begun = begin(duel, i);
        bmr_motion_destroy(old);
        if (begun != BMR_OK)
            return begun;
    }
    duel->holds = 0;
    return BMR_OK;
}

static bool is_pose(const bmr_pose *pose) {
    return fabs(pose->position.x) <= MOST_PLACE && fabs(pose->position.y) <= MOST_PLACE &&
           fabs(hypot(pose->c, pose->s) - 1.0) <= 1e-6;
}

bmr_error play_duel_hold(play_duel *duel, int body, const bmr_pose *pose) {
    if (duel->def.course != PLAY_BY_HAND || body < 0 || body > 1)
        return BMR_ERROR_OUT_OF_RANGE;
    if (!is_pose(pose))
        return BMR_OK;
    if (duel->holds++ >= MOST_HOLDS) {
        const bmr_error error = forget_past(duel);
        if (error != BMR_OK)
            return error;
    }
    const bmr_pose here = play_duel_pose(duel, body);
    const double turn = atan2(here.c * pose->s - here.s * pose->c, here.c * pose->c + here.s * pose->s);
    const double start = duel->time, end = duel->time + 1.0;
    const bmr_motion_piece move = bmr_piece_screw(start, here, bmr_sub(pose->position, here.position), turn);
    bmr_motion *motion = duel->motions[body];
    bmr_error error = bmr_motion_change(motion, start, &move);
    if (error == BMR_OK) {
        const bmr_motion_piece rest = bmr_piece_rest(bmr_motion_pose(motion, end, NULL, NULL));
        error = bmr_motion_change(motion, end, &rest);
    }
    for (size_t i = 0; i < PLAY_FOLLOWERS && error == BMR_OK; ++i) {
        // A search that fails leaves the simulation where it is; then it begins anew.
        if (bmr_simulation_replan(duel->followers[i].simulation) != BMR_OK)
            error = begin(duel, i);
        if (error == BMR_OK)
            error = run(duel, i, end);
        duel->time = start;
    }
    duel->time = end;
    return error;
}

void play_duel_grow_old(play_duel *duel, double seconds) {
    duel->latest.age += seconds;
}

bmr_pose play_duel_pose(const play_duel *duel, int body) {
    return bmr_motion_pose(duel->motions[body], duel->time, NULL, NULL);
}

bmr_pose play_duel_b_in_a(const play_duel *duel) {
    const bmr_pose a = play_duel_pose(duel, 0), b = play_duel_pose(duel, 1);
    return bmr_pose_relative(&a, &b);
}

const bmr_kds *play_duel_kds(const play_duel *duel) {
    bmr_simulation *const simulation = duel->followers[0].simulation;
    return simulation ? bmr_simulation_kds(simulation) : NULL;
}

uint64_t play_duel_count(const play_duel *duel, size_t follower, bmr_kds_event_kind kind) {
    const play_follower *f = &duel->followers[follower];
    return f->ended[kind] + (f->simulation ? bmr_simulation_get_counts(f->simulation).events[kind] : 0);
}

const play_event *play_duel_latest(const play_duel *duel) {
    return duel->latest.report.kind != BMR_KDS_START ? &duel->latest : NULL;
}

#define PI 3.14159265358979323846
/// Corners of A and B: few enough to see each edge, enough for envelopes between the rectangle and the
/// polygon.
static const size_t lesson_corners[2] = {9, 8};
/// Half axes of the ellipses that they are on, and the first corner's angle.
static const double axes[2][2] = {{1.7, 1.05}, {1.35, 0.75}};
static const double first[2] = {0.3, 0.1};

bmr_error play_lesson_body(int body, play_body **made) {
    bmr_vec2 points[16];
    for (size_t i = 0; i < lesson_corners[body]; ++i) {
        const double angle = 2.0 * PI * (double)i / (double)lesson_corners[body] + first[body];
        points[i] = bmr_vec2_make(axes[body][0] * cos(angle), axes[body][1] * sin(angle));
    }
    return play_body_create(points, lesson_corners[body], 1.0, made);
}

/// B comes from the left above A, turning, and sinks a little. Times are seconds. Chosen by trying: with
/// lazy-dudley it begins with a push, a roll and a stab, none nearer than half a second to the next, and has
/// no contact.
play_duel_def play_lesson_def(void) {
    const bmr_pose left = bmr_pose_from_angle(bmr_vec2_make(-4.2, 2.349), -0.989);
    return (play_duel_def){.course = PLAY_SCREW,
                           .screw = bmr_piece_screw(0.0, left, bmr_vec2_make(0.84, -0.0394), 0.253),
                           .until = 10.0};
}
