// SPDX-License-Identifier: MIT
#ifndef BMR_WORLD_PARTS_H
#define BMR_WORLD_PARTS_H

#include "boomerang/world.h"
#include "kinetic/event_queue.h"
#include "kinetic/motion.h"

/// @file
/// What a world is made of. A *resident* is a body (or a wall), a *couple* a pair of residents that is
/// watched, a *cell* a square of one of the nested grids.

typedef struct bmr_cell bmr_cell;
typedef struct bmr_couple bmr_couple;
typedef struct bmr_resident bmr_resident;

/// What bodies and pairs begin with: their places in the queue.
typedef struct bmr_scheduled {
    bmr_event_item item;
    bool is_couple;
} bmr_scheduled;

/// What bodies of about one size see of walls: a level segment and an upright one about their frame's origin.
typedef struct bmr_beside {
    int size;            ///< from -2^size to 2^size: more than such a body's grid cell is wide at least
    bmr_shape shapes[2]; ///< of a level wall, and of an upright one
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2]; ///< NULL where the structure wants none
    struct bmr_beside *next;
} bmr_beside;

/// Levels of the grids: cells of level 0 are world.unit wide, those of level l 2^l times that.
#define BMR_LEAST_LEVEL (-64)
#define BMR_MOST_LEVEL 191
#define BMR_LEVELS (BMR_MOST_LEVEL - BMR_LEAST_LEVEL + 1)

/// A square of a grid. It exists while a body lives in it or in a cell below it.
struct bmr_cell {
    int level;
    int64_t column, row;              ///< in a periodic box: inside of it
    bmr_cell *next;                   ///< of the same place in the table
    bmr_cell *parent;                 ///< NULL on the top level
    bmr_cell *child, *after, *before; ///< the first cell below; neighbours in the parent's list
    bmr_resident *first;              ///< bodies that live here
    size_t bodies;
};

struct bmr_resident {
    bmr_scheduled head; ///< its next event: the motion's next piece, or the way out of its cell
    bmr_body id;
    uint64_t birth;
    bmr_shape shape;
    const bmr_beside *beside; ///< what it sees of walls; NULL where there are none
    double radius;            ///< of the disk around the origin
    double mass, inertia;
    void *user;

    bmr_timed_piece now; ///< what it moves on, as a motion of one piece
    double since, until; ///< when that began to hold, and ends
    bmr_motion *plan;    ///< the pieces, where there are more; else NULL

    bmr_cell *cell;               ///< NULL: a wall, or a world without a grid
    bmr_resident *after, *before; ///< in its cell's list
    int64_t column, row;          ///< of the cell; in a periodic box: counted on, as positions are
    bool look;                    ///< nothing is known after the event's time

    bmr_couple *first; ///< of its couples
    size_t couples;
    bmr_couple *found;      ///< scratch: the couple that a search has in hand
    bmr_resident *gathered; ///< scratch: the next one that sticks together with it
};

/// What the queue has a couple for.
typedef enum bmr_couple_event {
    BMR_COUPLE_LOOK,  ///< to be searched further
    BMR_COUPLE_MEET,  ///< the disks meet
    BMR_COUPLE_FAIL,  ///< a condition of the structure fails
    BMR_COUPLE_PART,  ///< the disks part
    BMR_COUPLE_TOUCH, ///< ZENO_ELASTIC: two within the margin were driven together just now
    BMR_COUPLE_RISE,  ///< a pair that was in contact may be apart by the margin again
    BMR_COUPLE_LEAVE  ///< a pair that passes is apart
} bmr_couple_event;

/// What is kept of a couple whose disks have met.
typedef struct bmr_near {
    bmr_kds *kds;
    double from;     ///< nothing fails before; where the next search begins
    double repaired; ///< when it was last started or repaired
    double rhythm;   ///< about the time between its last events
    double window;   ///< how far the next search goes
    double speed;    ///< bound of the two's against each other, where the last search looked
    double part;     ///< when the disks part; NAN: not known
    bool part_known; ///< false: not before `part`
    size_t failing;
    bmr_condition condition; ///< FAIL: what fails
    double last_repair;
    unsigned burst;
    /// The margin is halved `rung / bmr_rungs_a_halving` times. A pair that was just in contact is within its
    /// margin; with less of it, it has a proof with slack again. As it comes apart it gets its margin back.
    unsigned rung, again;   ///< `again`: as in bmr_contact
    double touch;           ///< ZENO_ELASTIC: the time of the last TOUCH,
    unsigned touches;       ///< and how many were at that time
    double rise, rise_step; ///< when to look whether it is apart again; INFINITY: never
    unsigned retries;       ///< LEAVE: of the structure's start
} bmr_near;

