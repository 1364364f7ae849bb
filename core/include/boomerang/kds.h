// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_KDS_H
#define BOOMERANG_KDS_H

#include <stddef.h>

#include "boomerang/condition.h"
#include "boomerang/hierarchy.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// Every kinetic structure of the paper, the rivals that it names, and the answers to its open question,
/// behind one interface. A structure holds a proof that A and B are apart, and a short list of conditions
/// under which the proof stands. The caller knows the motion. It finds the first time at which a condition
/// fails, takes the structure there, and has it repaired. (boomerang/pair.h has the same ideas in 64 bytes of
/// floats, for poses that come in steps.)
///
/// All of it is in double precision. Poses are of B's frame in A's frame throughout.

/// Makes the chains of a hierarchy as arrays, for the search of the active triangle by halves: section 5's
/// O(log(log n - i)) time with O(n) more space, 16 bytes an edge of the hierarchy. Made once for a polygon;
/// constant; any number of pairs and threads may share it. The hierarchy must outlive it. O(n). Errors:
/// NULL_ARGUMENT, NO_MEMORY; then *chains is untouched.
bmr_error bmr_chains_create(const bmr_hierarchy *hierarchy, const bmr_allocator *allocator,
                            bmr_chains **chains);
/// NULL is no error.
void bmr_chains_destroy(bmr_chains *chains, const bmr_allocator *allocator);
size_t bmr_chains_bytes(const bmr_chains *chains);

/// The pairs and motions that a structure is made for.
typedef enum bmr_kds_domain {
    BMR_KDS_POINT,       ///< B is a point (a polygon of one vertex); any motion
    BMR_KDS_TRANSLATION, ///< two polygons whose relative rotation never changes (any fixed one)
    BMR_KDS_RIGID        ///< two polygons, any motion
} bmr_kds_domain;

/// The role of a structure.
typedef enum bmr_kds_role {
    /// Take one of these. For a point: point-lazy-dudley. For two polygons: lazy-dudley, the paper's own;
    /// two-lines, which needs no hierarchy, and has all bounds and hysteresis at every gap; hybrid, which
    /// keeps one line and takes fewer steps, but fails often where a body turns to and fro. With hysteresis,
    /// on hierarchies: inflated-translation, inflated-window.
    BMR_KDS_RECOMMENDED,
    /// As right as those, but another one does the same for less. For comparison: the structures that lead to
    /// the paper's own, and variants with one thing changed.
    BMR_KDS_CONTROL,
    BMR_KDS_RIVAL ///< one of those that the paper compares with
} bmr_kds_role;

/// The description of one structure. Constant; there is one for each.
typedef struct bmr_kds_info {
    const char *name;    ///< for command lines: "active-cell-compass"
    const char *title;   ///< one line for tables and help
    const char *section; ///< its place in the paper, or the question that it answers
    bmr_kds_domain domain;
    bmr_kds_role role;
    int hierarchy;              ///< the bmr_hierarchy_kind it needs of each shape, or -1
    const void *implementation; ///< core's own
} bmr_kds_info;

/// All structures, in the order of the paper. O(1).
size_t bmr_kds_count(void);
const bmr_kds_info *bmr_kds_at(size_t index);
/// Finds a structure by its name. Errors: NULL_ARGUMENT; UNKNOWN_NAME (bmr_kds_describe_unknown lists the
/// names). Then *info is untouched. O(number of structures).
bmr_error bmr_kds_find(const char *name, const bmr_kds_info **info);
/// Writes the sentence for a name that bmr_kds_find does not know: the name (its first 64 bytes; NULL: none)
/// and all names there are. Writes at most `size` bytes into `text`, with a 0 at the end if size > 0. Returns
/// how many it would write without that limit, as snprintf does: 1024 are enough.
size_t bmr_kds_describe_unknown(const char *name, char *text, size_t size);

/// Settings of a structure. Start from bmr_default_kds_def().
typedef struct bmr_kds_def {
    /// The pair is in contact if the polygons are this near; > 0, length units. Let `reach` be the distance
    /// that is asked for: the margin, or margin + hysteresis for a pair in contact. A structure may report
    /// contact at a distance larger than `reach` by no more than 1e-9 of the extents and 2e-8 of `reach`. The
    /// first part is the slack with which a line begins (4e-10 of the extents at most) and the rounding of
    /// places. The second is the part of the distance that the search for the closest points may lose (in
    /// practice 2^-50, its rounding). The two rivals that compare distances (closest features, inner tangent)
    /// may report "apart" at a distance smaller by 1e-15 of the extents and of `reach`.
    double margin;
    /// The pair leaves contact at a distance of margin + hysteresis, up to the errors named above; >= 0.
    double hysteresis;
    /// Inflated structures: eps_j = alpha * (D_A + D_B) * offset_ratio^j. The paper's values: 1/2 and 1/2. A
    /// ratio nearer to 1 takes beta towards 1 and kappa towards 3, if the root polygon is richer too.
    double alpha, offset_ratio;
    /// Inflated structures: levels of the hierarchy that the root polygon already has; 0: the rectangle. For
    /// polygons with sharp corners, give the shapes hierarchies of bmr_hierarchy_build_compass_with_corners
    /// of at least so many levels. (Structures on an explicit sum make their own.) In other hierarchies no
    /// edge's direction lies within the angle of a sharp corner.
    unsigned root_level;
} bmr_kds_def;
/// margin 1e-6, hysteresis 0, alpha 1/2, offset_ratio 1/2, root_level 0.
bmr_kds_def bmr_default_kds_def(void);

