// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_PAGE_H
#define BOOMERANG_PLAYGROUND_PAGE_H

#include <stdint.h>

/// @file
/// The playground as the page's script calls it: plain numbers in and out, one play_page for all. Lengths are
/// those of the picture (a body's diameter is about 2), angles in radians. What takes an index or a number
/// that makes no sense answers with an error, or does nothing, and never breaks off.

typedef struct play_page play_page;

/// NULL: no memory.
play_page *play_open(void);
void play_close(play_page *page);

// ---- what there is to choose from ----

/// Structures (indices of bmr_kds_at), families of motions and kinds of polygons. NULL, or 0, for an index
/// beyond.
int play_structure_count(void);
const char *play_structure_name(int structure);
const char *play_structure_title(int structure);
/// 1: it takes two bodies in any motion, which all that is offered must.
int play_structure_is_offered(int structure);
/// bmr_kds_role.
int play_structure_role(int structure);
/// -1: none of that name.
int play_structure_find(const char *name);
int play_family_count(void);
const char *play_family_name(int family);
int play_ngon_count(void);
const char *play_ngon_name(int ngon);
/// Names and meanings of events: bmr_kds_event_name, and play_explain (words.h).
const char *play_event_name(int kind);
const char *play_event_meaning(int kind, int cell);

// ---- bodies: each call ends the duel that was ----

/// Body 0 or 1 becomes a polygon of n corners. Returns a bmr_error.
int play_set_ngon(play_page *page, int body, int ngon, int n, double seed);
/// Corners one by one, and then the hull of them. play_sketch_add returns how many there are by now, as
/// many as before where there is no room or the point is not finite. play_sketch_take returns a bmr_error.
void play_sketch_clear(play_page *page);
int play_sketch_add(play_page *page, double x, double y);
int play_sketch_take(play_page *page, int body);

// ---- two bodies: all return a bmr_error ----

/// A short course on which every event of the lazy structure comes, with bodies of its own.
int play_use_lesson(play_page *page, int structure);
/// The bodies that are set, on a motion of a family.
int play_use_family(play_page *page, int structure, int family, double ratio, double seed);
/// The bodies that are set, by hand: at (x, y, angle) of A and of B.
int play_use_hand(play_page *page, int structure, double ax, double ay, double a_angle, double bx, double by,
                  double b_angle);
int play_seek(play_page *page, double time);
int play_hold(play_page *page, int body, double x, double y, double angle);
/// So many seconds have passed for the eye.
void play_grow_old(play_page *page, double seconds);

double play_time(const play_page *page);
double play_until(const play_page *page);
double play_next_event(const play_page *page);
/// A body's place: 0: x, 1: y, 2: angle, 3: radius of its disk, 4: corners.
double play_place(const play_page *page, int body, int which);
/// The exact distance now, 0 where they overlap; and the larger diameter.
double play_distance(const play_page *page);
double play_diameter(const play_page *page);
/// The proof's level and the deepest there is, see play_levels (words.h).
int play_level(const play_page *page);
int play_deepest(const play_page *page);
/// Followers: 0 is the chosen structure, the others are rivals. Index of bmr_kds_at; -1: none.
int play_follower_count(void);
int play_follower_structure(const play_page *page, int follower);
/// Events so far, and of the whole course.
double play_events(const play_page *page, int follower, int kind);
double play_events_in_all(const play_page *page, int follower, int kind);
/// 1: it counts as an event (play_is_repair).
int play_counts(int kind);
/// Events of a course on its time line: pairs (time, kind). Valid until the next play_use_.. or play_set_...
const double *play_marks(const play_page *page, int follower);
int play_mark_count(const play_page *page, int follower);
/// Events of the chosen structure so far, and the kind of the latest (-1: none).
double play_event_count(const play_page *page);
int play_latest(const play_page *page);

// ---- many bodies: return a bmr_error ----

int play_use_crowd(play_page *page, int structure, int bodies, int corners, double packing, double seed);
int play_crowd_go(play_page *page, double time, double seconds);
int play_crowd_kick(play_page *page, double x, double y, double vx, double vy);

// ---- pictures and words ----

/// What is drawn: bodies and proof, the mixed hierarchy, the crowd.
enum { PLAY_PICTURE_DUEL, PLAY_PICTURE_MIXED, PLAY_PICTURE_CROWD };
/// A frame that is no picture's: of the two bodies where they are now.
enum { PLAY_FRAME_NOW = PLAY_PICTURE_CROWD + 1 };
/// Draws and returns how many numbers there are (display.h). `option`: play_shown_levels of a duel,
/// PLAY_SHOW_.. of a crowd. The numbers are valid until the next call of this.
int play_draw(play_page *page, int picture, int option);
const float *play_numbers(const play_page *page);
/// Four numbers: what is to be seen of a picture, low and high corner.
const double *play_frame_of(play_page *page, int picture);

/// A sentence or more (words.h); valid until the next call of this.
enum { PLAY_TEXT_PROOF, PLAY_TEXT_EVENT, PLAY_TEXT_COUNTS, PLAY_TEXT_CROWD };
const char *play_text(play_page *page, int which);
const char *play_label(int label);
const char *play_error_text(int error);

#endif
