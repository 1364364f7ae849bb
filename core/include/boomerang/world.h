// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_WORLD_H
#define BOOMERANG_WORLD_H

#include "boomerang/failure.h"
#include "boomerang/kds.h"
#include "boomerang/mass.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// A kinetic world of many convex polygons: the broad phase that the paper's last section asks for, the
/// structures of sections 5 and 6 for the pairs that are near, and answers to contacts. In
/// boomerang::kinetic. (Two bodies, and every event of one structure: boomerang/simulation.h.)
///
/// Everything is a certificate with a time of failure, in one queue:
///   - of a body: "the centre of my bounding disk is in my cell". Cells are those of nested grids, each twice
///   as fine as the next. A body lives on a grid whose cells hold its disk. Bodies in neighbouring cells (on
///   the coarser one's grid) are candidates.
///   - of a candidate: "our bounding disks are apart".
///   - of a near pair, whose disks are not apart: the conditions of its structure.
/// The disks are about the origins of the bodies' frames, whose paths are polynomials. So put a body's origin
/// at its middle (for the ready answers: at its centre of mass).
///
/// The times at which a pair begins to be near, parts and touches are functions of the two motions alone, bit
/// for bit. They do not depend on when the two became candidates, how far a call advanced, or on other
/// bodies. Events of equal times come in the order of their kinds and of the bodies' births.

typedef struct bmr_world bmr_world;

/// A body, or a wall. The number of a body is never used again, also after the body was removed. (The first
/// bodies of a world are 0, 1, 2, ..)
typedef uint64_t bmr_body;
#define BMR_NO_BODY UINT64_MAX
/// The walls of a WALLED world: left, right, bottom, top.
#define BMR_WALL(side) (UINT64_MAX - 4u + (bmr_body)(side))
#define BMR_WALLS 4
static inline bool bmr_is_wall(bmr_body body) {
    return body >= BMR_WALL(0) && body != BMR_NO_BODY;
}

// ---- contacts and answers ----

/// A contact: two polygons have come within the margin of each other. The callback may come early: while they
/// are farther apart than the margin by a few 16ths of it, or, if that is more, by what they move in a few
/// roundings of the time. B may be a wall.
typedef struct bmr_contact {
    double time;
    bmr_body a, b; ///< a was born first
    /// One point, or the two ends of a stretch if two sides face each other: world frame, beside A. The
    /// nearest point of B is `distance` * `normal` from it.
    bmr_vec2 points[2];
    size_t count;
    bmr_vec2 normal; ///< from A to B, unit length, world frame: the direction of impulses
    double distance; ///< of the polygons; 0 where they overlap
    /// Velocity of B less that of A at each point; and its part along the normal, < 0 if they approach.
    bmr_vec2 velocity[2];
    double approach[2];
    /// B's position plus this is the image of B that A meets; (0, 0) except in a periodic box.
    bmr_vec2 image;
    /// True if no motion brought them so near: a body was put there, or its motion jumped by more than
    /// rounding (16 of all that its pose is a sum of; 2 of the clock).
    bool placed;
    /// Contacts of this pair before this one since it was last apart by the margin and the hysteresis.
    unsigned again;
} bmr_contact;

typedef enum bmr_response_kind {
    /// Nothing is done. The next contact of this pair comes after it has been apart by the margin and the
    /// hysteresis.
    BMR_RESPONSE_PASS,
    /// Impulses along the normal with this restitution, so that no point approaches any more: at the point,
    /// or at both ends of a stretch at once, or in turn if one of them would have to pull. Bodies that do not
    /// approach keep their motions. Both go on in screw motions from their poses. Two bodies that nothing
    /// moves pass.
    BMR_RESPONSE_IMPULSE,
    /// The callback has set the motions (bmr_world_set_motion); the world goes on watching the pair. If the
    /// two still approach, the same contact comes again, at half the distance.
    BMR_RESPONSE_MINE,
    BMR_RESPONSE_KIND_COUNT
} bmr_response_kind;