struct bmr_couple {
    bmr_scheduled head;
    bmr_resident *side[2];            ///< the first was born first; the second may be a wall
    bmr_couple *after[2], *before[2]; ///< in the lists of both
    bmr_couple *same;                 ///< scratch: another couple of the same two
    int32_t image[2];                 ///< so many boxes are added to the second's position
    uint8_t event;                    ///< bmr_couple_event
    uint8_t watch;                    ///< bmr_watch
    bool linked, neighbours, kept;    ///< cells are; scratch
    bool stuck;                       ///< to each other, while neither gets another motion
    bmr_near *near;                   ///< NULL with WATCH_DISKS
};

struct bmr_world {
    bmr_allocator counted; ///< through which all memory goes
    const bmr_allocator *allocator;
    bmr_world_def def;
    double time;
    bool inside;   ///< a callback is running
    bool sticking; ///< all that stick together are being moved
    bmr_world_trouble trouble;
    bmr_couple *busy; ///< whose contact is being told
    bmr_event_queue queue;
    bmr_world_counts counts;

    bmr_resident **residents; ///< by place: the lower half of an id
    uint32_t *generations;    ///< the upper half of the next id of each place
    size_t places, capacity;
    size_t free_place; ///< the first that may be free
    uint64_t births;

    double unit_x, unit_y;      ///< a cell of level 0; 0: not yet known
    int64_t around_x, around_y; ///< cells of level 0 around a periodic box; else 0
    bmr_cell **table;
    size_t table_size, cell_count; ///< the former a power of 2, or 0
    int top;                       ///< the coarsest level that has cells
    size_t idle_top;               ///< moves since it had a body of its own
    size_t level_bodies[BMR_LEVELS];

    struct bmr_candidate *candidates; ///< scratch
    size_t candidate_count, candidate_capacity;

    bmr_resident walls[BMR_WALLS];
    bmr_beside *beside;   ///< of each power of 2 that a body was as large as: kept until the end
    bmr_compass *compass; ///< of the walls' hierarchies
};

/// The generation of a place whose ids are used up: nobody lives there any more. (So no id is a wall's.)
#define BMR_NO_GENERATION UINT32_MAX
/// Of the table of ids, for each place: the resident, and the generation of the next one there.
#define BMR_PLACE_BYTES (sizeof(bmr_resident *) + sizeof(uint32_t))

/// A resident near a place, and which image of it.
typedef struct bmr_candidate {
    bmr_resident *resident;
    int32_t image[2]; ///< of the resident as seen from the place
} bmr_candidate;

static inline bool bmr_resident_is_wall(const bmr_resident *r) {
    return bmr_is_wall(r->id);
}
static inline bool bmr_wall_is_upright(const bmr_resident *wall) {
    return wall->id < BMR_WALL(2);
}
static inline double bmr_world_tolerance(const bmr_world *w, double time) {
    return w->def.failure.tolerance * fmax(1.0, fabs(time));
}

// memory.c
void *bmr_world_take(bmr_world *w, size_t bytes);
void bmr_world_give(bmr_world *w, void *block, size_t bytes);
/// The same two, for whom wants an allocator.
bmr_allocator bmr_world_allocator(bmr_world *w);

// cells.c: the nested grids.

/// How wide a cell must be at least for a body of this radius.
double bmr_grid_need(const bmr_world *w, double radius);
/// The level that a body of this radius at this place lives on at least. OUT_OF_RANGE, NOT_FINITE.
bmr_error bmr_grid_level(const bmr_world *w, double radius, bmr_vec2 position, int *level);
/// Columns and rows, counted on, of the cell that holds a place.
void bmr_grid_place(const bmr_world *w, int level, bmr_vec2 position, int64_t *column, int64_t *row);
/// The cell, made where there is none, with all above it. NO_MEMORY: as it was.
bmr_error bmr_grid_cell(bmr_world *w, int level, int64_t column, int64_t row, bmr_cell **cell);
/// Gives a cell back if nothing lives in it or below it, and so on upwards.
void bmr_grid_prune(bmr_world *w, bmr_cell *cell);
void bmr_cell_enter(bmr_world *w, bmr_cell *cell, bmr_resident *r);
void bmr_cell_leave(bmr_world *w, bmr_resident *r);
/// Gives the top levels back that no body has needed for long.
void bmr_grid_lower(bmr_world *w);
double bmr_cell_width(const bmr_world *w, int level);
double bmr_cell_height(const bmr_world *w, int level);
/// Fills world.candidates with the bodies whose cells are neighbours of this one, `r` itself left out.
bmr_error bmr_grid_candidates(bmr_world *w, const bmr_resident *r, int level, int64_t column, int64_t row);
/// Part of a cell's side that is added on each of its sides before a body leaves it.
#define BMR_CELL_HYSTERESIS 0x1p-4

