// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PAIR_H
#define BOOMERANG_PAIR_H

#include <float.h>

#include "boomerang/certificate.h"
#include "boomerang/hierarchy.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// A kinetic structure for one pair of moving convex polygons A and B, in sampled mode: the caller advances
/// it from one relative pose to the next, and it answers "apart, by at least this much" or "stab on the real
/// polygon". Sections 3 and 5 of the paper (lazy), section 7's open question (free direction).
///
/// Poses are of B's frame in A's frame throughout. Nothing here allocates. A pair is plain data and may be
/// copied.
///
/// A pair belongs to the two polygons of its last advance, A and B in this order. It knows them by their
/// stamps (bmr_polygon), not by their addresses. Other polygons pass for these two with a probability of
/// 2^-32; A and B exchanged pass with 2^-31. An advance with polygons of other vertices, or with A and B
/// exchanged, starts the pair anew, as bmr_pair_init would. So a polygon may be replaced without a call, also
/// by one at the same address. A copy of a polygon is the same polygon. Do not write to a polygon in place:
/// it would keep its stamp (bmr_polygon_audit finds it).
///
/// A lazy structure walks on the hierarchies of a bmr_shape, at the index of their kind. NULL, one of another
/// kind and one of another polygon are no hierarchy. A hierarchy knows its polygon by address and stamp
/// together: if its polygon was freed, it does not fit a polygon of other vertices at the same address.
/// Polygons and hierarchies need only live during each call.

/// The kinetic structures in sampled mode.
typedef enum bmr_structure {
    /// An edge of one envelope and a corner of the other, on compass hierarchies. (At the polygons
    /// themselves, if the gap is within a factor of sqrt(2) of the margin, the closest direction replaces the
    /// edge.)
    BMR_LAZY_COMPASS,
    BMR_LAZY_DUDLEY,    ///< the same on Dudley hierarchies
    BMR_FREE_DIRECTION, ///< closest direction fixed in one body, a window of two corners in the other
    /// The free direction and the coarse line (docs/open-question.md): both are made at a repair. When the
    /// free direction fails and the coarse line separates, that is taken; when it fails, too, comes the next
    /// repair.
    BMR_TWO_LINES,
    BMR_STRUCTURE_COUNT
} bmr_structure;

/// "lazy-compass", "lazy-dudley", "free-direction", "two-lines"; NULL for anything else.
const char *bmr_structure_name(bmr_structure structure);

/// Settings of a structure. Constant; many pairs may share them.
typedef struct bmr_pair_def {
    /// A lazy structure needs the hierarchies of both shapes. If one is missing, or the number names no
    /// structure, the pair works as a free direction, which needs none; nor does two-lines. Answers, bounds
    /// and audits are the same; the events differ (it has one level below the disks, and starts with a
    /// distance query). The structure may change between two advances: the pair then starts anew at its next
    /// repair.
    bmr_structure structure;
    /// The pair is in contact if no line proves more than this; >= 0, length units.
    double margin;
    /// A pair leaves contact only if more than margin + hysteresis is proved; >= 0, length units.
    double hysteresis;
} bmr_pair_def;
/// lazy-compass, margin 0, hysteresis 0. With these, shapes need no hierarchy, and are faster with one.
bmr_pair_def bmr_default_pair_def(void);

/// Kinds of events, in the paper's words. One repair is one of START, PUSH, STAB, ROLL, CONTACT, LEAVE and
/// HANDOVER, followed by one COARSEN for each level that it then gained. The only levels of the free
/// direction and of two-lines are the disks and the polygons; their PUSH and ROLL both mean that the closest
/// direction was taken anew.
typedef enum bmr_event_kind {
    BMR_EVENT_START,    ///< a certificate was made from nothing
    BMR_EVENT_PUSH,     ///< the window crossed the line, and another line of the same level separates
    BMR_EVENT_STAB,     ///< the envelopes of this level touch: refined to a deeper level
    BMR_EVENT_ROLL,     ///< the direction left the window's bracket
    BMR_EVENT_COARSEN,  ///< a coarser level was found to be apart (one event for each level gained)
    BMR_EVENT_CONTACT,  ///< the stab reached the real polygons: use an exact test
    BMR_EVENT_LEAVE,    ///< the pair left contact
    BMR_EVENT_HANDOVER, ///< two-lines: the free direction failed, and the coarse line separates
    BMR_EVENT_KIND_COUNT
} bmr_event_kind;
/// "start", "push", "stab", "roll", "coarsen", "contact", "leave", "handover"; NULL for anything else.
const char *bmr_event_name(bmr_event_kind kind);