typedef struct bmr_response {
    bmr_response_kind kind;
    double restitution; ///< of IMPULSE; in [0, 1], 1: elastic
} bmr_response;

/// Returns the answer to a contact. The callback may add and remove bodies (these two as well) and set
/// motions. If it removes one of the two, the answer is ignored. It may not advance or destroy the world.
typedef bmr_response (*bmr_world_contact)(void *context, bmr_world *world, const bmr_contact *contact);

/// The treatment of infinitely many contacts in finite time (inelastic collapse: with restitution below 1,
/// three bodies in a row are enough) and of contacts that no answer ends.
typedef enum bmr_zeno_policy {
    /// bmr_world_advance returns STALLED when a pair has contacts nearer and nearer without coming apart: in
    /// inelastic collapse, when bodies come to rest on each other, and when bodies are pushed together faster
    /// than any answer can part them. It is the right end of these.
    BMR_ZENO_ERROR,
    /// An impulse on points that approach by less than `zeno_speed` has restitution 1 (McNamara and Luding's
    /// remedy). A pair is jammed if it touches at an eighth of the margin or less without having come apart.
    /// If a jammed pair approaches faster, its answer's restitution holds, but the pair rebounds at
    /// zeno_speed at least, and at twice that for each further halving of its distance. So no impulse that
    /// this policy changes rebounds faster than zeno_speed * max(1, margin / (8 distance)), and none adds
    /// energy. `softened` counts these impulses, and `softened_energy` the energy that they kept.
    ///
    /// If a hit on one of the two drives a pair within the margin together by more than zeno_speed, the pair
    /// has its contact at once: a hit goes through a pile in no time, at the pile's own restitution. STALLED
    /// if that does not help: where bodies that nothing moves push others together.
    BMR_ZENO_ELASTIC
} bmr_zeno_policy;

// ---- events ----

typedef enum bmr_world_event_kind {
    BMR_WORLD_PLAN,    ///< a body's motion went on to its next piece
    BMR_WORLD_CROSS,   ///< a body came into another cell
    BMR_WORLD_NEAR,    ///< two disks met: a structure began
    BMR_WORLD_REPAIR,  ///< a structure's proof failed and was repaired
    BMR_WORLD_PART,    ///< two disks parted: the structure ended
    BMR_WORLD_CONTACT, ///< after the answer
    BMR_WORLD_LEAVE,   ///< a pair that passed through each other is apart again
    BMR_WORLD_EVENT_KIND_COUNT
} bmr_world_event_kind;
/// "plan", "cross", "near", "repair", "part", "contact", "leave"; NULL for anything else.
const char *bmr_world_event_name(bmr_world_event_kind kind);

typedef struct bmr_world_event {
    bmr_world_event_kind kind;
    double time;
    bmr_body a, b;         ///< b: BMR_NO_BODY for PLAN and CROSS
    bmr_kds_report report; ///< of NEAR and REPAIR; else zero
} bmr_world_event;
/// Gets each event after it was processed. May do what a bmr_world_contact may.
typedef void (*bmr_world_observer)(void *context, bmr_world *world, const bmr_world_event *event);

// ---- the world ----

typedef enum bmr_boundary {
    BMR_OPEN,    ///< no boundary
    BMR_WALLED,  ///< four walls: the lines along the sides of the box, all of them
    BMR_PERIODIC ///< a body that leaves on one side enters on the other; positions go on counting
} bmr_boundary;

