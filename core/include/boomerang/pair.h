// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_PAIR_H
#define BOOMERANG_PAIR_H

#include "boomerang/certificate.h"
#include "boomerang/hierarchy.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// A kinetic structure for one pair of moving convex polygons A and B, in sampled mode: it is advanced from
/// one relative pose to the next and answers "apart, by at least this much" or "stab on the real polygon".
/// Sections 3 and 5 of the paper (lazy), section 6's open question (free direction).
///
/// Poses are of B's frame in A's frame throughout. Nothing here allocates; a pair is plain data that may be
/// copied.

/// Which kinetic structure.
typedef enum bmr_structure {
    /// Edge of one envelope, corner of the other, on compass hierarchies. (At the polygons themselves, where
    /// the gap is
    /// within a factor of sqrt(2) of the margin, the closest direction stands in for an edge.)
    BMR_LAZY_COMPASS,
    BMR_LAZY_DUDLEY, ///< the same on Dudley hierarchies
    BMR_LAZY_DOBKIN_KIRKPATRICK,
    BMR_FREE_DIRECTION, ///< closest direction fixed in one body, two-corner window in the other
    BMR_STRUCTURE_COUNT
} bmr_structure;

/// "lazy-compass", "lazy-dudley", "lazy-dobkin-kirkpatrick", "free-direction"; NULL for anything else.
const char *bmr_structure_name(bmr_structure structure);

/// One body of a pair. `hierarchy` is what the lazy structures walk on (of the kind the structure names; its
/// polygon is `polygon`); the free direction takes NULL. Both must outlive the pair's use of them.
typedef struct bmr_shape {
    const bmr_polygon *polygon;
    const bmr_hierarchy *hierarchy;
} bmr_shape;

/// How a structure is to behave: constant, shared by many pairs.
typedef struct bmr_pair_def {
    bmr_structure structure;
    /// The pair counts as in contact when no line proves more than this; >= 0, length units.
    double margin;
    /// A pair in contact leaves it only when more than margin + hysteresis is proved; >= 0, length units.
    double hysteresis;
} bmr_pair_def;
/// lazy-compass, margin and hysteresis 0.
bmr_pair_def bmr_default_pair_def(void);

/// Kinds of events, in the paper's words. One repair is one of START, PUSH, STAB, ROLL, CONTACT and LEAVE,
/// followed by a COARSEN for each level it then gained. For the free direction, whose only levels are the
/// disks and the polygons, PUSH and ROLL both mean that the closest direction was taken anew.
typedef enum bmr_event_kind {
    BMR_EVENT_START,   ///< a certificate was made from nothing
    BMR_EVENT_PUSH,    ///< the window crossed the line, and another line of the same level separates
    BMR_EVENT_STAB,    ///< the envelopes of this level touch: refined to a deeper level
    BMR_EVENT_ROLL,    ///< the direction left the window's bracket
    BMR_EVENT_COARSEN, ///< a coarser level was found to be apart (one event for each level gained)
    BMR_EVENT_CONTACT, ///< the stab reached the real polygons: hand-over
    BMR_EVENT_LEAVE,   ///< the pair left contact
    BMR_EVENT_KIND_COUNT
} bmr_event_kind;
/// "start", "push", "stab", "roll", "coarsen", "contact", "leave"; NULL for anything else.
const char *bmr_event_name(bmr_event_kind kind);

/// The level above the bounding rectangle: two bounding disks.
#define BMR_LEVEL_DISKS (-1)