/// The column (or row) so many levels up; rounded down, also where it is below zero.
static inline int64_t bmr_place_above(int64_t place, int levels) {
    return place >> (levels < 63 ? levels : 63);
}

// walls.c

void bmr_walls_make(bmr_world *w);
void bmr_walls_destroy(bmr_world *w);
/// The box is on its left, where <normal, x> > offset.
bmr_line bmr_wall_line(const bmr_world *w, const bmr_resident *wall);
/// What a body of this radius sees of walls, made where it is the first of its size. Errors: NO_MEMORY,
/// OUT_OF_RANGE (a segment too long for a polygon); then nothing changed.
bmr_error bmr_walls_beside(bmr_world *w, double radius, const bmr_beside **beside);

// frame.c: where a couple looks at its motions from.

/// Both motions in the couple's frame, in which each has its own rotation; `view` holds what they are made
/// of. Only what lies between the two is that of the world.
typedef struct bmr_couple_view {
    bmr_timed_piece pieces[2];
    bmr_motion motions[2];
} bmr_couple_view;
bmr_pair_motion bmr_couple_motion(const bmr_world *w, const bmr_couple *c, bmr_couple_view *view);
/// Of a wall: the segment beside the body.
const bmr_shape *bmr_couple_shape(const bmr_couple *c, int side);
/// What is added to the second's position in the world.
bmr_vec2 bmr_couple_shift(const bmr_world *w, const bmr_couple *c);

// gate.c: when disks meet and part, and when they leave their cells.

/// Of places, in parts of their coordinates: 256 roundings.
#define BMR_PLACE_ROUNDING 0x1p-44
/// Of times that are sums.
#define BMR_CLOCK_ROUNDINGS 2.0
/// Disks this near have met; this far, they have parted.
double bmr_gate_reach(const bmr_world *w, const bmr_couple *c);
double bmr_gate_parted(const bmr_world *w, double reach);
/// The distance of the disks' centres, or of the disk's centre from the wall's line.
double bmr_gate_distance(const bmr_world *w, const bmr_couple *c, double time);
/// The first time after `after` at which the disks meet (part); *look: not before that time, at which to ask
/// again. A function of the two motions alone. Errors: NOT_FINITE.
bmr_error bmr_gate_meets(const bmr_world *w, const bmr_couple *c, double after, double *time, bool *look);
bmr_error bmr_gate_parts(const bmr_world *w, const bmr_couple *c, double after, double *time, bool *look);
/// When the resident leaves its cell with the hysteresis, after `after`. Errors: those of bmr_failure_time.
bmr_error bmr_gate_crosses(const bmr_world *w, const bmr_resident *r, double after, double *time, bool *look);
bmr_vec2 bmr_path_position(const bmr_motion_piece *piece, double time);

// curve.c: the same for those whose paths are not both straight.

/// The next meeting (or parting) of the two whose reach this is.
bmr_error bmr_curve_next(const bmr_world *w, const bmr_couple *c, double reach, bool meets, double after,
                         double *time, bool *look);
/// When the path leaves the rectangle, of a cell whose shorter side is `size`.
bmr_error bmr_curve_leaves(const bmr_world *w, const bmr_motion_piece *piece, bmr_vec2 low, bmr_vec2 high,
                           double size, double after, double *time, bool *look);

// bodies.c: bodies by their ids.

/// NULL: there is none.
bmr_resident *bmr_world_find(const bmr_world *w, bmr_body id);

// jump.c

/// Is the piece a jump from where the resident is now, by more than rounding?
bool bmr_resident_jumps(const bmr_world *w, const bmr_resident *r, const bmr_motion_piece *piece);

// resident.c: their cells and their motions.

/// Takes the resident's next event.
bmr_error bmr_resident_event(bmr_world *w, bmr_resident *r);
/// From the present time on it moves so; `plan` NULL or its own from now on. Searches of its certificates
/// that cannot be done are left to the next advance. Errors: NO_MEMORY: as it was (where the pose jumps).
bmr_error bmr_resident_move(bmr_world *w, bmr_resident *r, const bmr_motion_piece *piece, double until,
                            bmr_motion *plan);
/// From the present time on it moves so; its certificates are as they were.
void bmr_resident_take(bmr_world *w, bmr_resident *r, const bmr_motion_piece *piece, double until,
                       bmr_motion *plan);
