// SPDX-License-Identifier: MIT
// The structures that answer the open question of section 7 (docs/open-question.md has theorem and proofs).
// The line across the closest points fails only after the pair has moved as far as it was apart, and the
// coarse line fails only a logarithm of times on a convex path, however near the path comes. No single line
// has both. None of these needs a hierarchy: two sorted polygons, and O(1) words a pair.
//
//   hybrid     one line: the free direction; nearer than D/N^2 the coarse line. What it is to be is decided
//              at events only, so that crossing that distance is none.
//   two-lines  both lines are made at a repair. The free direction is watched. When it fails and the coarse
//              line stands, that is watched (a handover); when that fails, or did not stand, comes the next
//              repair. As one certificate it is "one line or the other".
//   free-fd2   the free direction alone (two corners): the control, which has more events on convex paths.
//   coarse     the coarse line alone: the control, which has no hysteresis.
// Their bounds, from those of the free direction's steps (free_direction.c) and the coarse line's failures
// (certificate/coarse.c); eta = D/N^2. The bounds of the free direction count disjoint steps, from a choice
// of u to the first failure of that line; anything may happen between two steps. In two-lines every interval
// from repair to repair contains a step and, but for the last, a failure of the coarse line, to which Lemmas
// B and C apply. In hybrid, steps begin at gaps of at least max{sigma, eta}. A step that ends below eta is
// followed by a coarse pick, which pays for it; every other step begins and ends at gaps of at least
// max{sigma, eta}. On a convex path the gap falls while the slope of approach is positive. So there is one
// run of coarse picks, at most one step ends below eta, and a free direction that is made after the run never
// fails. In rigid motions coarse picks are at most one more than failures of coarse lines. If sigma is below
// eta, then D/sigma > N^2 and mu = n.
#include <stddef.h>

#include "kds/registry.h"
#include "kds/windowed_line.h"

typedef enum line_rule { RULE_HYBRID, RULE_TWO_LINES, RULE_FREE, RULE_COARSE } line_rule;

typedef struct line_class {
    bmr_kds_class class; ///< first: an info's implementation is a pointer to it
    line_rule rule;
} line_class;

typedef struct line_state {
    bmr_windowed_line now;
    int8_t spin; ///< the way B turns in A's frame, as far as known
    bool has_spare;
    bmr_windowed_line spare; ///< two-lines, while `now` is the free direction: the coarse line; last, as the
                             ///< others have no room for it
} line_state;

static line_state *state_of(bmr_kds *kds) {
    return (line_state *)(void *)kds->state;
}

/// The gap below which `hybrid` takes the coarse line: D/N^2.
static double threshold(const bmr_kds *kds) {
    const bmr_polygon *a = kds->shapes[0].polygon, *b = kds->shapes[1].polygon;
    const double n = (double)a->count + b->count;
    return 2.0 * (a->radius + b->radius + kds->def.margin) / (n * n);
}

/// Section 7, open question: hysteresis, path-sensitivity and all bounds, in one structure of linear size.
/// New lines. Where no edge separates, which takes a gap of less than half a margin, the free direction
/// does. False: contact.
static bool select_lines(bmr_kds *kds, const bmr_instant *now) {
    line_state *s = state_of(kds);
    const line_rule rule = ((const line_class *)kds->info->implementation)->rule;
    uint32_t support[2] = {s->now.support[0], s->now.support[1]};
    bmr_vec2 u;
    double distance;
    if (!bmr_windowed_closest(kds, &now->pose, support, &u, &distance))
        return false;
    const double gap = distance - kds->def.margin;
    s->has_spare = false;
    if (rule == RULE_COARSE || (rule == RULE_HYBRID && gap < threshold(kds)))
        if (bmr_coarse_line(kds, &now->pose, u, support, &s->now))
            return true;
    bmr_free_direction_lay(kds, now, u, gap, s->spin, support, &s->now);
    if (rule == RULE_TWO_LINES)
        s->has_spare = bmr_coarse_line(kds, &now->pose, u, support, &s->spare);
    return true;
}

static bool start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report) {
    state_of(kds)->spin = (int8_t)bmr_sign(now->spin);
    (void)report;
    return select_lines(kds, now);
}

/// Does the line fail at this instant?
static bool fails(const bmr_windowed_line *line, const bmr_kds *kds, const bmr_instant *now) {
    const bmr_windowed_failure failure = bmr_windowed_fails(line, kds, now);
    return failure.crossed || failure.rolled != 0;
}

/// The way B turns: by the rates of the instant; where these say that nothing turns, by the end of the
/// bracket that was left. A line that was crossed where nothing turns forgets a spin of before: the next
/// bracket leans to no side, and costs nothing. (Its ends are farther away than the short side of a leaning
/// one, so no bound of free_direction.c needs the spin to be remembered.)
static int8_t spin_at(const bmr_instant *now, const bmr_windowed_line *old,
                      const bmr_windowed_failure *failure) {
    if (now->spin != 0.0)
        return (int8_t)bmr_sign(now->spin);
    return (int8_t)(old->owner == 0 ? -failure->rolled : failure->rolled);
}

static bool repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report) {
    (void)failed; // others may have failed at the same time
    line_state *s = state_of(kds);
    const bmr_windowed_line old = s->now;
    const bmr_windowed_failure failure = bmr_windowed_fails(&old, kds, now);
    if (!failure.crossed && failure.rolled == 0)
        return true; // NONE
    s->spin = spin_at(now, &old, &failure);
    if (s->has_spare && !fails(&s->spare, kds, now)) {
        s->now = s->spare;
        s->has_spare = false;
        report->kind = BMR_KDS_HANDOVER;
    } else {
        report->kind = failure.crossed ? BMR_KDS_PUSH : BMR_KDS_ROLL;
        if (!select_lines(kds, now))
            return false;
    }
    report->line_changed = !bmr_windowed_same_line(&old, &s->now);
    return true;
}

typedef unsigned char one_line_state[offsetof(line_state, spare)];

#define LINE_CLASS(state, rule)                                                                              \
    { {BMR_WINDOWED_CLASS(state, start, repair)}, rule }
static const line_class hybrid = LINE_CLASS(one_line_state, RULE_HYBRID),
                        two_lines = LINE_CLASS(line_state, RULE_TWO_LINES),
                        free_fd2 = LINE_CLASS(one_line_state, RULE_FREE),
                        coarse = LINE_CLASS(one_line_state, RULE_COARSE);

BMR_KDS_INFO(hybrid, "hybrid", "Free direction; very near, the coarse line", "7, the open question",
             BMR_KDS_RIGID, BMR_KDS_RECOMMENDED, -1, &hybrid);
BMR_KDS_INFO(two_lines, "two-lines", "Free direction, then the coarse line", "7, the open question",
             BMR_KDS_RIGID, BMR_KDS_RECOMMENDED, -1, &two_lines);
BMR_KDS_INFO(free_fd2, "free-fd2", "Free direction, two corners", "7, the open question", BMR_KDS_RIGID,
             BMR_KDS_CONTROL, -1, &free_fd2);
BMR_KDS_INFO(coarse, "coarse", "The coarse line alone", "7, the open question", BMR_KDS_RIGID,
             BMR_KDS_CONTROL, -1, &coarse);
