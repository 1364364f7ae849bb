// SPDX-License-Identifier: MIT
#ifndef BMR_WORLD_PARTS_H
#define BMR_WORLD_PARTS_H

#include "boomerang/world.h"
#include "kinetic/event_queue.h"
#include "kinetic/motion.h"

/// @file
/// What a world is made of, and what its files have for each other: each file uses those above it in this
/// list alone. A wall is a body, too. A *pair* are two bodies that are watched, a *cell* is a square of one
/// of the nested grids.

typedef struct bmr_cell bmr_cell;
typedef struct bmr_body_pair bmr_body_pair;
typedef struct bmr_world_body bmr_world_body;

/// What bodies and pairs begin with: their places in the queue.
typedef struct bmr_scheduled {
    bmr_event_item item;
    bool is_pair;
} bmr_scheduled;

/// What bodies of about one size see of walls: a level segment and an upright one about their frame's origin.
typedef struct bmr_wall_segments {
    int size;            ///< from -2^size to 2^size: more than such a body's grid cell is wide at least
    bmr_shape shapes[2]; ///< of a level wall, and of an upright one
    bmr_polygon *polygons[2];
    bmr_hierarchy *hierarchies[2]; ///< NULL where the structure wants none
    struct bmr_wall_segments *next;
} bmr_wall_segments;

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
    bmr_world_body *first;            ///< bodies that live here
    size_t bodies;
};

struct bmr_world_body {
    bmr_scheduled head; ///< its next event: the motion's next piece, or the way out of its cell
    bmr_body id;
    uint64_t birth;
    bmr_shape shape;
    const bmr_wall_segments *segments; ///< what it sees of walls; NULL where there are none
    double radius;                     ///< of the disk around the origin
    double mass, inertia;

    bmr_timed_piece now; ///< what it moves on, as a motion of one piece
    double since, until; ///< when that began to hold, and ends
    bmr_motion *plan;    ///< the pieces, where there are more; else NULL

    bmr_cell *cell;                 ///< NULL: a wall, or a world without a grid
    bmr_world_body *after, *before; ///< in its cell's list
    int64_t column, row;            ///< of the cell; in a periodic box: counted on, as positions are
    bool unfinished;                ///< at the event's time the search for its event goes on

    bmr_body_pair *first; ///< of its pairs
    size_t pairs;
    bmr_body_pair *found; ///< scratch: the pair that a search has in hand
};

/// What the queue has a pair for.
typedef enum bmr_pair_due {
    BMR_DUE_SEARCH, ///< to be searched further
    BMR_DUE_MEET,   ///< the disks meet
    BMR_DUE_FAIL,   ///< a condition of the structure fails
    BMR_DUE_PART,   ///< the disks part
    BMR_DUE_TOUCH,  ///< ZENO_ELASTIC: two within the margin were driven together just now
    BMR_DUE_GROWTH, ///< a pair that was in contact may be apart by the margin again
    BMR_DUE_LEAVE   ///< a pair that passes is apart
} bmr_pair_due;

/// What is kept of a pair whose disks have met.
typedef struct bmr_near {
    bmr_kds *kds;
    double from;     ///< nothing fails before; where the next search begins, if that is not past
    double repaired; ///< when it was last started or repaired
    double period;   ///< about the time between its last events
    double window;   ///< how far the next search goes
    double speed;    ///< bound of the two's against each other, over what was searched last
    double part;     ///< when the disks part; NAN: not known
    bool part_known; ///< false: not before `part`
    size_t failing;
    bmr_condition condition; ///< FAIL: what fails
    double last_repair;
    unsigned burst;
    /// The margin is halved `level / bmr_levels_a_halving` times. A pair that was just in contact is within
    /// its margin; with less of it, it has a proof with slack again. As it comes apart it gets its margin
    /// back.
    unsigned level, again;      ///< `again`: as in bmr_contact
    double touch;               ///< ZENO_ELASTIC: the time of the last TOUCH,
    unsigned touches;           ///< and how many were at that time
    double growth, growth_step; ///< when to ask whether it is apart again; INFINITY: never
    unsigned retries;           ///< LEAVE: of the structure's start
} bmr_near;

