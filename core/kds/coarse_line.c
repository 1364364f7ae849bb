// SPDX-License-Identifier: MIT
#include "kds/coarse_line.h"

#include "geometry/distance.h"
#include "kds/cone.h"

/// The directions that separate, as one body sees them: outwards from it, less than half a turn wide.
typedef struct fan {
    bmr_vec2 low, high, closest;
} fan;

/// An edge's normal, or an axis, that separates; and how deep it is in the body's tree.
typedef struct pick {
    bmr_vec2 normal; ///< owner's frame
    unsigned depth;
} pick;

static bool separates(const fan *f, bmr_vec2 normal) {
    return bmr_cross(f->low, normal) > 0.0 && bmr_cross(normal, f->high) > 0.0;
}

/// Axis `k` of a frame, counter-clockwise.
static bmr_vec2 axis(unsigned k) {
    static const bmr_vec2 axes[4] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    return axes[k & 3u];
}

/// The quadrant, counter-clockwise from axis `k`, that has the direction in it.
static unsigned quadrant(bmr_vec2 d) {
    if (d.x > 0.0 && d.y >= 0.0)
        return 0;
    if (d.x <= 0.0 && d.y > 0.0)
        return 1;
    return d.x < 0.0 ? 2 : 3;
}

/// Of two axes that separate (there are no more) the one nearer to the closest direction.
static bool pick_axis(const fan *f, pick *best) {
    double most = -2.0;
    for (unsigned k = 0; k < 4; ++k) {
        const double nearness = bmr_dot(axis(k), f->closest);
        if (nearness > most && separates(f, axis(k))) {
            most = nearness;
            *best = (pick){axis(k), 0};
        }
    }
    return most > -2.0;
}

/// Where no axis separates, all that do are in one quadrant, and down its tree one of two halves has them.
static bool pick_edge(const bmr_polygon *p, const fan *f, pick *best, unsigned *steps) {
    const unsigned k = quadrant(f->closest);
    const uint32_t n = p->count, first = bmr_support_counted(p, axis(k), steps),
                   last = bmr_support_counted(p, axis(k + 1), steps);
    uint32_t low = 0, high = last >= first ? last - first : last + n - first;
    for (unsigned depth = 1; low < high; ++depth) {
        ++*steps;
        const uint32_t middle = low + (high - low) / 2, edge = first + middle;
        const bmr_vec2 normal = bmr_polygon_normal(p, edge < n ? edge : edge - n);
        if (separates(f, normal)) {
            *best = (pick){normal, depth};
            return true;
        }
        if (bmr_cross(normal, f->closest) > 0.0)
            low = middle + 1;
        else
            high = middle;
    }
    return false;
}

bool bmr_coarse_line(const bmr_kds *kds, const bmr_pose *b_in_a, bmr_vec2 closest, const uint32_t support[2],
                     bmr_windowed_line *line) {
    const double least = bmr_windowed_least(kds);
    const bmr_vec2 low = bmr_cone_end(kds, b_in_a, closest, least, -1, support),
                   high = bmr_cone_end(kds, b_in_a, closest, least, 1, support);
    const fan seen[2] = {{low, high, closest},
                         {bmr_unrotate(b_in_a, bmr_neg(low)), bmr_unrotate(b_in_a, bmr_neg(high)),
                          bmr_unrotate(b_in_a, bmr_neg(closest))}};
    pick best = {{0.0, 0.0}, 0};
    int owner = -1;
    unsigned steps = 0;
    for (int body = 0; body < 2; ++body) {
        pick here;
        const bool found =
            pick_axis(&seen[body], &here) || pick_edge(kds->shapes[body].polygon, &seen[body], &here, &steps);
        if (!found || (owner >= 0 && best.depth <= here.depth))
            continue;
        best = here;
        owner = body;
    }
    bmr_kds_tally(kds, steps);
    if (owner < 0)
        return false;
    const bmr_vec2 direction = owner == 0 ? best.normal : bmr_neg(bmr_rotate(b_in_a, best.normal));
    bmr_windowed_line_set(line, kds, b_in_a, owner, direction, support);
    // Where little more than `least` is left, rounding moves the ends of the fan.
    const bmr_vec2 p = kds->shapes[0].polygon->vertices[line->support[0]],
                   q = kds->shapes[1].polygon->vertices[line->support[1]];
    if (!(bmr_dot(direction, bmr_sub(bmr_transform(b_in_a, q), p)) > least))
        return false;
    bmr_windowed_exact(line, kds, b_in_a, 0);
    return true;
}