/// The relative motion at one time: B's frame in A's. A structure that predicts uses the rates. If the caller
/// does not know them, it passes 0, which is never wrong.
typedef struct bmr_instant {
    bmr_pose pose;
    bmr_vec2 velocity; ///< of pose.position
    double spin;       ///< rate of the pose's angle
} bmr_instant;

/// The event of one repair.
typedef enum bmr_kds_event_kind {
    BMR_KDS_START,     ///< a proof was made from nothing
    BMR_KDS_PUSH,      ///< the point or corner crossed the line beyond the edge's ends
    BMR_KDS_STAB,      ///< it crossed the edge itself: refined
    BMR_KDS_ROLL,      ///< the nearest corner changed, the line stayed
    BMR_KDS_CROSS,     ///< an eager cell: the point left through an outer side into another cell
    BMR_KDS_PAGE_TURN, ///< mixed hierarchy: a triangle and a parallelogram changed places
    BMR_KDS_COLLAPSE,  ///< mixed hierarchy: a parallelogram vanished
    BMR_KDS_FEATURE,   ///< a rival: the features or the tangent changed
    BMR_KDS_HANDOVER,  ///< the line failed, and the spare line that was made with it took its place
    BMR_KDS_CONTACT,   ///< the polygons are within the margin
    BMR_KDS_LEAVE,     ///< contact was left, a proof was made
    BMR_KDS_NONE,      ///< the call came too early: every condition still held
    BMR_KDS_EVENT_KIND_COUNT
} bmr_kds_event_kind;
/// "start", "push", "stab", "roll", "cross", "page-turn", "collapse", "feature", "handover",
/// "contact", "leave", "none"; NULL for anything else.
const char *bmr_kds_event_name(bmr_kds_event_kind kind);

typedef struct bmr_kds_report {
    bmr_kds_event_kind kind;
    bool apart; ///< true: there is a proof; false: contact
    /// The separating line changed (its owner, direction or offset). A new line that happens to be the same
    /// may count as changed.
    bool line_changed;
    int level_before, level_after; ///< of the hierarchy; 0 for a structure that has none
    /// Elementary steps: 1 for the proof that failed, and 1 for every vertex, edge, normal, node of a
    /// hierarchy or cell that was looked at. The time of a start or repair is at most a constant times this.
    unsigned touched;
} bmr_kds_report;

/// The most conditions of any structure.
#define BMR_KDS_MAX_CONDITIONS 8

/// The line that proves the pair apart: all of the owner is on or behind it, all of the other body beyond it.
typedef struct bmr_kds_proof {
    int owner;        ///< 0: the line is fixed in A's frame, 1: in B's
    bmr_line line;    ///< owner's frame
    bmr_vec2 nearest; ///< the corner or vertex of the other body that counts as its nearest; its frame
    int level;
} bmr_kds_proof;

typedef struct bmr_kds bmr_kds;

/// Makes a structure for one pair; nothing is known yet. One block of the allocator (NULL: malloc) of O(1)
/// bytes, except for structures on an explicit Minkowski sum or tiling, which say so. The shapes must
/// outlive it, unchanged: it is bound to them, and no later call takes others. Errors: NULL_ARGUMENT (also a
/// hierarchy that `info` needs), WRONG_HIERARCHY (it is of another polygon or kind), OUT_OF_RANGE (a def that
/// makes no sense; a POINT structure for a B of several vertices), NO_MEMORY.
bmr_error bmr_kds_create(const bmr_kds_info *info, const bmr_kds_def *def, const bmr_shape *a,
                         const bmr_shape *b, const bmr_allocator *allocator, bmr_kds **kds);
void bmr_kds_destroy(bmr_kds *kds, const bmr_allocator *allocator);
/// Bytes of the pair's own state.
size_t bmr_kds_bytes(const bmr_kds *kds);

/// Makes a proof from nothing, or finds contact. Call it to leave contact, too. O(log n) (structures on an
/// explicit tiling: O(size)). A pose with a NaN, or far from orthonormal, is contact.
void bmr_kds_start(bmr_kds *kds, const bmr_instant *now, bmr_kds_report *report);

/// The conditions of the present proof, all of which held at the last start or repair; 0 in contact. While
/// all of them hold, the polygons are apart by more than the margin. O(1), but O(log n) for a separating edge
/// of a polygon as thin as rounding.
size_t bmr_kds_conditions(const bmr_kds *kds, bmr_condition conditions[BMR_KDS_MAX_CONDITIONS]);

/// Takes the structure past a failure. `failed` is the index of the condition that is at zero, or just below,
/// at this instant (it must be less than their number, which is not checked). Afterwards every condition is
/// positive, or zero and about to grow under the rates of `now`, or the pair is in contact. If nothing has
/// failed, it reports NONE and changes nothing. It reports contact only if the exact distance is at most the
/// margin (up to rounding, see bmr_kds_def).
void bmr_kds_repair(bmr_kds *kds, const bmr_instant *now, size_t failed, bmr_kds_report *report);

bool bmr_kds_in_contact(const bmr_kds *kds);
/// The line of the present proof; false in contact. (The line of two rivals, closest features and inner
/// tangent, is fixed in neither frame: they give that of the last event.)
bool bmr_kds_get_proof(const bmr_kds *kds, bmr_kds_proof *proof);

/// Proves everything again by brute force over all vertices, at a pose where the conditions hold: the line
/// separates by more than the margin, and the structure's other promises of its level, cell or features are
/// true. OK for a pair in contact whose distance is at most the margin, and for a pose with a NaN or far from
/// orthonormal, which is contact. O(n). Errors: NULL_ARGUMENT, FALSE_CERTIFICATE, INVALID_STRUCTURE.
bmr_error bmr_kds_audit(const bmr_kds *kds, const bmr_pose *b_in_a);

#ifdef __cplusplus
}
#endif
#endif