/// The level above the bounding rectangle: two bounding disks.
#define BMR_LEVEL_DISKS (-1)

/// The whole state of a pair: 64 bytes. Align it to 64 if a check shall touch one cache line. Read it; do not
/// write it.
typedef struct bmr_pair {
    bmr_certificate certificate; ///< 44 bytes; at level -1 normal = centre of A's disk, window[0] = that of
                                 ///< B's, offset = sum of radii
    uint8_t simplex : 2;   ///< in contact: how many vertex pairs (a | b << 16) are remembered in edge, other,
                           ///< other_after
    uint8_t structure : 2; ///< bmr_structure that edge, other and other_after are of
    uint8_t free : 1; ///< lazy: 1 if the line is that of the closest direction, because no edge's line does;
                      ///< two-lines: 1 if it is the free direction, 0 if it is the coarse line
    int8_t spin : 2;  ///< free: the sense in which B turned out of the last bracket: -1, 0 (unknown) or 1
    uint8_t owner;    ///< 0: the line is A's; 1: it is B's
    uint8_t state;    ///< bmr_pair_state
    int8_t level;     ///< -1 disks, 0 rectangles, ...; free direction: 0; in contact: the deepest
    uint32_t edge;    ///< lazy: the owner's edge id; else: support vertex of the owner
    uint32_t other;   ///< lazy: `before` of the other's corner; else: support vertex of the other
    uint32_t other_after; ///< lazy: `after` of the other's corner (its `cut` follows from the level);
                          ///< two-lines: the coarse line of the last repair, packed
    uint32_t stamp;       ///< of the polygons of the last advance, A and B in this order
} bmr_pair;

typedef enum bmr_pair_state {
    BMR_PAIR_NEW,    ///< nothing known: the next advance starts it
    BMR_PAIR_APART,  ///< holds a certificate
    BMR_PAIR_CONTACT ///< the last stab reached the real polygons
} bmr_pair_state;

typedef enum bmr_answer {
    BMR_APART,       ///< the polygons are more than the margin apart
    BMR_STAB_POLYGON ///< they are not known to be: ask an exact test
} bmr_answer;

/// One event, as an observer gets it.
typedef struct bmr_event {
    bmr_event_kind kind;
    int level_before, level_after;
    const bmr_pair *pair; ///< the state after the event
    const bmr_pose *pose; ///< B in A's frame
    double gap;           ///< lower bound of the distance after the event, 0 if none
} bmr_event;

/// Counts of work. bmr_pair_advance counts checks; bmr_pair_check does not.
typedef struct bmr_counters {
    uint64_t checks;
    uint64_t events[BMR_EVENT_KIND_COUNT];
    /// Elementary steps of all repairs: 1 for the proof that failed, and 1 for every vertex, edge or node of
    /// a hierarchy that was looked at. The time of a repair is at most a constant times its steps.
    uint64_t steps;
} bmr_counters;

/// The caller's counters and callback. NULL members are skipped; a NULL observer costs nothing.
typedef struct bmr_observer {
    bmr_counters *counters;
    void (*on_event)(void *context, const bmr_event *event);
    void *context;
} bmr_observer;

/// If c^2 + s^2 of a pose is off 1 by more than this, it is no rigid motion, and nothing is proved about it.
#define BMR_PAIR_UNIT_TOLERANCE 1e-3

/// Can a pair be advanced to this pose? It must be finite, with a rotation of about unit length. O(1).
static inline bool bmr_pair_takes(const bmr_pose *b_in_a) {
    const double excess = b_in_a->c * b_in_a->c + b_in_a->s * b_in_a->s - 1.0;
    const double x = b_in_a->position.x, y = b_in_a->position.y;
    const double reach = (x < 0.0 ? -x : x) + (y < 0.0 ? -y : y);
    return excess <= BMR_PAIR_UNIT_TOLERANCE && -excess <= BMR_PAIR_UNIT_TOLERANCE && reach <= DBL_MAX;
}

