// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_DRAW_H
#define BOOMERANG_PLAYGROUND_DRAW_H

#include "crowd.h"
#include "display.h"
#include "duel.h"

/// @file
/// Pictures of what the playground does, as items of a display. Each is added to what is there.

/// What is seen of it all.
typedef struct play_frame {
    bmr_vec2 low, high;
} play_frame;

/// Which envelopes are drawn: all levels up to the proof's, or the proof's alone.
typedef enum play_shown_levels { PLAY_NO_LEVELS, PLAY_LEVEL_OF_PROOF, PLAY_ALL_LEVELS } play_shown_levels;

/// How long an event is to be seen, in seconds.
#define PLAY_EVENT_SECONDS 2.5

/// Both bodies, the envelopes, the line, what is watched, the window, and the latest event. `frame` bounds
/// how long the line is drawn.
void play_draw_duel(play_display *display, const play_duel *duel, play_shown_levels shown,
                    const play_frame *frame);
/// The latest event's ring and name at a point; false: there is none, or it has faded.
bool play_draw_event_at(play_display *display, const play_duel *duel, bmr_vec2 where);
/// Both bodies all along a course; `now`, and BY_HAND: around where they are now.
play_frame play_frame_of_duel(const play_duel *duel, bool now);

/// The mixed hierarchy of A (+) (-B) at the present rotation, in A's frame: its cells, the cell that x (the
/// place of B) is in, and x. For structures with a hierarchy; nothing for the others. What there is no memory
/// for is left out.
void play_draw_mixed(play_display *display, const play_duel *duel);
/// All cells, at any rotation, and x.
play_frame play_frame_of_mixed(const play_duel *duel);

/// What of a world is drawn beside its bodies.
enum { PLAY_SHOW_CELLS = 1, PLAY_SHOW_CANDIDATES = 2, PLAY_SHOW_PROOFS = 4 };
void play_draw_crowd(play_display *display, const play_crowd *crowd, unsigned shown);
play_frame play_frame_of_crowd(const play_crowd *crowd);

#endif
