// SPDX-License-Identifier: MIT
#include "exact32/swept32.h"

#include "exact32/clip.h"

// A search that has not found its direction after so many steps is left: the hulls have at most 8 vertices
// each, and nearly all searches end after three.
enum { MOST_STEPS = 8 };

// The search ends at a step that comes nearer by less than this part of the distance.
static const float least_gain = 1e-3f;

// The series of sine and cosine in go_back are good to the last bit of a float up to this angle.
static const float most_turn = 0.25f;

static float4 length2(float4 x, float4 y) {
    return add4(mul4(x, x), mul4(y, y));
}

/// The points, x and y apart; the lanes of `inside` hold one each, the others repeat the first.
typedef struct lanes8 {
    float4 x[2], y[2];
    mask4 inside[2];
} lanes8;

static lanes8 load(const bmr_vec32 *points, int32_t count) {
    lanes8 l;
    l.inside[0] = first_lanes4(count, 0);
    l.inside[1] = first_lanes4(count, 1);
    const float4 x0 = all4(points[0].x), y0 = all4(points[0].y);
    if (count < 3) { // not in an array of 8
        const bmr_vec32 *second = points + (count - 1);
        l.x[0] = lows4(zip_low4(x0, all4(second->x)), x0);
        l.y[0] = lows4(zip_low4(y0, all4(second->y)), y0);
        l.x[1] = x0;
        l.y[1] = y0;
        return l;
    }
    for (int g = 0; g < 2; ++g) {
        const float4 p = load4(&points[4 * g].x), q = load4(&points[4 * g + 2].x);
        l.x[g] = select4(l.inside[g], evens4(p, q), x0);
        l.y[g] = select4(l.inside[g], odds4(p, q), y0);
    }
    return l;
}

/// The least of each of four vectors, side by side.
static float4 least_of_each4(float4 a, float4 b, float4 c, float4 d) {
    const float4 ab = min4(zip_low4(a, b), zip_high4(a, b)), cd = min4(zip_low4(c, d), zip_high4(c, d));
    return min4(lows4(ab, cd), highs4(ab, cd));
}

/// radius, width, edge and least of the placed points.
static void measure(bmr_swept32 *shape, const lanes8 *l, int32_t count) {
    const float4 r0 = length2(l->x[0], l->y[0]), r1 = length2(l->x[1], l->y[1]);
    // A NaN would slip through the maxima below.
    const int broken = any4(unordered4(r0, r1));
    shape->radius = broken ? INFINITY : root_of4(most_of4(max4(r0, r1)));
    const float4 most_x = max4(l->x[0], l->x[1]), most_y = max4(l->y[0], l->y[1]);
    store4(shape->least, least_of_each4(min4(l->x[0], l->x[1]), sub4(zero4(), most_x), min4(l->y[0], l->y[1]),
                                        sub4(zero4(), most_y)));
    if (count < 2) {
        shape->width = 0.0f;
        shape->edge = FLT_MAX;
        return;
    }
    const float dx = -shape->least[1] - shape->least[0], dy = -shape->least[3] - shape->least[2];
    shape->width = root_of4(dx * dx + dy * dy);
    // The side after the last point ends in a lane that repeats the first.
    const float4 e0 =
        length2(sub4(slide4(l->x[0], l->x[1]), l->x[0]), sub4(slide4(l->y[0], l->y[1]), l->y[0]));
    const float4 e1 =
        length2(sub4(slide4(l->x[1], l->x[0]), l->x[1]), sub4(slide4(l->y[1], l->y[0]), l->y[1]));
    const float4 far_away = all4(FLT_MAX);
    shape->edge =
        root_of4(least_of4(min4(select4(l->inside[0], e0, far_away), select4(l->inside[1], e1, far_away))));
}

static void place(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count, const bmr_motion32 *motion) {
    lanes8 l = load(points, count);
    const float4 s = all4(motion->s), c = all4(motion->c);
    const float4 cx = all4(motion->center.x), cy = all4(motion->center.y);
    for (int g = 0; g < 2; ++g) {
        const float4 x = sub4(l.x[g], cx), y = sub4(l.y[g], cy);
        l.x[g] = sub4(mul4(c, x), mul4(s, y));
        l.y[g] = add4(mul4(s, x), mul4(c, y));
        store4(shape->x + 4 * g, l.x[g]);
        store4(shape->y + 4 * g, l.y[g]);
    }
    measure(shape, &l, count);
}

typedef struct along8 {
    float4 v[2];
} along8;

static along8 along(const float *x, const float *y, bmr_vec32 n) {
    const float4 nx = all4(n.x), ny = all4(n.y);
    along8 r;
    for (int g = 0; g < 2; ++g)
        r.v[g] = add4(mul4(nx, load4(x + 4 * g)), mul4(ny, load4(y + 4 * g)));
    return r;
}

