// SPDX-License-Identifier: MIT
#include "display.h"

#include <stdlib.h>

/// Of the first block, in numbers: a picture of two bodies of a hundred corners.
#define FIRST_CAPACITY 4096u

void play_display_clear(play_display *display) {
    display->count = 0;
}

void play_display_free(play_display *display) {
    free(display->numbers);
    *display = (play_display){0};
}

static bool reserve(play_display *display, size_t more) {
    size_t capacity = display->capacity > 0 ? display->capacity : FIRST_CAPACITY;
    while (capacity - display->count < more)
        capacity *= 2;
    if (capacity == display->capacity)
        return true;
    float *numbers = realloc(display->numbers, capacity * sizeof *numbers);
    if (!numbers)
        return false;
    display->numbers = numbers;
    display->capacity = capacity;
    return true;
}

void play_display_add(play_display *display, play_mark mark, play_ink ink, double strength, int label,
                      const bmr_vec2 *points, size_t count) {
    if (count == 0 || !reserve(display, PLAY_ITEM_HEAD + 2 * count))
        return;
    float *out = display->numbers + display->count;
    *out++ = (float)mark;
    *out++ = (float)ink;
    *out++ = (float)strength;
    *out++ = (float)label;
    *out++ = (float)count;
    for (size_t i = 0; i < count; ++i) {
        *out++ = (float)points[i].x;
        *out++ = (float)points[i].y;
    }
    display->count += PLAY_ITEM_HEAD + 2 * count;
}
