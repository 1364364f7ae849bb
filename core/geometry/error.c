// SPDX-License-Identifier: MIT
#include "boomerang/error.h"

const char *bmr_error_describe(bmr_error error) {
    switch (error) {
    case BMR_OK:
        return "no error";
    case BMR_ERROR_NULL_ARGUMENT:
        return "a pointer that must not be NULL is NULL: pass what is asked about, and an address for the "
               "result";
    case BMR_ERROR_NO_POINTS:
        return "there are no points: a polygon needs at least one";
    case BMR_ERROR_TOO_MANY_POINTS:
        return "a polygon takes at most 65535 points: leave some out, or give fewer vertices to what is "
               "round";
    case BMR_ERROR_NOT_FINITE:
        return "a number is NaN or infinite: look for a division by zero or an overflow where it was made";
    case BMR_ERROR_OUT_OF_RANGE:
        return "a number is outside of what the call takes: coordinates up to 1e9, polygons and their areas "
               "not next to nothing, sizes above 0 (for a repair's coordinates, a larger snap helps); the "
               "call's "
               "comment has the rest";
    case BMR_ERROR_NO_MEMORY:
        return "the allocator had no memory: nothing was changed, so free some and call again";
    case BMR_ERROR_NOT_CONVEX:
        return "the vertices are not strictly convex and counter-clockwise: sort them so, or use the call "
               "that makes a hull of points in any order";
    case BMR_ERROR_TABLE_TOO_SMALL:
        return "the compass table has too few levels for a polygon of this many vertices: make it for the "
               "largest polygon";
    case BMR_ERROR_INVALID_STRUCTURE:
        return "the audited structure contradicts itself: a repair was wrong, it was written to, or what it "
               "was made of has changed";
    case BMR_ERROR_FALSE_CERTIFICATE:
        return "the audited certificate does not prove what it claims: ask at the pose and with the polygons "
               "that it was made for";
    case BMR_ERROR_STALLED:
        return "a pair has event after event while time stands still: give it a larger margin or hysteresis, "
               "or other motions";
    case BMR_ERROR_UNSUPPORTED:
        return "this process has a part or a version of it that the call cannot work with: its comment says "
               "which it "
               "can";
    case BMR_ERROR_TOO_FEW_POINTS:
        return "a polygon with an area needs at least three points that are not on one line: add one beside "
               "it";
    case BMR_ERROR_TOO_CLOSE:
        return "two points are so close together that they would become one: leave one out, or make the "
               "polygon larger";
    case BMR_ERROR_NEGATIVE:
        return "a count, a tolerance, a density or a friction is below 0: give 0 or more (and a snap above "
               "0)";
    case BMR_ERROR_CORNER_TOO_LARGE:
        return "the corner's radius is more than half of a side: make it at most the half width and the half "
               "height";
    case BMR_ERROR_TOO_LARGE:
        return "what was asked for takes more bytes than this machine can address: ask for fewer bodies, "
               "points or steps";
    case BMR_ERROR_WRONG_HIERARCHY:
        return "a hierarchy was built over another polygon than the one beside it, or is of another kind "
               "than "
               "its place says: build it over this polygon";
    case BMR_ERROR_UNKNOWN_NAME:
        return "nothing has that name: the call beside the one that looked for it lists the names that there "
               "are";
    case BMR_ERROR_CROSSING_EDGES:
        return "two edges of the outline cross: the fault beside the error names them, and where";
    case BMR_ERROR_OVERLAPPING_EDGES:
        return "two edges of the outline run along each other: remove the spike, or join the two rings; the "
               "fault beside the error names them";
    case BMR_ERROR_HOLE_OUTSIDE:
        return "a hole is not inside the outline's outer ring, or is inside another hole: give the outer "
               "ring first, and an island as an outline of its own";
    case BMR_ERROR_WORLD_LOCKED:
        return "the body's world is in the middle of a step: change its fixtures before or after it";
    case BMR_ERROR_FAR_FROM_ORIGIN:
        return "the shapes are too far from the origin of their body for floats to hold its inertia, or the "
               "points of an outline for floats to hold its area: put the origin near the shapes (subtract "
               "one "
               "from all points), or fix the rotation";
    case BMR_ERROR_COUNT:
        break;
    }
    return "not an error code of this library";
}
