// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_DUEL_H
#define BOOMERANG_PLAYGROUND_DUEL_H

#include "body.h"
#include "boomerang/simulation.h"

/// @file
/// Two bodies that move, and structures that follow the same motion side by side: the chosen one, and the
/// rivals that the paper compares with. Each structure is a bmr_simulation of its own, so that every event is
/// counted at its own time, also while a hand moves a body: a hand's move from one frame to the next is a
/// screw motion.

/// The chosen structure and the three rivals.
#define PLAY_FOLLOWERS 4u
/// Events of a course that are marked on its time line, of each structure.
#define PLAY_MARKS 4096u

/// How the bodies move.
typedef enum play_course {
    PLAY_BY_HAND, ///< as play_duel_hold says; a unit of time for each call
    PLAY_SCREW,   ///< B on a screw motion while A rests, from time 0 on
    PLAY_FAMILY   ///< one of core's families of motions, from time 0 to 1
} play_course;

typedef struct play_duel_def {
    const bmr_kds_info *structure; ///< the chosen one
    const play_body *bodies[2];    ///< must outlive the duel
    play_course course;
    bmr_pose poses[2];      ///< of BY_HAND: where they begin
    bmr_motion_piece screw; ///< of SCREW: B's motion
    double until;           ///< of SCREW: the end
    bmr_family_def family;  ///< of FAMILY
} play_duel_def;

/// An event of the chosen structure.
typedef struct play_event {
    bmr_kds_report report;
    bmr_kds_proof before, after; ///< as in bmr_simulation_event
    bmr_condition failed;
    double age; ///< seconds for the eye, counted up by play_duel_grow_old
} play_event;

/// When an event of a course comes.
typedef struct play_time_mark {
    double time;
    double kind; ///< bmr_kds_event_kind
} play_time_mark;

/// One structure.
typedef struct play_follower {
    const bmr_kds_info *info;
    bmr_simulation *simulation;               ///< NULL: it does not take this motion
    uint64_t ended[BMR_KDS_EVENT_KIND_COUNT]; ///< events of simulations that were begun anew since
    uint64_t total[BMR_KDS_EVENT_KIND_COUNT]; ///< of a course: in the whole of it
    play_time_mark *marks;                    ///< of a course: the first PLAY_MARKS events of it
    size_t mark_count;
} play_follower;

typedef struct play_duel {
    play_duel_def def;
    bmr_motion *motions[2];
    double until; ///< of a course, which begins at 0; BY_HAND: INFINITY
    double time;
    play_follower followers[PLAY_FOLLOWERS];
    play_event latest;    ///< its report's kind is BMR_KDS_START while there is none
    uint64_t event_count; ///< events of the chosen structure since the beginning
    unsigned holds;       ///< since the motions were made
} play_duel;

/// The structures start at the beginning of the course, which is followed once to its end for the time line.
/// Errors: NULL_ARGUMENT, NO_MEMORY, those of bmr_motion_create, bmr_family_create
/// and bmr_simulation_create; then *duel is untouched. (A structure that stalls on the way has no more marks
/// from there on.)
bmr_error play_duel_create(const play_duel_def *def, play_duel **duel);
/// NULL is no error.
void play_duel_destroy(play_duel *duel);

/// Goes on to a time of the course, or back to it: then all begins anew and runs up to there. Nothing for
/// BY_HAND. Errors: NOT_FINITE, NO_MEMORY.
bmr_error play_duel_seek(play_duel *duel, double time);
/// A time just after the chosen structure's next event (START left out); the course's end where there is
/// none.
double play_duel_next_event(const play_duel *duel);
/// BY_HAND: moves a body (0: A, 1: B) to a pose. A pose that is not finite moves nothing. Errors:
/// OUT_OF_RANGE (another course), NO_MEMORY.
bmr_error play_duel_hold(play_duel *duel, int body, const bmr_pose *pose);
/// So many seconds have passed for the eye.
void play_duel_grow_old(play_duel *duel, double seconds);

/// Where a body is now, and B in A's frame.
bmr_pose play_duel_pose(const play_duel *duel, int body);
bmr_pose play_duel_b_in_a(const play_duel *duel);
/// The chosen structure's pair; NULL after an error that left none.
const bmr_kds *play_duel_kds(const play_duel *duel);
/// Events of a kind so far, of the follower of that index.
uint64_t play_duel_count(const play_duel *duel, size_t follower, bmr_kds_event_kind kind);
/// Is it a structure that holds a cell of the mixed hierarchy?
bool play_is_cell(const bmr_kds_info *info);
/// Does an event count as one: a certificate that failed and was repaired? Starts, contacts and leaves are
/// none.
bool play_is_repair(bmr_kds_event_kind kind);
/// The latest event; NULL: there is none yet.
const play_event *play_duel_latest(const play_duel *duel);

/// A course of a few seconds on which `lazy-dudley` has a push, a stab and a roll early, one after the other.
bmr_error play_lesson_body(int body, play_body **made);
/// All but the structure and the bodies.
play_duel_def play_lesson_def(void);

#endif
