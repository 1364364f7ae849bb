// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_ANALYSIS_H
#define BOOMERANG_ANALYSIS_H

#include "boomerang/families.h"
#include "boomerang/simulation.h"

#ifdef __cplusplus
extern "C" {
#endif

/// @file
/// The cost of a run of a kinetic structure, and the least cost possible: counts of one run, the offline
/// optimum, hysteresis, clear decompositions (section 6 of the paper), growth fits, and the four qualities of
/// a kinetic structure. In boomerang::kinetic.

/// Two polygons and how they move over [from, to] (finite). The motions are read only.
typedef struct bmr_course {
    const bmr_polygon *polygons[2];
    bmr_motion *motions[2];
    double from, to;
} bmr_course;

// ---- The offline optimum ----

/// A line that stays: a direction fixed in the owner's frame, with the offset of the owner's support. It
/// separates by at least the margin all the time from `from` to `to`.
typedef struct bmr_cover_line {
    double from, to;
    int owner;          ///< 0: A, 1: B
    bmr_vec2 direction; ///< owner's frame, unit, towards the other
} bmr_cover_line;

/// The fewest such lines that cover the course, between two bounds. Times of contact (distance at most the
/// margin) are left out; after each a new line begins.
typedef struct bmr_optimum {
    uint64_t least;    ///< no cover of the samples has fewer: a lower bound
    uint64_t found;    ///< size of a cover that was found
    uint64_t samples;  ///< poses looked at
    uint64_t contacts; ///< times of contact
} bmr_optimum;

/// The offline optimum, by the greedy running intersection of the cones of separating directions (between the
/// inner common tangents), in each body's frame; at each line it takes the frame whose intersection lasts
/// longer. That is optimal, because a line that covers a time covers any part of it. The cones are sampled.
/// Samples are refined until the cone's ends move by less than `resolution` (in (0, 1/4]) of its width from
/// sample to sample and half way between, and their paths bend by less than resolution / 4 * least distance /
/// size.
///
/// `least` takes the cones of the samples as they are, and no cover has fewer lines. For `found` a line must
/// hold at the samples, with a margin for the bend of the ends' paths between them. Tests find that its lines
/// hold everywhere, but that is no proof. `lines` (NULL, or `capacity` lines) gets the first lines of the
/// cover found. 0.02 is a good resolution. Errors: NULL_ARGUMENT, OUT_OF_RANGE (resolution, margin not
/// positive, from > to).
bmr_error bmr_offline_optimum(const bmr_course *course, double margin, double resolution,
                              bmr_cover_line *lines, size_t capacity, bmr_optimum *optimum);

// ---- Clear decompositions (section 6) ----

/// The size of the smallest kappa-clear decomposition of a path in configuration space, between two bounds. A
/// disk is kappa-clear if its radius is at most 1/kappa of its centre's distance. The distance of two
/// configurations is |translation| + diameter * |rotation|; under translation it is the plane's.
typedef struct bmr_clear {
    uint64_t least;   ///< greedy by what every segment in a clear disk must fulfil: its diameter is
                      ///< at most 2 / (kappa - 1) of the least distance on it
    uint64_t found;   ///< greedy by clear disks about the segments' first points
    uint64_t samples; ///< poses looked at
} bmr_clear;

/// `kappa` > 1. `diameter` >= 0 is the weight of a radian (0 for a path without rotation). Both are finite.
/// Steps are a twentieth of a clear disk's radius, so their number grows with kappa. Errors: NULL_ARGUMENT;
/// OUT_OF_RANGE for other numbers, and for a path that comes nearer than 1e-9 of the extents, which has no
/// decomposition.
bmr_error bmr_clear_decomposition(const bmr_course *course, double kappa, double diameter, bmr_clear *clear);

// ---- Hysteresis (section 6) ----

/// The least change of the configuration from one event to the next, in units of the distance at the first.
typedef struct bmr_hysteresis {
    double both;         ///< least (|tau| + diameter |delta|) / d, tau the displacement, delta the rotation
    double displacement; ///< least |tau| / d where nothing turned
    double rotation;     ///< least diameter |delta| / d where nothing else moved
    uint64_t intervals;  ///< between events
    // The last event.
    bmr_pose pose;
    double distance;
} bmr_hysteresis;

/// A record without events: all minima are INFINITY.
bmr_hysteresis bmr_hysteresis_make(void);
/// Adds one event (START and LEAVE too) at a pose of B in A's frame. If the pair is in contact, the next
/// interval does not count.
void bmr_hysteresis_add(bmr_hysteresis *hysteresis, const bmr_polygon *a, const bmr_polygon *b,
                        double diameter, const bmr_pose *b_in_a);

// ---- One run ----

typedef struct bmr_run_def {
    const bmr_kds_info *structure;
    bmr_shape shapes[2];           ///< their polygons are the course's
    bmr_simulation_def simulation; ///< its `structure` is ignored
    bool audit;                    ///< prove everything again at every event
    bmr_simulation_observer observer;
    void *context;
} bmr_run_def;

/// The four qualities of a kinetic structure.
typedef struct bmr_qualities {
    double conditions;   ///< compact: the most certificates at any event
    double bytes;        ///< compact: of the pair's state
    double touched;      ///< responsive: elementary steps of a repair (bmr_kds_report), mean ..
    double touched_most; ///< .. and most
    double replanned;    ///< local: failure times that a change of plan computes anew
    double efficiency;   ///< efficient: events over external events (contacts begun and ended), 0 external
                         ///< counted as 1
} bmr_qualities;

typedef struct bmr_run {
    bmr_simulation_counts counts;
    uint64_t events; ///< certificates that failed and were repaired: no starts, contacts and leaves
    uint64_t lines;  ///< of those, events that replaced the line
    bmr_qualities qualities;
    bmr_hysteresis hysteresis;
    bmr_error audit; ///< the first error of the audits
} bmr_run;

/// Takes one structure along a course. Errors: those of bmr_simulation_create and bmr_simulation_run. An
/// audit that fails is no error of this call; it is in the result.
bmr_error bmr_run_course(const bmr_run_def *def, const bmr_course *course, double diameter,
                         const bmr_allocator *allocator, bmr_run *run);

// ---- Growth ----

/// y as a function of x: constant * x^exponent, or offset + slope * log2 x. Errors are half widths of 95 %
/// confidence intervals (Student's t; INFINITY for two points).
typedef struct bmr_growth {
    double exponent, exponent_error;
    double constant;           ///< of the power
    double slope, slope_error; ///< a doubling of x adds `slope`
    double offset;
    double power_residual, log_residual; ///< root mean square of (y - fit) / max(fit, 1)
    bool logarithmic;                    ///< the log fit's residual is the smaller one
    size_t count;                        ///< points used
} bmr_growth;

/// Least squares: of log y on log x for the power, of y on log2 x for the other. Points with y = 0 count in
/// the second only. Errors: NULL_ARGUMENT, OUT_OF_RANGE (fewer than two points of different x with y > 0, x
/// not positive, y negative, more than 256 points), NOT_FINITE.
bmr_error bmr_fit_growth(const double *x, const double *y, size_t count, bmr_growth *growth);

#ifdef __cplusplus
}
#endif
#endif