/// Makes a pair about which nothing is known. Any polygons and any pose may come next. 64 bytes of zeros are
/// the same. O(1).
void bmr_pair_init(bmr_pair *pair);

/// The quick check: is the certificate of the last advance still true at this pose, by more than the margin?
/// It is about the polygons of that advance. If the caller has other polygons by then, it must call
/// bmr_pair_advance, which notices. Reads one cache line: the pair. False only means: call bmr_pair_advance.
/// A pose with a NaN never gives true. The pose must be one that bmr_pair_takes accepts (bmr_pair_advance
/// checks that itself). `*gap` as in bmr_certificate_check.
static inline bool bmr_pair_check(const bmr_pair *pair, const bmr_pose *b_in_a, double margin, double *gap);

/// A certificate may claim the polygons to be closer than they are by at most this times the sum of their
/// extents: the rounding of its floats, and BMR_ROLL_TOLERANCE.
#define BMR_PAIR_SLOP 4e-6

/// Takes the pair to a new relative pose. It checks, and repairs if the check fails (push, stab, roll,
/// coarsen, leaving contact). Poses may jump; the answer depends on the pose alone. `*gap` (may be NULL) gets
/// a certified lower bound of the distance of the polygons: > margin if the answer is APART, otherwise 0.
///
/// Certified: true of the given polygons at the given pose, all rounding included. (A pose whose (c, s) is
/// off unit length by e > 2^-50 scales the other body by 1 + e; the caller adds that to the margin.) If
/// bmr_pair_takes refuses the pose, a NaN among them, the answer is STAB_POLYGON.
///
/// Complete: if the distance is larger than need + BMR_PAIR_SLOP * (sum of the extents) + 1e-6 * need, the
/// answer is APART. `need` is the margin, and margin + hysteresis for a pair in contact.
///
/// All of this holds for every earlier history of the pair: other polygons, hierarchies or structures
/// start it anew (see the top). Even a pair of arbitrary bytes reads nothing but the pair and the shapes; its
/// answer is then as good as its bytes.
///
/// Cost: O(1) if the certificate holds, reading the pair and one line of each polygon. Otherwise expected
/// O(level change); O(log n) for a start.
bmr_answer bmr_pair_advance(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                            const bmr_pose *b_in_a, const bmr_observer *observer, double *gap);

/// Proves the pair's state again from scratch at the pose of its last advance: by brute force over all
/// vertices; for the lazy structures also that the edge is on its level, the corner is the extreme one of its
/// level, and the window is its point. OK for a pair in contact or new. Errors: NULL_ARGUMENT;
/// FALSE_CERTIFICATE, also for polygons other than those of its last advance; INVALID_STRUCTURE, also if the
/// pair was last repaired as another structure (its next repair will start it anew). O(n).
bmr_error bmr_pair_audit(const bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a,
                         const bmr_shape *b, const bmr_pose *b_in_a);

static inline bool bmr_pair_check(const bmr_pair *pair, const bmr_pose *b_in_a, double margin, double *gap) {
    if (pair->state != BMR_PAIR_APART)
        return false;
    if (pair->level == BMR_LEVEL_DISKS) {
        const bmr_certificate *k = &pair->certificate;
        const bmr_vec2 center =
            bmr_transform(b_in_a, bmr_vec2_make((double)k->window[0][0], (double)k->window[0][1]));
        const double dx = center.x - (double)k->normal[0], dy = center.y - (double)k->normal[1];
        const double reach = (double)k->offset + margin;
        // A lower bound of the gap that needs no square root.
        // 2^-48 covers the rounding of this very expression.
        const double d2 = dx * dx + dy * dy;
        *gap = margin;
        return d2 > reach * reach * (1.0 + 3.5527136788005009e-15);
    }
    return bmr_certificate_check_pair(&pair->certificate, b_in_a, pair->owner, margin, gap) ==
           BMR_CHECK_HOLDS;
}

#ifdef __cplusplus
}
static_assert(sizeof(bmr_pair) == 64, "a pair is one cache line");
#else
_Static_assert(sizeof(bmr_pair) == 64, "a pair is one cache line");
#endif
#endif