/// Least of b's points along n less the most of a's.
static inline float gap(const bmr_swept32 *a, const bmr_swept32 *b, bmr_vec32 n) {
    const along8 pa = along(a->x, a->y, n), pb = along(b->x, b->y, n);
    const float4 most = max4(pa.v[0], pa.v[1]), least = min4(pb.v[0], pb.v[1]);
    const float4 minus_most = sub4(zero4(), most);
    float4 both = min4(zip_low4(least, minus_most), zip_high4(least, minus_most));
    both = min4(both, highs4(both, both));
    return sum_of_first4(both);
}

/// Which point of the shape is farthest along n.
static bmr_vec32 farthest(const bmr_swept32 *shape, bmr_vec32 n) {
    const along8 p = along(shape->x, shape->y, n);
    const float4 most = all4(most_of4(max4(p.v[0], p.v[1])));
    // (The last, where no product is a number.)
    const int i = lowest_bit(bits4(equal4(p.v[0], most)) | bits4(equal4(p.v[1], most)) << 4 | 0x80u);
    const bmr_vec32 r = {shape->x[i], shape->y[i]};
    return r;
}

void bmr_swept32_make(bmr_swept32 *shape, const bmr_vec32 *points, int32_t count,
                      const bmr_motion32 *motion) {
    shape->end = motion->end;
    shape->back = minus(motion->start, motion->end);
    shape->turn = motion->turn;
    place(shape, points, count, motion);
}

/// What is the same for all directions.
typedef struct sweeps {
    const bmr_swept32 *a, *b;
    bmr_vec32 between; ///< from a's centre to b's, at the end
    bmr_vec32 back;    ///< how much more that is at the start
    float apart;       ///< asked for
    float swing;       ///< how far turning may bring points closer, at most
} sweeps;

/// By how much b was closer to a along n at the start than at the end, as far as the centres' motion goes, as
/// a negative number; 0 if it was not. A NaN stays a NaN.
static float slide(const sweeps *q, bmr_vec32 n) {
    const float s = dot(n, q->back);
    return s > 0.0f ? 0.0f : s;
}

/// The points at the start of the motion, by turning them back from the end.
static void go_back(const bmr_swept32 *shape, bmr_swept32 *start) {
    const float t = shape->turn, t2 = t * t;
    const float s = -t * (1.0f - t2 * (1.0f / 6.0f) * (1.0f - t2 * (1.0f / 20.0f)));
    const float c = 1.0f - t2 * 0.5f * (1.0f - t2 * (1.0f / 12.0f) * (1.0f - t2 * (1.0f / 30.0f)));
    for (int i = 0; i < BMR_SWEPT32_MOST; ++i) {
        start->x[i] = c * shape->x[i] - s * shape->y[i];
        start->y[i] = s * shape->x[i] + c * shape->y[i];
    }
}

/// Does the direction separate by more than is needed at both ends of the motion? A point that turns lies at
/// most the height of its arc nearer in between than at both ends, radius times the square of the turn over
/// eight. That is far less than the length of the arc.
static bool apart_at_both_ends(const sweeps *q, bmr_vec32 n, float at_end) {
    const float ta = q->a->turn, tb = q->b->turn;
    if (!(fabsf(ta) <= most_turn) || !(fabsf(tb) <= most_turn))
        return false;
    const float needed = q->apart + 0.125f * (q->a->radius * ta * ta + q->b->radius * tb * tb);
    if (!(at_end > needed))
        return false;
    bmr_swept32 a, b;
    go_back(q->a, &a);
    go_back(q->b, &b);
    return dot(n, q->between) + dot(n, q->back) + gap(&a, &b, n) > needed;
}

/// Does the direction keep the two apart during all of the motion? *found: how far apart they would stay
/// along it if nothing turned.
static inline bool keeps_apart(const sweeps *q, bmr_vec32 n, float *found) {
    const float at_end = dot(n, q->between) + gap(q->a, q->b, n);
    *found = at_end + slide(q, n);
    return *found - q->swing > q->apart || (q->swing > 0.0f && apart_at_both_ends(q, n, at_end));
}

/// x, -x, y, -y
static float4 both_ways(bmr_vec32 v) {
    return lows4(zip_low4(all4(v.x), all4(-v.x)), zip_low4(all4(v.y), all4(-v.y)));
}

