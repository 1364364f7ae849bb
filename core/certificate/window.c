// SPDX-License-Identifier: MIT
#include "certificate/window.h"

#include <math.h>

#include "geometry/distance.h"
#include "geometry/length.h"

/// No tangent is turned farther than this (75 degrees) in one go, so that any bracket stays well below 180.
#define WIDEST_COSINE 0.25881904510252074

/// A leaning bracket reaches backwards by at most this (15 degrees): enough to bear some trembling.
#define BACKWARD_COSINE 0.96592582628906831
/// ... and by what costs this part of the limit: a quarter of the full turn, losses being quadratic in the
/// angle.
#define BACKWARD_PART 0.0625

/// Looks for the number of vertices to pass. Guesses from "losses are quadratic" settle it in two or three.
#define GUESSES 5
/// The first guess is this part of all vertices (5.6 degrees of a regular polygon), and one more.
#define FIRST_GUESS_PART 64
/// Never guess more than this many times farther or nearer.
#define LARGEST_FACTOR 16u
/// Where vertices crowd the guesses may leave next to nothing. Then the search goes on, by halves, until the
/// loss is this part of the limit at least (or no more can be had): so the angle of a turn is bounded below
/// by the limit over the polygon's diameter, however its vertices lie.
#define ENOUGH_PART 0.25

/// A chord is along a tangent when it falls by no more than this part of its length: the rounding of a unit
/// normal. (A tangent that was turned onto an edge is seen to fall or to rise by that much.)
#define FLAT 1e-15

/// A support line of the polygon: its outer normal (unit length) and a vertex on it.
typedef struct tangent {
    bmr_vec2 direction;
    uint32_t vertex;
} tangent;

/// A tangent about to be turned. All is written for one sense of turning; the other is its mirror image.
typedef struct turning {
    const bmr_polygon *polygon;
    int sense; ///< 1 counter-clockwise, -1 clockwise
    tangent from;
    bmr_vec2 along; ///< the way on the tangent towards the vertices that come next
    bmr_vec2 start; ///< the last vertex on the tangent in that sense
    double limit, cosine;
    unsigned *steps; ///< counts the edges looked at
} turning;

static inline uint32_t next_vertex(const bmr_polygon *p, uint32_t i, int sense) {
    return sense > 0 ? bmr_vertex_after(p, i) : bmr_vertex_before(p, i);
}

/// The vertex `steps` (< count) after the start.
static inline uint32_t vertex_after(const turning *t, uint32_t steps) {
    const uint32_t n = t->polygon->count;
    if (t->sense > 0)
        return t->from.vertex + steps < n ? t->from.vertex + steps : t->from.vertex + steps - n;
    return t->from.vertex >= steps ? t->from.vertex - steps : t->from.vertex + n - steps;
}

/// The outer normal, not normalised, of the edge that leads from vertex `steps` to the next in the sense of
/// turning.
static bmr_vec2 normal_after(const turning *t, uint32_t steps, bmr_vec2 *vertex) {
    const uint32_t i = vertex_after(t, steps), j = next_vertex(t->polygon, i, t->sense);
    *vertex = t->polygon->vertices[i];
    const bmr_vec2 e = bmr_scale_up_if_tiny(bmr_sub(t->polygon->vertices[j], *vertex));
    return t->sense > 0 ? bmr_vec2_make(e.y, -e.x) : bmr_vec2_make(-e.y, e.x);
}

/// Is the direction ahead of the tangent's, by no more than the widest angle?
static inline bool within_widest(const turning *t, bmr_vec2 normal) {
    const double cosine = bmr_dot(normal, t->from.direction);
    return bmr_dot(normal, t->along) > 0.0 && cosine > 0.0 &&
           cosine * cosine >= t->cosine * t->cosine * bmr_dot(normal, normal);
}

/// What turning costs, squared: `loss` / `limit` is 1 where it is just what is allowed. Kept apart, for
/// divisions are slow.
typedef struct cost {
    double loss, limit;
} cost;

