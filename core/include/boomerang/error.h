// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_ERROR_H
#define BOOMERANG_ERROR_H

// Exported from a shared library. A build of a DLL defines it.
#if !defined(BMR_API)
#    if defined(__GNUC__) && !defined(_WIN32)
#        define BMR_API __attribute__((visibility("default")))
#    else
#        define BMR_API
#    endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// Functions of core return these. An error leaves the outputs as they were, or the comment says more.
typedef enum bmr_error {
    BMR_OK = 0,
    BMR_ERROR_NULL_ARGUMENT,     ///< a pointer that must not be NULL is NULL
    BMR_ERROR_NO_POINTS,         ///< a polygon needs at least one point
    BMR_ERROR_TOO_MANY_POINTS,   ///< more than BMR_MAX_VERTICES points
    BMR_ERROR_NOT_FINITE,        ///< a coordinate is NaN or infinite
    BMR_ERROR_OUT_OF_RANGE,      ///< a coordinate is too large (BMR_MAX_COORDINATE), a polygon too small
                                 ///< (BMR_MIN_SIDE), or another number outside the range of the call
    BMR_ERROR_NO_MEMORY,         ///< the allocator returned NULL
    BMR_ERROR_NOT_CONVEX,        ///< raw vertices that are not strictly convex and counter-clockwise
    BMR_ERROR_TABLE_TOO_SMALL,   ///< the compass table has fewer levels than the polygon asks for
    BMR_ERROR_INVALID_STRUCTURE, ///< an audit found a structure that contradicts itself
    BMR_ERROR_FALSE_CERTIFICATE, ///< an audit found a certificate that does not prove what it claims
    BMR_ERROR_STALLED,           ///< a pair of a simulation has event after event while time does not advance
    BMR_ERROR_UNSUPPORTED,       ///< the call does not know the version of a library in this process
    BMR_ERROR_TOO_FEW_POINTS,    ///< fewer than three points, or all on one line as far as floats can tell
    BMR_ERROR_TOO_CLOSE,         ///< points so close together that they would become one
    BMR_ERROR_NEGATIVE,          ///< a count, tolerance, density or friction below zero, a snap not above it
    BMR_ERROR_CORNER_TOO_LARGE,  ///< a corner's radius above half of a side
    BMR_ERROR_TOO_LARGE,         ///< it would take more bytes than this machine can address
    BMR_ERROR_WRONG_HIERARCHY,   ///< a hierarchy of another polygon or of another kind
    BMR_ERROR_UNKNOWN_NAME,      ///< nothing has that name
    BMR_ERROR_CROSSING_EDGES,    ///< two edges of an outline cross
    BMR_ERROR_OVERLAPPING_EDGES, ///< two edges of an outline have more than a point in common
    BMR_ERROR_HOLE_OUTSIDE,    ///< a hole of an outline is not inside its outer ring, or inside another hole
    BMR_ERROR_WORLD_LOCKED,    ///< the call changes a body while its world is stepped
    BMR_ERROR_FAR_FROM_ORIGIN, ///< so far from the origin floats cannot hold an inertia or an area
    BMR_ERROR_COUNT            ///< number of codes; not an error
} bmr_error;

/// One English sentence for `error`, without a full stop: what is wrong and what to do about it. Each code
/// has its own. Never NULL, also for values that are no bmr_error.
BMR_API const char *bmr_error_describe(bmr_error error);

#ifdef __cplusplus
}
#endif
#endif
