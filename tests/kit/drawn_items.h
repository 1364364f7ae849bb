// SPDX-License-Identifier: MIT
#ifndef BMR_TEST_DRAWN_ITEMS_H
#define BMR_TEST_DRAWN_ITEMS_H

#include "draw.h"
#include "page.h"

/// @file
/// Items of a picture of the playground's page, found in its numbers. In C.

typedef struct item {
    int mark, ink, label;
    size_t count;
    const float *points;
} item;

/// The first item of an ink (and mark) at or after `at`; *at moves behind it. False: there is none.
static inline bool find_item(const play_page *page, int numbers, int mark, int ink, int *at, item *found) {
    const float *all = play_numbers(page);
    *found = (item){0};
    while (*at < numbers) {
        const float *head = all + *at;
        const size_t count = (size_t)head[4];
        *at += (int)(PLAY_ITEM_HEAD + 2 * count);
        if ((int)head[0] == mark && (int)head[1] == ink) {
            *found = (item){mark, ink, (int)head[3], count, head + PLAY_ITEM_HEAD};
            return true;
        }
    }
    return false;
}
static inline bool first_item(const play_page *page, int numbers, int mark, int ink, item *found) {
    int at = 0;
    return find_item(page, numbers, mark, ink, &at, found);
}
static inline bmr_vec2 point_of(const item *of, size_t i) {
    i %= of->count;
    return bmr_vec2_make((double)of->points[2 * i], (double)of->points[2 * i + 1]);
}
static inline double area_of(const item *of) {
    double twice = 0.0;
    for (size_t i = 0; i < of->count; ++i)
        twice += bmr_cross(point_of(of, i), point_of(of, i + 1));
    return 0.5 * twice;
}
/// Is a point in an area, up to `slop`?
static inline bool holds(const item *area, bmr_vec2 point, double slop) {
    for (size_t i = 0; i < area->count; ++i) {
        const bmr_vec2 from = point_of(area, i), side = bmr_sub(point_of(area, i + 1), from);
        const double length = hypot(side.x, side.y);
        if (length > 1e-6 && bmr_cross(side, bmr_sub(point, from)) < -slop * length)
            return false;
    }
    return true;
}

#endif
