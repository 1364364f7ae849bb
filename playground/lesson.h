// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_LESSON_H
#define BOOMERANG_PLAYGROUND_LESSON_H

#include "duel.h"

/// @file
/// A course of a few seconds on which `lazy-dudley` has a push, a stab and a roll early, one after the other.

bmr_error play_lesson_body(int body, play_body **made);
/// All but the structure and the bodies.
play_duel_def play_lesson_def(void);

#endif