typedef struct bmr_world_def {
    const bmr_kds_info *structure; ///< of every near pair
    /// kds.margin: in contact when the polygons are this near; more than some 1e-8 of the largest body.
    /// kds.hysteresis: how much farther apart a pair must have been for its next contact to count as a new
    /// one. Any value works: the pair's structure stands until then.
    bmr_kds_def kds;
    bmr_failure_options failure;
    bmr_boundary boundary;
    /// The box's corners, for WALLED and PERIODIC. bmr_world_create refuses coordinates beyond a quarter of
    /// BMR_MAX_COORDINATE (2.5e8), and sides of 1 : 2^20 or more.
    bmr_vec2 low, high;
    bmr_response response; ///< the answer to a contact if there is no callback
    bmr_zeno_policy zeno;
    double zeno_speed; ///< of ZENO_ELASTIC; > 0. Take a hundredth of the usual speed; with less, more worlds
                       ///< stall
    /// The most events in one advance, with searches that it interrupts and continues; 0: no limit.
    uint64_t most_events;
    /// Every two bodies are candidates, and there is no grid. A periodic box (of any shape) then has nine
    /// cells, all neighbours of each other, which give the image in which the two can meet next. For
    /// comparison; O(bodies^2).
    bool all_pairs;
    /// The most time between two samples of a pair that passes through each other: see
    /// bmr_simulation_def.contact_step. At least 1000 failure.tolerance.
    double contact_step;
    bmr_world_contact contact;   ///< NULL: `response`
    bmr_world_observer observer; ///< NULL: none
    void *context;               ///< of both
} bmr_world_def;
/// "hybrid", which needs no hierarchies; the defaults of its parts, hysteresis 1e-6; open; elastic impulses;
/// ZENO_ERROR with a speed of 1e-2; no callbacks; contact_step 0.1.
bmr_world_def bmr_default_world_def(void);

/// Makes an empty world at `time`. The allocator (NULL: malloc) must outlive it. Errors: NULL_ARGUMENT (also
/// a structure that is NULL), NOT_FINITE, OUT_OF_RANGE (a def that makes no sense, a structure for points or
/// translations alone, a box without area), NO_MEMORY.
bmr_error bmr_world_create(const bmr_world_def *def, double time, const bmr_allocator *allocator,
                           bmr_world **world);
/// NULL is no error. A call from a callback is ignored.
void bmr_world_destroy(bmr_world *world);

typedef struct bmr_body_def {
    const bmr_shape *shape; ///< copied; its polygon and hierarchies must outlive the body
    /// Copied from the present time on, with all its pieces.
    const bmr_motion *motion;
    /// For the ready answers; INFINITY: nothing moves it. Both > 0. `inertia` is about the frame's origin,
    /// which counts as the centre of mass.
    double mass, inertia;
} bmr_body_def;
/// A body of density 1 that moves as given. Its mass is the polygon's (bmr_polygon_mass), its inertia the
/// polygon's about the frame's origin. INFINITY for a polygon that has none.
bmr_body_def bmr_default_body_def(const bmr_shape *shape, const bmr_motion *motion);

/// Adds a body at the present time, also from a callback. A few blocks of the allocator: O(1) bytes, the
/// motion's pieces, and O(1) for each candidate. If bodies are in contact where they begin, they have a
/// contact at the present time, which the next advance reports (`placed`). Errors: NULL_ARGUMENT, NOT_FINITE,
/// OUT_OF_RANGE (mass or inertia not positive; a body too large for a periodic box: its diameter must be
/// below a quarter of the shorter side), NO_MEMORY, TOO_LARGE, those of bmr_kds_create (the structure's
/// hierarchies), and those of bmr_failure_time; then the world is as it was.
bmr_error bmr_world_add(bmr_world *world, const bmr_body_def *def, bmr_body *body);
/// Removes a body and its certificates, also from a callback. Errors: NULL_ARGUMENT, OUT_OF_RANGE (no such
/// body).
bmr_error bmr_world_remove(bmr_world *world, bmr_body body);
/// Sets a body's motion from the present time on (its pieces from then on are copied), also from a callback.
/// Only this body's certificates are computed anew, and its candidates found again if its pose jumps. Errors:
/// NULL_ARGUMENT, OUT_OF_RANGE (no such body), NOT_FINITE, NO_MEMORY, TOO_LARGE; then the motion is as it
/// was. Those of bmr_failure_time: then the motion is set, and the next advance ends with that error.
bmr_error bmr_world_set_motion(bmr_world *world, bmr_body body, const bmr_motion *motion);
/// The same with a motion of one piece. It allocates only if the pose jumps.
bmr_error bmr_world_set_piece(bmr_world *world, bmr_body body, const bmr_motion_piece *piece);