/// The same for the two axes and their opposites at once. Most shapes that are near each other and do not
/// meet are told apart by one of them.
static bool axis_keeps_apart(const sweeps *q, bmr_vec32 *axis) {
    static const bmr_vec32 axes[4] = {{1.0f, 0.0f}, {-1.0f, 0.0f}, {0.0f, 1.0f}, {0.0f, -1.0f}};
    const float4 gap = add4(load4(q->b->least), swap4(load4(q->a->least)));
    const float4 slides = min4(zero4(), both_ways(q->back)); // a NaN stays one
    const float4 found = add4(add4(both_ways(q->between), gap), slides);
    const unsigned apart = bits4(less4(all4(q->apart + q->swing), found));
    if (apart == 0 || any4(unordered4(found, found)))
        return false;
    *axis = axes[lowest_bit(apart)];
    return true;
}

/// The point of the segment from p to q that is closest to the origin.
static bmr_vec32 closest_on_segment(bmr_vec32 p, bmr_vec32 q) {
    const bmr_vec32 e = minus(q, p);
    const float along_e = -dot(p, e), length2_e = dot(e, e);
    if (!(along_e > 0.0f))
        return p;
    if (along_e >= length2_e)
        return q;
    const float t = along_e / length2_e;
    const bmr_vec32 r = {p.x + t * e.x, p.y + t * e.y};
    return r;
}

/// The vertex of the difference b - a, swept along the motion of the centres, that is least along n.
static bmr_vec32 support(const sweeps *q, bmr_vec32 n) {
    const bmr_vec32 back = {-n.x, -n.y};
    const bmr_vec32 pa = farthest(q->a, n), pb = farthest(q->b, back);
    const bool at_start = dot(n, q->back) < 0.0f;
    const bmr_vec32 w = {q->between.x + (at_start ? q->back.x : 0.0f) + pb.x - pa.x,
                         q->between.y + (at_start ? q->back.y : 0.0f) + pb.y - pa.y};
    return w;
}

/// Searches for the point of the swept difference b - a that is nearest to the origin. Ends as soon as a
/// direction keeps the two apart, or two of their points are so near that none can.
static bool search(const sweeps *q, bmr_vec32 n, bmr_vec32 *direction) {
    if (!(q->swing <= FLT_MAX)) // a radius is infinite; the supports below would pass a NaN over
        return false;
    bmr_vec32 kept = support(q, n), other = kept, closest = kept;
    bool segment = false;
    for (int step = 0; step < MOST_STEPS; ++step) {
        const float length = root_of4(dot(closest, closest));
        // No direction does better than the closest points known, and none leads away from the origin.
        if (length <= q->apart || !(length > 0.0f))
            return false;
        n.x = closest.x / length;
        n.y = closest.y / length;
        float found;
        if (keeps_apart(q, n, &found)) {
            *direction = n;
            return true;
        }
        if (!(found < length * (1.0f - least_gain)))
            return false;
        const bmr_vec32 w = support(q, n);
        const bmr_vec32 first = closest_on_segment(kept, w);
        const bmr_vec32 second = segment ? closest_on_segment(other, w) : first;
        if (dot(second, second) < dot(first, first)) {
            kept = other;
            closest = second;
        } else {
            closest = first;
        }
        other = w;
        segment = true;
    }
    return false;
}

/// From somewhere within a to somewhere within b, at the end: the centres of motion may be far outside.
static bmr_vec32 between_middles(const sweeps *q) {
    bmr_vec32 r = q->between;
    for (int i = 0; i < 4; ++i) {
        r.x += 0.25f * (q->b->x[i] - q->a->x[i]);
        r.y += 0.25f * (q->b->y[i] - q->a->y[i]);
    }
    return r;
}

static sweeps sweeps_of(const bmr_swept32 *a, const bmr_swept32 *b, float apart) {
    sweeps q;
    q.a = a;
    q.b = b;
    q.between = minus(b->end, a->end);
    q.back = minus(b->back, a->back);
    q.apart = apart;
    q.swing = a->radius * fabsf(a->turn) + b->radius * fabsf(b->turn);
    return q;
}

bool bmr_swept32_apart_along(const bmr_swept32 *a, const bmr_swept32 *b, float apart, bmr_vec32 direction) {
    const sweeps q = sweeps_of(a, b, apart);
    float found;
    return keeps_apart(&q, direction, &found);
}

bool bmr_swept32_find_apart(const bmr_swept32 *a, const bmr_swept32 *b, float apart, bmr_vec32 *direction) {
    const sweeps q = sweeps_of(a, b, apart);
    const bmr_vec32 hint = *direction;
    const bool hinted = dot(hint, hint) > 0.0f;
    float found;
    return (hinted && keeps_apart(&q, hint, &found)) || axis_keeps_apart(&q, direction) ||
           search(&q, hinted ? hint : between_middles(&q), direction);
}