struct bmr_body_pair {
    bmr_scheduled head;
    bmr_world_body *side[2];             ///< the first was born first; the second may be a wall
    bmr_body_pair *after[2], *before[2]; ///< in the lists of both
    bmr_body_pair *same;                 ///< scratch: another pair of the same two
    int32_t image[2];                    ///< so many boxes are added to the second's position
    uint8_t event;                       ///< bmr_pair_due
    uint8_t watch;                       ///< bmr_watch
    bool linked, neighbours;             ///< it is in the lists of both; the two's cells are neighbours
    bool kept;                           ///< scratch of a search: the two's cells still are neighbours
    bmr_near *near;                      ///< NULL with WATCH_DISKS
};

struct bmr_world {
    bmr_allocator counted; ///< through which all memory goes
    const bmr_allocator *allocator;
    bmr_world_def def;
    double time;
    bool inside; ///< a callback is running
    bmr_world_trouble trouble;
    bmr_body_pair *busy; ///< whose contact is being reported
    bmr_event_queue queue;
    bmr_world_counts counts;

    bmr_world_body **bodies; ///< by place: the lower half of an id
    uint32_t *generations;   ///< the upper half of the next id of each place
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

    struct bmr_body_image *candidates; ///< scratch
    size_t candidate_count, candidate_capacity;

    bmr_world_body walls[BMR_WALLS];
    bmr_wall_segments *segments; ///< of each power of 2 that a body was as large as: kept until the end
    bmr_compass *compass;        ///< of the walls' hierarchies
};

/// The generation of a place whose ids are used up: nobody lives there any more. (So no id is a wall's.)
#define BMR_NO_GENERATION UINT32_MAX
/// Of the table of ids, for each place: the body, and the generation of the next one there.
#define BMR_PLACE_BYTES (sizeof(bmr_world_body *) + sizeof(uint32_t))

/// A body near a place, and which image of it.
typedef struct bmr_body_image {
    bmr_world_body *body;
    int32_t image[2]; ///< of the body as seen from the place
} bmr_body_image;

/// False: every two bodies are a pair.
static inline bool bmr_world_has_grid(const bmr_world *w) {
    return !w->def.all_pairs || w->def.boundary == BMR_PERIODIC;
}
static inline bool bmr_body_is_wall(const bmr_world_body *r) {
    return bmr_is_wall(r->id);
}
static inline bool bmr_wall_is_upright(const bmr_world_body *wall) {
    return wall->id < BMR_WALL(2);
}
static inline double bmr_world_tolerance(const bmr_world *w, double time) {
    return w->def.failure.tolerance * fmax(1.0, fabs(time));
}

// base.c: memory, trouble, observers.