/// Takes the body to a cell, with all that follows from that. NO_MEMORY: it stays.
bmr_error bmr_resident_settle(bmr_world *w, bmr_resident *r, int level, int64_t column, int64_t row);
/// Searches its own certificate; what cannot be done is tried again in the next advance.
void bmr_resident_search_later(bmr_world *w, bmr_resident *r, double after);
void bmr_resident_destroy(bmr_world *w, bmr_resident *r);

// couple.c: the life of a pair.

bmr_error bmr_couple_make(bmr_world *w, bmr_resident *a, bmr_resident *b, const int32_t image_of_b[2],
                          bmr_couple **couple);
void bmr_couple_link(bmr_world *w, bmr_couple *c);
void bmr_couple_destroy(bmr_world *w, bmr_couple *c);
/// When the later of the two began to move as it does now.
static inline double bmr_couple_epoch(const bmr_couple *c) {
    return c->side[0]->since > c->side[1]->since ? c->side[0]->since : c->side[1]->since;
}
static inline int bmr_couple_side(const bmr_couple *c, const bmr_resident *r) {
    return c->side[0] == r ? 0 : 1;
}
// search.c: when something happens to it next.

/// The next failure is looked for in so many times the time between the last two, then in twice that.
#define BMR_COUPLE_AHEAD 4.0

/// The time in which the two can move by their reach, at the speeds they have.
double bmr_couple_natural_time(const bmr_world *w, const bmr_couple *c, const bmr_pair_motion *motion,
                               double time);
/// How exactly the pair's times are to be found: as the def says, and the faster it is the more exactly, down
/// to the clock's own rounding.
double bmr_couple_tolerance(const bmr_world *w, const bmr_near *n, double time);
/// Is the clock too coarse, at the present time, for the speeds of the two?
bool bmr_couple_too_fast(const bmr_world *w, const bmr_couple *c);
/// It has its next event then, not before the present time. INFINITY: never.
void bmr_couple_schedule(bmr_world *w, bmr_couple *c, bmr_couple_event event, double time);
/// Finds its next event after the present time.
bmr_error bmr_couple_search(bmr_world *w, bmr_couple *c);
/// The same, with `replan` after a motion changed; where it cannot be done, the couple has an event now, at
/// which it is tried again.
void bmr_couple_search_later(bmr_world *w, bmr_couple *c, bool replan);
/// Takes the couple's next event.
bmr_error bmr_couple_event_due(bmr_world *w, bmr_couple *c);
/// After an answer: a structure with half the margin, or a quarter, and so on. STALLED.
bmr_error bmr_couple_resume(bmr_world *w, bmr_couple *c, bool placed, double receding);
/// While its contact is told: nothing is due.
void bmr_couple_hold(bmr_world *w, bmr_couple *c);
/// After PASS.
bmr_error bmr_couple_pass(bmr_world *w, bmr_couple *c);
bool bmr_item_before(const bmr_event_item *a, const bmr_event_item *b);

/// How many contacts without coming apart it takes for the margin to be halved. With ZENO_ELASTIC they may be
/// the tremble of a jam: it goes down more slowly.
static inline unsigned bmr_rungs_a_halving(const bmr_world *w) {
    return w->def.zeno == BMR_ZENO_ELASTIC ? 4 : 1;
}

// contact.c, answer.c: what a contact is, and what becomes of it.

/// A contact with the arms from both centres to its points.
typedef struct bmr_touch {
    bmr_contact contact;
    bmr_vec2 arm[2][2]; ///< of the point [1] from the origin of body [0]
} bmr_touch;
void bmr_touch_describe(const bmr_world *w, const bmr_couple *c, bool placed, bmr_touch *touch);
/// Fills in velocities and approaches: of these of A and B.
void bmr_touch_move(bmr_touch *touch, const bmr_vec2 velocity[2], const double spin[2]);
/// Tells the contact, and does what is answered. After an error other than NO_MEMORY the pair passes.
bmr_error bmr_contact_tell(bmr_world *w, bmr_couple *c, bool placed);

// stick.c

/// Gives both of the couple, and all that sticks to them, one velocity and no spin. False: they cannot be
/// moved, or not to one velocity; nothing changed.
bool bmr_stick(bmr_world *w, bmr_couple *c);

// trouble.c

/// Notes what is wrong, and returns the error. `b`: BMR_NO_BODY.
bmr_error bmr_world_stop(bmr_world *w, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b);
static inline bmr_error bmr_couple_stop(bmr_world *w, const bmr_couple *c, bmr_error error,
                                        bmr_trouble kind) {
    return bmr_world_stop(w, error, kind, c->side[0]->id, c->side[1]->id);
}

// world.c
void bmr_world_observe(bmr_world *w, bmr_world_event_kind kind, double time, bmr_body a, bmr_body b,
                       const bmr_kds_report *report);

#endif
