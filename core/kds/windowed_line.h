// SPDX-License-Identifier: MIT
#ifndef BMR_KDS_WINDOWED_LINE_H
#define BMR_KDS_WINDOWED_LINE_H

#include <math.h>

#include "boomerang/inflated.h"
#include "certificate/window.h"
#include "kds/structure.h"

/// @file
/// The proof of the structures of section 6 and beyond: a line fixed in one body, and a few points that stand
/// for the whole other body while the line's direction, seen from there, stays in a bracket.

#define BMR_WINDOWED_POINTS 4

typedef struct bmr_windowed_line {
    bmr_line line;                       ///< owner's frame
    bmr_vec2 point[BMR_WINDOWED_POINTS]; ///< other's frame; the first is the one called nearest
    bmr_vec2 low, high;                  ///< the bracket, unit, other's frame; both zero: every direction
    uint8_t owner, count;
    bool fixed; ///< the direction never turns (translation): there is no bracket
    int level;
    uint32_t support[2]; ///< vertices of A and B near which the next search starts
} bmr_windowed_line;

/// What the conditions of a windowed line are labelled: the points from 0 on, and the ends of the bracket.
enum { BMR_WINDOWED_LOW = BMR_WINDOWED_POINTS, BMR_WINDOWED_HIGH };

/// One BEYOND for each point, then two TURNs if there is a bracket.
size_t bmr_windowed_conditions(const bmr_windowed_line *w, double margin, bmr_condition *conditions);
void bmr_windowed_proof(const bmr_windowed_line *w, bmr_kds_proof *proof);
/// Is the window an outer bound of the other polygon throughout the bracket, and the direction in the
/// bracket? By all vertices, O(n).
bmr_error bmr_windowed_audit(const bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a);

/// The part that all classes of this file's lines share. Their state begins with the line.
#define BMR_WINDOWED_CLASS(state, start_function, repair_function)                                           \
    .state_bytes = sizeof(state), .start = (start_function), .repair = (repair_function),                    \
    .conditions = bmr_windowed_own_conditions, .proof = bmr_windowed_own_proof,                              \
    .audit = bmr_windowed_own_audit
size_t bmr_windowed_own_conditions(const bmr_kds *kds, bmr_condition *conditions);
void bmr_windowed_own_proof(const bmr_kds *kds, bmr_kds_proof *proof);
bmr_error bmr_windowed_own_audit(const bmr_kds *kds, const bmr_pose *b_in_a);

/// The failed conditions of a windowed line at an instant.
typedef struct bmr_windowed_failure {
    bool crossed; ///< a point
    int rolled;   ///< 1: past the high end of the bracket, -1: past the low end, 0: neither
} bmr_windowed_failure;
bmr_windowed_failure bmr_windowed_fails(const bmr_windowed_line *w, const bmr_kds *kds,
                                        const bmr_instant *now);

/// Two lines of the same owner, direction and offset?
bool bmr_windowed_same_line(const bmr_windowed_line *a, const bmr_windowed_line *b);

/// The line's direction from A to B, in A's frame.
bmr_vec2 bmr_windowed_direction(const bmr_windowed_line *w, const bmr_pose *b_in_a);

/// Puts the line of `owner` across `direction` (unit, A's frame, from A to B), touching the owner, with no
/// window yet. `support` are vertices near which the support vertices are; they become these. O(1) when they
/// are near, else O(log n).
void bmr_windowed_line_set(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, int owner,
                           bmr_vec2 direction, const uint32_t support[2]);

/// Stands for the other body by its own vertices around the support vertex in the line's direction: exact
/// throughout the bracket, which reaches over the normals of the edges next to them. `sense`: the way in
/// which the direction turns in the other body's frame, 0 if unknown: a further vertex lies on that side. The
/// direction ends up well inside the bracket, by rounding errors' measure. The support vertex is found from
/// the one known. O(1) when that is near, else O(log n).
void bmr_windowed_exact(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, int sense);

/// By two corners of tangents: bmr_window_make's, a bracket that may cost `limit`. Where the polygon's
/// own vertices do better, or the bracket would be lost in rounding: the exact window.
void bmr_windowed_corners(bmr_windowed_line *w, const bmr_kds *kds, const bmr_pose *b_in_a, double limit,
                          int sense);

/// Sets the bracket, of less than half a turn: an end that is farther than a right angle from the direction
/// comes in to there. `low` and `high` (unit, other's frame) are less than three right angles from it, on
/// their sides.
void bmr_windowed_bracket(bmr_windowed_line *w, const bmr_pose *b_in_a, bmr_vec2 low, bmr_vec2 high);
/// Is the direction inside the bracket by more than rounding?
bool bmr_windowed_inside(const bmr_windowed_line *w, const bmr_pose *b_in_a);
/// The direction will never turn: drops the bracket.
void bmr_windowed_fix(bmr_windowed_line *w);

/// Cosine of the angle by which the direction may turn before it leaves the bracket in `sense` (0: on the
/// side that is nearer); -2: it never does.
double bmr_windowed_life(const bmr_windowed_line *w, const bmr_pose *b_in_a, int sense);

/// The time until a condition fails if every one goes on falling at the rate of this instant; INFINITY if
/// none falls.
double bmr_windowed_time(const bmr_windowed_line *w, const bmr_kds *kds, const bmr_instant *now);

static inline int bmr_sign(double x) {
    return (x > 0.0) - (x < 0.0);
}

/// The way in which the direction of `owner`'s line turns in the other body's frame when B spins in A's.
static inline int bmr_windowed_sense(int owner, int spin) {
    return owner == 0 ? -spin : spin;
}

/// A line is taken only where it separates by more than this: the margin, the hysteresis for a pair in
/// contact, and the rounding that separates a gap from none.
double bmr_windowed_least(const bmr_kds *kds);
/// The distance and its direction, as bmr_kds_closest. False: contact, the distance is at most
/// bmr_windowed_least.
bool bmr_windowed_closest(const bmr_kds *kds, const bmr_pose *b_in_a, uint32_t support[2],
                          bmr_vec2 *direction, double *distance);

/// The coarse line (certificate/coarse.h); the other body stands by its own vertices. `closest` is the
/// direction of the closest points; `support` are vertices near the support vertices in it. False: no edge
/// separates by more than bmr_windowed_least. O(log n).
bool bmr_coarse_line(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 closest, const uint32_t support[2],
                     bmr_windowed_line *line);

/// The slack below which an inflated structure takes the coarsest edge where no level keeps its promise: half
/// of what offsets that halve come to on the last of `depth` levels, alpha D / (2 n) or less. Where the
/// offsets shrink more slowly promises end farther out, and until here the edge of most slack is better.
static inline double bmr_coarse_below(const bmr_inflation *inflation, uint32_t depth) {
    return ldexp(inflation->first, -1 - (int)depth);
}

/// FD2's line across a direction (unit, A's frame, from A to B), that of the closest points, `gap` beyond the
/// margin: of the body whose line lasts longer, and two corners for the other one. `spin`: the way B turns in
/// A's frame, as far as known. `support` are vertices near the support vertices. O(log n).
void bmr_free_direction_lay(const bmr_kds *kds, const bmr_instant *now, bmr_vec2 direction, double gap,
                            int spin, const uint32_t support[2], bmr_windowed_line *line);

#endif