/// A pair's whole state: 64 bytes, to be aligned to 64 where a check shall touch one cache line. Read it, do
/// not write it.
typedef struct bmr_pair {
    bmr_certificate certificate; ///< 44 bytes; at level -1 normal = centre of A's disk, window[0] = that of
                                 ///< B's, offset = sum of radii
    uint8_t simplex;      ///< in contact: how many vertex pairs (a | b << 16) are remembered in edge, other,
                          ///< other_after
    int8_t spin;          ///< free: the sense in which B turned out of the last bracket: -1, 0 (unknown) or 1
    uint8_t owner;        ///< 0: the line is A's; 1: it is B's
    uint8_t state;        ///< bmr_pair_state
    uint32_t edge;        ///< lazy: the owner's edge id; free: support vertex of the owner
    uint32_t other;       ///< lazy: `before` of the other's corner; free: support vertex of the other
    uint32_t other_after; ///< lazy: `after` of the other's corner (its `cut` follows from the level)
    int8_t level;         ///< -1 disks, 0 rectangles, ...; free direction: 0; in contact: the deepest
    uint8_t free; ///< lazy: 1 where no edge's line does and the certificate is the closest direction's
    uint8_t reserved[2];
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

/// One event, as handed to an observer.
typedef struct bmr_event {
    bmr_event_kind kind;
    int level_before, level_after;
    const bmr_pair *pair; ///< the state after the event
    const bmr_pose *pose; ///< B in A's frame
    double gap;           ///< certified after the event, 0 if none
} bmr_event;

/// Counts of work done. Checks are counted by bmr_pair_advance, not by bmr_pair_check.
typedef struct bmr_counters {
    uint64_t checks;
    uint64_t events[BMR_EVENT_KIND_COUNT];
    uint64_t levels; ///< levels walked by all repairs
} bmr_counters;

/// Who is told. NULL members are skipped; a NULL observer costs nothing.
typedef struct bmr_observer {
    bmr_counters *counters;
    void (*on_event)(void *context, const bmr_event *event);
    void *context;
} bmr_observer;

/// A pair about which nothing is known. Any pose may come next. O(1).
void bmr_pair_init(bmr_pair *pair);

/// The quick look: is the certificate of the last advance still true at this pose, by more than the margin?
/// One cache line, no memory but the pair's. False says nothing but "call bmr_pair_advance"; a pose with a
/// NaN is never true. The length of (c, s) is the caller's to know: it is bmr_pair_advance that looks at it.
/// `*gap` as in bmr_certificate_check.
static inline bool bmr_pair_check(const bmr_pair *pair, const bmr_pose *b_in_a, double margin, double *gap);

/// How much closer than the truth, in units of the sum of the two polygons' extents, a certificate may have
/// to claim them to be: its floats' rounding, and BMR_ROLL_TOLERANCE.
#define BMR_PAIR_SLOP 4e-6

/// Takes the pair to a new relative pose: checks, and repairs where the check fails (push, stab, roll,
/// coarsen, leaving contact). Poses may jump; nothing but the pose decides what is true. `*gap` (may be NULL)
/// gets a certified lower bound of the distance of the polygons: > margin when the answer is APART, 0
/// otherwise. NaN poses answer STAB_POLYGON. Certified means: true of the given polygons at the given pose,
/// all rounding included (poses whose (c, s) is off unit length by e > 2^-50 scale the other body by 1 + e;
/// that is the caller's to add to the margin. Poses off by more than 1e-3 are no motions and answer
/// STAB_POLYGON, as NaN does). Complete: where the distance is larger than need + BMR_PAIR_SLOP * (sum of the
/// extents) + 1e-6 * need, the answer is APART; need is the margin, and for a pair in contact margin +
/// hysteresis. Cost: O(1) where the certificate holds, else O(level change) expected, O(log n) for a start.
bmr_answer bmr_pair_advance(bmr_pair *pair, const bmr_pair_def *def, const bmr_shape *a, const bmr_shape *b,
                            const bmr_pose *b_in_a, const bmr_observer *observer, double *gap);

/// Re-proves the pair's state from scratch at a pose where it was just advanced to (brute force over all
/// vertices, and for the lazy structures: the edge is on its level, the corner is the extreme one of its
/// level, the window is its point). OK for a pair in contact or new. FALSE_CERTIFICATE or INVALID_STRUCTURE
/// otherwise. O(n).
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
        // The square root is left to those who want the gap: this is a lower bound that needs none.
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
