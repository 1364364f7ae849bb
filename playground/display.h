// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PLAYGROUND_DISPLAY_H
#define BOOMERANG_PLAYGROUND_DISPLAY_H

#include <stdbool.h>
#include <stddef.h>

#include "boomerang/vector.h"

/// @file
/// What is to be drawn, as numbers: the page's script draws them and knows nothing of polygons. Items are
/// drawn in their order. An item is PLAY_ITEM_HEAD numbers (mark, ink, strength, label, count) and 2 * count
/// coordinates.

/// How an item's points are drawn.
typedef enum play_mark {
    PLAY_AREA,  ///< filled and outlined, closed
    PLAY_PATH,  ///< a line through the points
    PLAY_DOT,   ///< a small disk at each point
    PLAY_RING,  ///< a circle at each point that is large at strength 0 and small at 1
    PLAY_LABEL, ///< the label's text beside each point
} play_mark;

/// What an item is; the page's style sheet says how it looks.
typedef enum play_ink {
    PLAY_INK_A,          ///< body A
    PLAY_INK_B,          ///< body B
    PLAY_INK_ENVELOPE_A, ///< A's envelope of the proof's level
    PLAY_INK_ENVELOPE_B, ///< B's
    PLAY_INK_LEVEL_A,    ///< another level of A's
    PLAY_INK_LEVEL_B,    ///< another level of B's
    PLAY_INK_LINE,       ///< the line that separates
    PLAY_INK_OLD_LINE,   ///< the line that the last event replaced
    PLAY_INK_WATCHED,    ///< what a condition watches: corners, and their slack
    PLAY_INK_WINDOW,     ///< the cone that the line's direction may be in
    PLAY_INK_EVENT,      ///< an event of the chosen structure
    PLAY_INK_CONTACT,    ///< a contact
    PLAY_INK_TRIANGLE_A, ///< cells of the mixed hierarchy: A's triangles
    PLAY_INK_TRIANGLE_B, ///< B's
    PLAY_INK_PARALLELOGRAM,
    PLAY_INK_SUM,       ///< where the bodies overlap
    PLAY_INK_CELL,      ///< the cell that x is in
    PLAY_INK_POINT,     ///< x
    PLAY_INK_BOX,       ///< a world's walls
    PLAY_INK_GRID,      ///< a world's cells
    PLAY_INK_CANDIDATE, ///< two bodies whose disks are watched
    PLAY_INK_NEAR,      ///< two bodies with a structure
    PLAY_INK_SKETCH,    ///< corners being drawn
} play_ink;

#define PLAY_ITEM_HEAD 5u
/// No label.
#define PLAY_NO_LABEL (-1)

typedef struct play_display {
    float *numbers;
    size_t count, capacity;
} play_display;

/// Nothing to draw; keeps its memory. Begin with a display of zeros.
void play_display_clear(play_display *display);
void play_display_free(play_display *display);
/// `strength` in [0, 1]: how far it is faded in. `label`: see play_label_text (words.h). No points, or no
/// memory for them: nothing.
void play_display_add(play_display *display, play_mark mark, play_ink ink, double strength, int label,
                      const bmr_vec2 *points, size_t count);

#endif
