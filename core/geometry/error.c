// SPDX-License-Identifier: MIT
#include "boomerang/error.h"

const char *bmr_error_describe(bmr_error error) {
    switch (error) {
    case BMR_OK:
        return "no error";
    case BMR_ERROR_NULL_ARGUMENT:
        return "a pointer that must not be NULL is NULL";
    case BMR_ERROR_NO_POINTS:
        return "a polygon needs at least one point";
    case BMR_ERROR_TOO_MANY_POINTS:
        return "a polygon takes at most 65535 points";
    case BMR_ERROR_NOT_FINITE:
        return "a coordinate is NaN or infinite";
    case BMR_ERROR_OUT_OF_RANGE:
        return "a number is outside of what the call takes: a coordinate beyond 1e9, a polygon too small, a "
               "size not above 0";
    case BMR_ERROR_NO_MEMORY:
        return "the allocator had no memory";
    case BMR_ERROR_NOT_CONVEX:
        return "the vertices are not strictly convex and counter-clockwise";
    case BMR_ERROR_TABLE_TOO_SMALL:
        return "the compass table has too few levels for a polygon of this many vertices";
    case BMR_ERROR_INVALID_STRUCTURE:
        return "the audited structure contradicts itself";
    case BMR_ERROR_FALSE_CERTIFICATE:
        return "the audited certificate does not prove what it claims";
    case BMR_ERROR_STALLED:
        return "a pair has event after event while time stands still";
    case BMR_ERROR_UNKNOWN_ENGINE:
        return "the Box2D of this process is none that this library knows";
    case BMR_ERROR_TOO_FEW_POINTS:
        return "a polygon with an area needs at least three points that are not on one line";
    case BMR_ERROR_TOO_CLOSE:
        return "two points are so close together that the physics engine would make one of them";
    case BMR_ERROR_COUNT:
        break;
    }
    return "not an error code of this library";
}