/// The cost of turning the tangent until it lies on the edge after `steps` vertices: the height of the two
/// tangents' meeting point above the chord between their vertices. Infinite where that is too far to turn.
static cost cost_of(const turning *t, uint32_t steps) {
    ++*t->steps;
    bmr_vec2 vertex;
    const bmr_vec2 normal = normal_after(t, steps, &vertex);
    cost c = {1.0, 0.0};
    if (!within_widest(t, normal))
        return c;
    const bmr_vec2 chord = bmr_sub(vertex, t->start);
    const double height = bmr_dot(normal, chord) * bmr_dot(chord, t->from.direction);
    const double along = t->limit * bmr_dot(normal, t->along);
    c.loss = height * height;
    c.limit = along * along * bmr_dot(chord, chord);
    return c;
}

/// By how many times to change a guess of this cost: twice as far is four times the loss, and both are
/// squared here.
static uint32_t factor_of(double small, double large) {
    uint32_t factor = 1;
    for (small *= 16.0; small <= large && factor < LARGEST_FACTOR; small *= 16.0)
        factor *= 2;
    return factor;
}

/// How many edges the tangent can be turned past within the limit.
static uint32_t edges_passed(const turning *t) {
    const cost first = cost_of(t, 0);
    if (first.loss > first.limit)
        return 0;
    const uint32_t n = t->polygon->count;
    uint32_t low = 0, high = n - 1; // the loss is fine at `low`, and too much at `high`
    uint32_t guess = 1 + n / FIRST_GUESS_PART;
    bool enough = false; // at `low`
    for (int i = 0; high - low > 1 && (i < GUESSES || !enough); ++i) {
        const cost c = cost_of(t, guess);
        uint32_t factor;
        if (c.loss <= c.limit) {
            low = guess;
            enough = c.loss >= ENOUGH_PART * ENOUGH_PART * c.limit;
            factor = factor_of(c.loss, c.limit);
            guess *= factor;
        } else {
            high = guess;
            factor = factor_of(c.limit, c.loss);
            guess /= factor;
        }
        if (i + 1 >= GUESSES || guess <= low || guess >= high)
            guess = low + (high - low) / 2;
    }
    return low + 1;
}

/// The direction (unit length) that goes the way of `wanted`, but not beyond the widest angle.
static bmr_vec2 not_too_wide(const turning *t, bmr_vec2 wanted) {
    if (within_widest(t, wanted))
        return bmr_scale(1.0 / sqrt(bmr_dot(wanted, wanted)), wanted);
    const double sine = sqrt(1.0 - t->cosine * t->cosine);
    return bmr_add(bmr_scale(t->cosine, t->from.direction), bmr_scale(sine, t->along));
}

/// How far to turn about the vertex `passed` edges after the start: to where the loss is the limit, but not
/// back behind the edge that arrives there and not past the edge that leaves.
static bmr_vec2 turn_about(const turning *t, uint32_t passed, bmr_vec2 chord) {
    bmr_vec2 unused;
    const bmr_vec2 first = normal_after(t, passed - 1, &unused), last = normal_after(t, passed, &unused);
    // A triangle on the chord: its angle at the start is known, its height is the limit; solved for the angle
    // outside the meeting point, by which the tangent turns.
    const double x = bmr_dot(chord, t->along), drop = -bmr_dot(chord, t->from.direction);
    const bmr_vec2 way = bmr_scale_up_if_tiny(chord); // it is the quotient of two of its lengths that counts
    const double back = t->limit * sqrt(bmr_dot(way, way)) / -bmr_dot(way, t->from.direction);
    bmr_vec2 wanted = bmr_add(bmr_scale(x - back, t->from.direction), bmr_scale(drop, t->along));
    if (!(bmr_cross(first, wanted) * t->sense > 0.0))
        wanted = first;
    // The edge that leaves may be more than half a turn on.
    if (bmr_dot(last, t->along) > 0.0 && !(bmr_cross(wanted, last) * t->sense > 0.0))
        wanted = last;
    return not_too_wide(t, wanted);
}