/// The functions of world.counted, whose context is the world.
void *bmr_world_take(void *world, size_t bytes);
void bmr_world_give(void *world, void *block, size_t bytes);
/// A body or a pair, zero but for its head, and its place in the queue. NO_MEMORY, TOO_LARGE.
bmr_error bmr_scheduled_make(bmr_world *w, size_t bytes, bool is_pair, bmr_scheduled **made);
void bmr_scheduled_destroy(bmr_world *w, bmr_scheduled *head, size_t bytes);
/// Notes what is wrong, and returns the error. `b`: BMR_NO_BODY.
bmr_error bmr_world_stop(bmr_world *w, bmr_error error, bmr_trouble kind, bmr_body a, bmr_body b);
static inline bmr_error bmr_body_pair_stop(bmr_world *w, const bmr_body_pair *c, bmr_error error,
                                           bmr_trouble kind) {
    return bmr_world_stop(w, error, kind, c->side[0]->id, c->side[1]->id);
}
/// Tells the observer of an event at the present time, and counts it.
void bmr_world_observe(bmr_world *w, bmr_world_event_kind kind, bmr_body a, bmr_body b,
                       const bmr_kds_report *report);

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
/// Is a place of the body in its cell, or outside of it by no more than this part of the cell?
bool bmr_body_in_cell(const bmr_world *w, const bmr_world_body *r, bmr_vec2 position, double border);
/// Takes the body from its cell, if it has one, to another one, or to none.
void bmr_cell_change(bmr_world *w, bmr_world_body *r, bmr_cell *cell);
/// Gives the top levels back that no body has needed for long.
void bmr_grid_lower(bmr_world *w);
bmr_vec2 bmr_cell_size(const bmr_world *w, int level);
/// A place in cells of a level, from the grid's origin.
bmr_vec2 bmr_grid_cells(const bmr_world *w, int level, bmr_vec2 position);
/// The corners of a cell that is larger by a part `border` of it on each side: counted on in a periodic box,
/// where it is that of a body.
void bmr_cell_box(const bmr_world *w, int level, int64_t column, int64_t row, double border, bmr_vec2 *low,
                  bmr_vec2 *high);
/// Fills world.candidates with the bodies whose cells are neighbours of this one, `r` itself left out.
bmr_error bmr_grid_candidates(bmr_world *w, const bmr_world_body *r, int level, int64_t column, int64_t row);
/// Part of a cell's side that is added on each of its sides before a body leaves it.
#define BMR_CELL_HYSTERESIS 0x1p-4

/// The column (or row) so many levels up; rounded down, also where it is below zero.
static inline int64_t bmr_place_above(int64_t place, int levels) {
    return place >> (levels < 63 ? levels : 63);
}

// frame.c: what a pair sees of walls, of its motions, and of a contact.

/// Where a path is at the piece's own origin of time; and the same motion from another beginning.
bmr_vec2 bmr_path_begins(const bmr_motion_piece *piece);
void bmr_path_begin_at(bmr_motion_piece *piece, bmr_vec2 position);
void bmr_walls_make(bmr_world *w);
void bmr_walls_destroy(bmr_world *w);
/// The box is on its left, where <normal, x> > offset.
bmr_line bmr_wall_line(const bmr_world *w, const bmr_world_body *wall);
/// What a body of this radius sees of walls, made where it is the first of its size. Errors: NO_MEMORY,
/// OUT_OF_RANGE (a segment too long for a polygon); then nothing changed.
bmr_error bmr_wall_segments_of(bmr_world *w, double radius, const bmr_wall_segments **segments);

/// Both motions in the pair's frame, in which each has its own rotation; `view` holds what they are made
/// of. Only what lies between the two is that of the world.
typedef struct bmr_pair_view {
    bmr_timed_piece pieces[2];
    bmr_motion motions[2];
} bmr_pair_view;
bmr_pair_motion bmr_body_pair_motion(const bmr_world *w, const bmr_body_pair *c, bmr_pair_view *view);
/// Of a wall: the segment beside the body.
const bmr_shape *bmr_body_pair_shape(const bmr_body_pair *c, int side);
/// What is added to the second's position in the world.
bmr_vec2 bmr_body_pair_shift(const bmr_world *w, const bmr_body_pair *c);
/// The two as the world has them, at the present time.
void bmr_body_pair_now(const bmr_world *w, const bmr_body_pair *c, bmr_instant now[2]);

/// A contact with the arms from both centres to its points.
typedef struct bmr_touch {
    bmr_contact contact;
    bmr_vec2 arm[2][2]; ///< of the point [1] from the origin of body [0]
} bmr_touch;
void bmr_touch_describe(const bmr_world *w, const bmr_body_pair *c, bmr_touch *touch);
/// Fills in velocities and approaches: from those of A and B.
void bmr_touch_move(bmr_touch *touch, const bmr_instant now[2]);