/// Processes every event up to and including `until`, in order of time. After an error the world stands at
/// the event that could not be done, and bmr_world_get_trouble says why and which bodies. If the cause is
/// gone, a further call goes on. After STALLED it goes on, too: the pair that stalled passes. Errors:
/// NULL_ARGUMENT, NOT_FINITE, OUT_OF_RANGE (`until` is past, a call from a callback, a search that takes too
/// many steps, and the causes that bmr_trouble lists), STALLED (see bmr_trouble), NO_MEMORY, those of
/// bmr_failure_time.
bmr_error bmr_world_advance(bmr_world *world, double until);
#define BMR_WORLD_BURST 200

/// The cause of an advance's error.
typedef enum bmr_trouble {
    BMR_TROUBLE_NONE,
    /// STALLED: contact after contact of the two, each nearer than the last, and no answer took them apart
    /// (see bmr_zeno_policy).
    BMR_TROUBLE_CONTACTS,
    /// STALLED: a structure had more than BMR_WORLD_BURST repairs, each in next to no time after the one
    /// before.
    BMR_TROUBLE_REPAIRS,
    /// STALLED: the two are apart, but by less than their structure can prove.
    BMR_TROUBLE_PROOF,
    /// OUT_OF_RANGE: the two (or one, through cells) are too fast for the clock: in four roundings of the
    /// time (nine parts in 1e16 of it) they approach by more than the margin. Or a curved path is so long, or
    /// so fast, since its motion began that its place is not known to a 32nd of the disks' reach. So no body
    /// flies through another one unseen.
    BMR_TROUBLE_SPEED,
    /// OUT_OF_RANGE: a body is so far away that there are no larger cells, or no digits left: in an open
    /// world beyond 2^190 cells of its first body, in a periodic box after 2^30 cells.
    BMR_TROUBLE_PLACE,
    BMR_TROUBLE_ANSWER, ///< OUT_OF_RANGE: a response that makes no sense; the pair passes
    BMR_TROUBLE_EVENTS, ///< OUT_OF_RANGE: more than most_events; a further call goes on
    BMR_TROUBLE_OTHER,  ///< see the error
    BMR_TROUBLE_COUNT
} bmr_trouble;
/// One English sentence for a trouble, without a full stop: what is wrong and what to do about it. Never
/// NULL.
const char *bmr_trouble_describe(bmr_trouble trouble);

typedef struct bmr_world_trouble {
    bmr_error error;
    bmr_trouble kind;
    double time;
    bmr_body a, b; ///< the bodies concerned; BMR_NO_BODY: none, or no second one
} bmr_world_trouble;
/// The trouble of the last advance that was no misuse; NONE if it did all of its work.
bmr_world_trouble bmr_world_get_trouble(const bmr_world *world);

double bmr_world_time(const bmr_world *world);

// ---- questions ----

typedef struct bmr_body_state {
    bmr_pose pose; ///< in a periodic box it may lie outside of the box
    bmr_vec2 velocity;
    double spin;
    const bmr_shape *shape;
    bmr_motion_piece piece; ///< the piece that it moves on
    double mass, inertia;
    double radius; ///< of the disk around its origin
    /// The cell that it is in (its sides, without the hysteresis of 1/16 on each), and `level`, its grid's.
    /// Cells of the next level are twice as wide. All zero with all_pairs in an open world.
    bmr_vec2 cell_low, cell_high;
    int level;
    size_t pairs; ///< pairs that it is in
} bmr_body_state;
/// The state of a body at the present time. Errors: NULL_ARGUMENT, OUT_OF_RANGE (no such body). O(1).
bmr_error bmr_world_get(const bmr_world *world, bmr_body body, bmr_body_state *state);
/// Goes through the bodies, in the order of their ids' lower halves. Returns the first whose place is at or
/// after *place, and sets *place to the next; BMR_NO_BODY at the end. Begin with 0.
bmr_body bmr_world_next_body(const bmr_world *world, size_t *place);