/// Does the chord from the tangent's vertex to the one `steps` (< count) on lie along the tangent? Chords
/// turn one way, by less than half a turn: those that do are the first ones. The last edge must lead that
/// way, too: next to a long chord the rounding hides edges that already lead back.
static bool is_along(const turning *t, uint32_t steps) {
    const bmr_vec2 *v = t->polygon->vertices;
    const bmr_vec2 end = v[vertex_after(t, steps)];
    const bmr_vec2 chord = bmr_scale_up_if_tiny(bmr_sub(end, v[t->from.vertex]));
    const bmr_vec2 edge = bmr_scale_up_if_tiny(bmr_sub(end, v[vertex_after(t, steps - 1)]));
    const double drop = -bmr_dot(chord, t->from.direction);
    return bmr_dot(chord, t->along) > 0.0 && bmr_dot(edge, t->along) > 0.0 &&
           !(drop > 0.0 && drop * drop > FLAT * FLAT * bmr_dot(chord, chord));
}

/// How many edges from the tangent's vertex on lie along it: by doubling, then by halves.
static uint32_t edges_along(const turning *t) {
    const uint32_t n = t->polygon->count;
    uint32_t low = 0, high = n, guess = 1; // the chord is along the tangent at `low`, and not at `high`
    while (high - low > 1) {
        const bool along = is_along(t, guess);
        *t->steps += along || low > 1;
        if (along)
            low = guess;
        else
            high = guess;
        guess = high == n && low < n / 2 ? 2 * low : low + (high - low) / 2;
    }
    return low;
}

/// Turns a tangent as far as the limit and the widest angle allow. *corner: where the two tangents meet.
static tangent turn(const bmr_polygon *polygon, tangent from, int sense, double limit, double cosine,
                    bmr_vec2 *corner, unsigned *steps) {
    turning t = {polygon, sense, from, bmr_left(from.direction), from.direction, limit, cosine, steps};
    if (sense < 0)
        t.along = bmr_neg(t.along);
    t.from.vertex = vertex_after(&t, edges_along(&t));
    t.start = polygon->vertices[t.from.vertex];
    const uint32_t passed = edges_passed(&t);
    const uint32_t pivot = vertex_after(&t, passed);
    *corner = t.start;
    if (passed == 0) {
        bmr_vec2 unused;
        const bmr_vec2 last = normal_after(&t, 0, &unused);
        const tangent about_start = {not_too_wide(&t, last), pivot};
        return about_start;
    }
    const bmr_vec2 chord = bmr_sub(polygon->vertices[pivot], t.start);
    const tangent to = {turn_about(&t, passed, chord), pivot};
    // Between the start and the pivot; clamped, for two tangents that are nearly one meet anywhere.
    const double most = bmr_dot(chord, t.along);
    const double s = bmr_dot(to.direction, chord) / bmr_dot(to.direction, t.along);
    *corner = bmr_add(t.start, bmr_scale(s > 0.0 ? (s < most ? s : most) : 0.0, t.along));
    return to;
}

/// A point or a segment is its own window, in every direction.
static void make_everywhere(const bmr_polygon *polygon, bmr_window *window) {
    window->corner[0] = polygon->vertices[0];
    window->corner[1] = polygon->vertices[polygon->count - 1];
    window->low = window->high = bmr_vec2_make(0.0, 0.0);
    window->life = -2.0;
}

void bmr_window_make(const bmr_polygon *polygon, bmr_vec2 direction, uint32_t support, double limit, int lean,
                     bmr_window *window) {
    window->steps = 1;
    if (polygon->count <= 2) {
        make_everywhere(polygon, window);
        return;
    }
    const tangent middle = {direction, support};
    if (lean == 0) {
        window->low =
            turn(polygon, middle, -1, limit, WIDEST_COSINE, &window->corner[0], &window->steps).direction;
        window->high =
            turn(polygon, middle, 1, limit, WIDEST_COSINE, &window->corner[1], &window->steps).direction;
        const double back = bmr_dot(direction, window->low), on = bmr_dot(direction, window->high);
        window->life = back > on ? back : on;
        return;
    }
    bmr_vec2 unused;
    const tangent back =
        turn(polygon, middle, -lean, BACKWARD_PART * limit, BACKWARD_COSINE, &unused, &window->steps);
    const tangent next = turn(polygon, back, lean, limit, WIDEST_COSINE, &window->corner[0], &window->steps);
    const tangent far = turn(polygon, next, lean, limit, WIDEST_COSINE, &window->corner[1], &window->steps);
    window->low = lean > 0 ? back.direction : far.direction;
    window->high = lean > 0 ? far.direction : back.direction;
    window->life = bmr_dot(direction, far.direction);
}
