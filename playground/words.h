// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_WORDS_H
#define BOOMERANG_PLAYGROUND_WORDS_H

#include "crowd.h"
#include "duel.h"

/// @file
/// What the page says: the same sentences for those who see it and for those who hear it read. All write at
/// most `size` bytes with a 0 at the end (size > 0) and return the length of what they wrote.

/// Labels in a picture: those of events are their bmr_kds_event_kind.
enum { PLAY_LABEL_A = BMR_KDS_EVENT_KIND_COUNT, PLAY_LABEL_B, PLAY_LABEL_X };
/// "A", "B", "x", "stab"; NULL for anything else.
const char *play_label_text(int label);

/// The chosen structure's level and the deepest there is. A structure without a hierarchy has level 0 of 0;
/// level -1: outside of all envelopes, or in contact.
typedef struct play_levels {
    int level, deepest;
} play_levels;
play_levels play_levels_of(const play_duel *duel);

/// The certificate as it is now: whose line, which level, and the slack of each condition.
size_t play_describe_proof(const play_duel *duel, char *text, size_t size);
/// What an event was, in two or three sentences. NULL: that none has been yet. `cell`: of a structure that
/// holds a cell.
size_t play_describe_event(const play_event *event, bool cell, char *text, size_t size);
/// What a kind of event is, in a sentence or two; NULL for a number that is none.
const char *play_explain(bmr_kds_event_kind kind, bool cell);
/// "12 events: 4 pushes, 3 stabs, 5 rolls. Rivals: closest-features 47, ..".
size_t play_describe_counts(const play_duel *duel, char *text, size_t size);
/// The same of a world: bodies, contacts, events a body and unit of time, energy kept.
size_t play_describe_crowd(const play_crowd *crowd, char *text, size_t size);

#endif