// deadline.c: when disks meet and part, and when they leave their cells.

/// Of places, in parts of their coordinates: 256 roundings.
#define BMR_PLACE_ROUNDING 0x1p-44
/// Of times that are sums.
#define BMR_CLOCK_ROUNDINGS 2.0
/// Disks this near have met.
double bmr_disks_reach(const bmr_world *w, const bmr_body_pair *c);
/// The distance of the disks' centres, or of the disk's centre from the wall's line.
double bmr_disks_distance(const bmr_world *w, const bmr_body_pair *c, double time);
/// The first time after `after` at which the disks meet, or part; *unfinished: not before that time, at which
/// to ask again. A function of the two motions alone. Errors: NOT_FINITE.
bmr_error bmr_disks_next(const bmr_world *w, const bmr_body_pair *c, bool meets, double after, double *time,
                         bool *unfinished);
/// When the body leaves its cell with the hysteresis, after `after`. Errors: those of bmr_failure_time.
bmr_error bmr_body_leaves_cell(const bmr_world *w, const bmr_world_body *r, double after, double *time,
                               bool *unfinished);
bmr_vec2 bmr_path_position(const bmr_motion_piece *piece, double time);

// pair.c: the life of a pair.

/// Takes the pair's next event. *touches: it ended in a contact, which bmr_contact_report is to report;
/// until then nothing is due, and the pair is as one that passes.
bmr_error bmr_body_pair_event(bmr_world *w, bmr_body_pair *c, bool *touches);
bmr_error bmr_body_pair_make(bmr_world *w, bmr_world_body *a, bmr_world_body *b, const int32_t image_of_b[2],
                             bmr_body_pair **pair);
void bmr_body_pair_link(bmr_world *w, bmr_body_pair *c);
void bmr_body_pair_destroy(bmr_world *w, bmr_body_pair *c);
static inline int bmr_body_pair_side(const bmr_body_pair *c, const bmr_world_body *r) {
    return c->side[0] == r ? 0 : 1;
}
/// Finds its next event after the present time, with `replan` after a motion changed; where it cannot be
/// done, the pair has an event now, at which it is tried again.
void bmr_body_pair_search_later(bmr_world *w, bmr_body_pair *c, bool replan);
/// After an answer: a structure with half the margin, or a quarter, and so on. STALLED.
bmr_error bmr_body_pair_resume(bmr_world *w, bmr_body_pair *c, double receding);
/// After PASS.
void bmr_body_pair_pass(bmr_world *w, bmr_body_pair *c);

/// How many contacts without coming apart it takes for the margin to be halved. With ZENO_ELASTIC they may be
/// the tremble of a jam: it goes down more slowly.
static inline unsigned bmr_levels_a_halving(const bmr_world *w) {
    return w->def.zeno == BMR_ZENO_ELASTIC ? 4 : 1;
}

// body.c: where bodies live, and what they move on.

/// What a body moves on: a piece, until when, and what comes after it (NULL: nothing).
typedef struct bmr_course {
    bmr_motion_piece piece;
    double until;
    bmr_motion *plan;
} bmr_course;

/// NULL: there is none.
bmr_world_body *bmr_world_find(const bmr_world *w, bmr_body id);
/// Takes the body's next event.
bmr_error bmr_body_event(bmr_world *w, bmr_world_body *r);
/// From the present time on it moves so, and has the plan. Searches of its certificates that cannot be done
/// are left to the next advance. Errors: NO_MEMORY: as it was (where the pose jumps).
bmr_error bmr_body_move(bmr_world *w, bmr_world_body *r, const bmr_course *course);
void bmr_body_destroy(bmr_world *w, bmr_world_body *r);

// answer.c: what becomes of a contact.

/// Tells the contact, and does what is answered. After an error other than NO_MEMORY the pair passes.
bmr_error bmr_contact_report(bmr_world *w, bmr_body_pair *c);

#endif