typedef enum bmr_watch {
    BMR_WATCH_DISKS,     ///< a candidate: the disks' certificate
    BMR_WATCH_STRUCTURE, ///< a structure stands
    BMR_WATCH_PASSING    ///< in contact or overlapping after the answer PASS
} bmr_watch;
typedef struct bmr_world_pair {
    bmr_body a, b;
    bmr_watch watch;
    bmr_vec2 image;  ///< as in bmr_contact
    double reach;    ///< the sum of the disks' radii at which a structure begins
    double next;     ///< nothing happens to this pair before this time
    bool neighbours; ///< their cells are neighbours; false: the pair is kept for its structure alone
    /// For STRUCTURE and PASSING. A wall is a segment here, which goes along the wall with the body. Its
    /// frame is not turned, and its origin is the point of the wall beside the body's origin.
    const bmr_kds *kds;
} bmr_world_pair;
typedef struct bmr_world_cell {
    int level;
    bmr_vec2 low, high; ///< without the hysteresis; in a periodic box: inside of it
    size_t bodies;      ///< bodies that live in it on its own level
} bmr_world_cell;
/// Calls `visit` for each pair (each cell that has bodies of its own level). `visit` must not change the
/// world. The order is the same in equal runs.
void bmr_world_each_pair(const bmr_world *world, void (*visit)(void *context, const bmr_world_pair *pair),
                         void *context);
void bmr_world_each_cell(const bmr_world *world, void (*visit)(void *context, const bmr_world_cell *cell),
                         void *context);

typedef struct bmr_world_counts {
    uint64_t events[BMR_WORLD_EVENT_KIND_COUNT];
    uint64_t impulses;      ///< of all IMPULSE responses, walls included
    uint64_t softened;      ///< of those, impulses that ZENO_ELASTIC changed
    double softened_energy; ///< energy that these kept and the restitution of the answers would have taken
    uint64_t continued;     ///< searches that ended without an event and went on later
    uint64_t disk_times;    ///< times computed for bodies' cells, and for disks that meet or part
    uint64_t failure_times; ///< of structures' conditions
    uint64_t replans;       ///< motions set, also at answers and changes of plan
    uint64_t replanned;     ///< certificates (of bodies and pairs) computed anew for them
    uint64_t candidates;    ///< pairs made since the start
    // At this moment:
    size_t bodies, cells, pairs, near;
    int levels; ///< from the finest grid in use to the coarsest
    /// Of the world and everything in it (without the allocator's own costs); and the most that it ever was.
    size_t bytes, most_bytes;
} bmr_world_counts;
bmr_world_counts bmr_world_get_counts(const bmr_world *world);

/// Sums over the bodies of finite mass (for the spin: of finite inertia, too).
typedef struct bmr_world_totals {
    double energy;
    bmr_vec2 momentum;
    double angular; ///< momentum, about the world's origin
} bmr_world_totals;
bmr_world_totals bmr_world_get_totals(const bmr_world *world);

/// Proves everything again at the present time: each body is in its cell; each two whose cells are
/// neighbours, or whose disks meet, are a pair; the disks of DISKS are apart; each structure passes
/// bmr_kds_audit; all lists and the queue agree. O(bodies^2 + sizes of the near pairs' polygons). Not in a
/// callback. Errors: NULL_ARGUMENT, INVALID_STRUCTURE, FALSE_CERTIFICATE.
bmr_error bmr_world_audit(const bmr_world *world);

#ifdef __cplusplus
}
#endif
#endif
