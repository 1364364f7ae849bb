// SPDX-License-Identifier: MIT
#include "lesson.h"

#include <math.h>

#define PI 3.14159265358979323846
/// Corners of A and B: few enough to see each edge, enough for envelopes between the rectangle and the
/// polygon.
static const size_t corners[2] = {9, 8};
/// Half axes of the ellipses that they are on, and the first corner's angle.
static const double axes[2][2] = {{1.7, 1.05}, {1.35, 0.75}};
static const double first[2] = {0.3, 0.1};

/// B comes from the left above A, turning, and sinks a little. Times are seconds. Chosen by trying: with
/// lazy-dudley it begins with a push, a roll and a stab, none nearer than half a second to the next, and has
/// no contact.
static const play_leg legs[] = {
    {.time = 0.0, .x = -4.2, .y = 2.349, .angle = -0.989, .vx = 0.84, .vy = -0.0394, .spin = 0.253}};
#define UNTIL 10.0

bmr_error play_lesson_body(int body, play_body **made) {
    bmr_vec2 points[16];
    for (size_t i = 0; i < corners[body]; ++i) {
        const double angle = 2.0 * PI * (double)i / (double)corners[body] + first[body];
        points[i] = bmr_vec2_make(axes[body][0] * cos(angle), axes[body][1] * sin(angle));
    }
    return play_body_create(points, corners[body], 1.0, made);
}

play_duel_def play_lesson_def(void) {
    return (play_duel_def){
        .course = PLAY_PATH_OF, .legs = legs, .leg_count = sizeof legs / sizeof legs[0], .until = UNTIL};
}
