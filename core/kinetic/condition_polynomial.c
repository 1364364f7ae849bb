// SPDX-License-Identifier: MIT
#include "kinetic/failure.h"

#include <float.h>
#include <math.h>
#include <string.h>

/// An interval ends before the terms of a position, added up, have grown to more than this many times the
/// lengths at its beginning. (When each term of a path of degree 8 was allowed sixteen times, a root of
/// DISKS, where the path is squared, came out 1e-10 late.)
#define GROWTH 4.0

/// Over one interval |a + i b| changes by at most this part of itself, so that the denominators stay within
/// (1/2)^2 and (3/2)^2 of what they are at its beginning.
#define ROTATION_CHANGE 0.5

/// No interval is shorter than this many roundings of the time. Near a common root of a and b no width would
/// be small enough.
#define LEAST_ROUNDINGS 4.0

/// Nor is it shorter than this part of the time since the pieces' origins, however small the lengths at its
/// beginning happen to be: on a shorter interval a slope could not be told from the rounding of the time.
#define LEAST_PART 0x1p-26

#define MAX_DEGREE BMR_POLYNOMIAL_MAX_DEGREE
#define MAX_ROTATION (2 * BMR_MOTION_MAX_DEGREE)

typedef struct polynomial {
    size_t degree;
    double c[MAX_DEGREE + 1];
} polynomial;

/// Points or directions as complex polynomials.
typedef struct path {
    size_t degree;
    double x[MAX_ROTATION + 1], y[MAX_ROTATION + 1];
} path;

/// A rotation: (c, s) = turn / denominator.
typedef struct rotation {
    path turn;
    polynomial denominator;
    double size; ///< bound of |denominator| and |turn| on [0, 1]
} rotation;

// ---- arithmetic ----

/// target += factor * p * q
static void add_product(polynomial *target, double factor, const double *p, size_t p_degree, const double *q,
                        size_t q_degree) {
    const size_t degree = p_degree + q_degree;
    while (target->degree < degree)
        target->c[++target->degree] = 0.0;
    for (size_t i = 0; i <= p_degree; i++) {
        const double f = factor * p[i];
        for (size_t j = 0; j <= q_degree; j++)
            target->c[i + j] += f * q[j];
    }
}

static polynomial zero(void) {
    polynomial p;
    p.degree = 0;
    p.c[0] = 0.0;
    return p;
}

/// target += factor * <p, q>
static void add_dot(polynomial *target, double factor, const path *p, const path *q) {
    add_product(target, factor, p->x, p->degree, q->x, q->degree);
    add_product(target, factor, p->y, p->degree, q->y, q->degree);
}

static polynomial dot(const path *p, const path *q) {
    polynomial product = zero();
    add_dot(&product, 1.0, p, q);
    return product;
}

static polynomial cross(const path *p, const path *q) {
    polynomial product = zero();
    add_product(&product, 1.0, p->x, p->degree, q->y, q->degree);
    add_product(&product, -1.0, p->y, p->degree, q->x, q->degree);
    return product;
}

static polynomial times(const polynomial *p, const polynomial *q) {
    polynomial product = zero();
    add_product(&product, 1.0, p->c, p->degree, q->c, q->degree);
    return product;
}

/// Not less than the length, and not more than sqrt(2) times it.
static double size_of(double x, double y) {
    return fabs(x) + fabs(y);
}

static double most_length(bmr_vec2 v) {
    return size_of(v.x, v.y);
}

static double reach(const double *x, const double *y, size_t degree) {
    double sum = 0.0;
    for (size_t k = 0; k <= degree; k++)
        sum += size_of(x[k], y[k]);
    return sum;
}

// ---- pieces ----

/// Multiplies the coefficients by powers of the width.
static void stretch(bmr_algebraic_piece *p, double width) {
    double power = width;
    for (size_t k = 1; k <= BMR_MOTION_MAX_DEGREE; k++, power *= width) {
        if (k <= p->degree) {
            p->x[k] *= power;
            p->y[k] *= power;
        }
        if (k <= p->rotation_degree) {
            p->a[k] *= power;
            p->b[k] *= power;
        }
    }
}

/// The largest w <= width with |z_k| w^k <= limit for all k >= 1.
static double limit_growth(const double *x, const double *y, size_t degree, double limit, double width) {
    double power = width;
    for (size_t k = 1; k <= degree; k++, power *= width) {
        const double z = size_of(x[k], y[k]);
        if (z * power > limit) {
            power = limit / z;
            width = pow(power, 1.0 / (double)k);
        }
    }
    return width;
}

static double limit_rotation(const bmr_algebraic_piece *p, double width) {
    if (p->rotation_degree == 0)
        return width;
    const double limit = ROTATION_CHANGE * hypot(p->a[0], p->b[0]) / (double)p->rotation_degree;
    return limit_growth(p->a, p->b, p->rotation_degree, limit, width);
}

/// The square of a + i b, turned by the start; the denominator; scaled so that the latter begins with 1.
static rotation make_rotation(const bmr_algebraic_piece *p) {
    rotation r;
    const size_t n = p->rotation_degree;
    polynomial aa = zero(), bb = zero(), ab = zero();
    add_product(&aa, 1.0, p->a, n, p->a, n);
    add_product(&bb, 1.0, p->b, n, p->b, n);
    add_product(&ab, 2.0, p->a, n, p->b, n);
    const double first = aa.c[0] + bb.c[0], scale = first > 0.0 ? 1.0 / first : 1.0;
    r.turn.degree = r.denominator.degree = 2 * n;
    for (size_t k = 0; k <= 2 * n; k++) {
        const double c = scale * (aa.c[k] - bb.c[k]), s = scale * ab.c[k];
        r.turn.x[k] = c * p->start_c - s * p->start_s;
        r.turn.y[k] = s * p->start_c + c * p->start_s;
        r.denominator.c[k] = scale * (aa.c[k] + bb.c[k]);
    }
    const double size = reach(p->a, p->b, n);
    r.size = scale * size * size;
    return r;
}

static path turned(const rotation *r, bmr_vec2 v) {
    path p;
    p.degree = r->turn.degree;
    for (size_t k = 0; k <= p.degree; k++) {
        p.x[k] = r->turn.x[k] * v.x - r->turn.y[k] * v.y;
        p.y[k] = r->turn.y[k] * v.x + r->turn.x[k] * v.y;
    }
    return p;
}

/// From the owner's origin to the other's.
static path relative_position(const bmr_algebraic_piece *owner, const bmr_algebraic_piece *other) {
    path p;
    p.degree = owner->degree > other->degree ? owner->degree : other->degree;
    for (size_t k = 0; k <= p.degree; k++) {
        p.x[k] = (k <= other->degree ? other->x[k] : 0.0) - (k <= owner->degree ? owner->x[k] : 0.0);
        p.y[k] = (k <= other->degree ? other->y[k] : 0.0) - (k <= owner->degree ? owner->y[k] : 0.0);
    }
    return p;
}

/// The length of which the rounding errors of a position are a part. It adds up the lengths of the terms as
/// they were given, of the terms as they are now, and of the way during one rounding of the time. `now` is in
/// units of the interval's width.
static double position_size(const bmr_motion_piece *given, const bmr_algebraic_piece *now, double from,
                            double width) {
    const double by = fabs(from - given->origin), rounding = (by + fabs(from)) / width;
    double size = 0.0;
    for (size_t k = 0; k <= now->degree; k++)
        size += size_of(now->x[k], now->y[k]) * (1.0 + (double)k * rounding);
    if (given->kind != BMR_PIECE_ALGEBRAIC)
        return size + most_length(given->as.screw.start.position) +
               by * most_length(given->as.screw.velocity);
    double power = 1.0;
    for (size_t k = 0; k <= now->degree; k++, power *= by)
        size += size_of(given->as.algebraic.x[k], given->as.algebraic.y[k]) * power;
    return size;
}

/// By how many roundings of a unit vector the rotation is off: one, and what it turns during a rounding of
/// the time.
static double rotation_error(const bmr_motion_piece *given, const bmr_algebraic_piece *now, double from,
                             double width) {
    const double by = fabs(from - given->origin), rounding = (by + fabs(from)) / width;
    double change = 0.0;
    for (size_t k = 1; k <= now->rotation_degree; k++)
        change += (double)k * size_of(now->a[k], now->b[k]);
    const double center = hypot(now->a[0], now->b[0]);
    return 1.0 + (center > 0.0 ? 4.0 * rounding * change / center : 0.0);
}

// ---- conditions ----

typedef struct scene {
    const bmr_condition *condition;
    path way; ///< from the owner's origin to the other's
    rotation own, other;
    double way_size; ///< position_size of both
    double own_error, other_error;
} scene;

/// Value and the magnitude that its rounding scales with.
static polynomial expand_beyond(const scene *s, double *size) {
    const bmr_condition *k = s->condition;
    const path normal = turned(&s->own, k->normal), point = turned(&s->other, k->point);
    polynomial f = dot(&normal, &point);
    const polynomial along = dot(&normal, &s->way);
    add_product(&f, 1.0, along.c, along.degree, s->other.denominator.c, s->other.denominator.degree);
    const polynomial both = times(&s->own.denominator, &s->other.denominator);
    add_product(&f, -k->offset, both.c, both.degree, s->own.denominator.c, 0);
    *size = most_length(k->normal) *
                (s->way_size * s->own_error + most_length(k->point) * (s->own_error + s->other_error)) +
            fabs(k->offset);
    return f;
}

static polynomial expand_turn(const scene *s, double *size) {
    const bmr_condition *k = s->condition;
    const path normal = turned(&s->own, k->normal), direction = turned(&s->other, k->point);
    *size = most_length(k->normal) * most_length(k->point) * (s->own_error + s->other_error);
    return cross(&normal, &direction);
}

/// Adds a fixed vector to the way: a center of a body that does not turn.
static void add_fixed(path *way, double factor, const path *center) {
    way->x[0] += factor * center->x[0];
    way->y[0] += factor * center->y[0];
}

/// |way + other's center - own center|^2 - reach^2. A center that turns has the denominator squared in its
/// square, and once in the products; its own square is constant.
static polynomial expand_disks(const scene *s, double *size) {
    const bmr_condition *k = s->condition;
    path own = turned(&s->own, k->normal), other = turned(&s->other, k->point), way = s->way;
    const bool own_turns = s->own.turn.degree > 0, other_turns = s->other.turn.degree > 0;
    if (!own_turns)
        add_fixed(&way, -1.0, &own);
    if (!other_turns)
        add_fixed(&way, 1.0, &other);
    const polynomial both = times(&s->own.denominator, &s->other.denominator);
    polynomial square = dot(&way, &way);
    square.c[0] -= k->offset * k->offset;
    if (own_turns)
        square.c[0] += bmr_dot(k->normal, k->normal);
    if (other_turns)
        square.c[0] += bmr_dot(k->point, k->point);
    polynomial f = times(&square, &both);
    if (own_turns) {
        const polynomial product = dot(&way, &own);
        add_product(&f, -2.0, product.c, product.degree, s->other.denominator.c, s->other.denominator.degree);
    }
    if (other_turns) {
        const polynomial product = dot(&way, &other);
        add_product(&f, 2.0, product.c, product.degree, s->own.denominator.c, s->own.denominator.degree);
    }
    if (own_turns && other_turns)
        add_dot(&f, -2.0, &own, &other);
    const double sum = s->way_size + most_length(k->normal) * s->own_error +
                       most_length(k->point) * s->other_error + k->offset;
    *size = sum * sum;
    return f;
}

/// The length of an interval on which the pieces are tame. `clock`: the times that rounding scales with.
static double choose_width(const bmr_condition *k, const bmr_algebraic_piece *owner,
                           const bmr_algebraic_piece *other, const path *way, double clock, double longest) {
    double width = longest;
    if (k->kind != BMR_CONDITION_TURN) {
        const double normal = k->kind == BMR_CONDITION_BEYOND ? most_length(k->normal) : 1.0;
        const double lengths = size_of(way->x[0], way->y[0]) + most_length(k->point) +
                               (normal > 0.0 ? fabs(k->offset) / normal : 0.0);
        if (lengths > 0.0)
            width = limit_growth(way->x, way->y, way->degree,
                                 GROWTH * lengths / fmax(1.0, (double)way->degree), width);
    }
    width = fmax(width, LEAST_PART * clock);
    width = limit_rotation(owner, limit_rotation(other, width));
    return fmin(longest, fmax(width, LEAST_ROUNDINGS * DBL_EPSILON * clock));
}

void bmr_condition_expand(const bmr_condition *condition, const bmr_motion_piece *owner,
                          const bmr_motion_piece *other, double from, double longest,
                          bmr_condition_polynomial *result) {
    bmr_algebraic_piece own_piece = bmr_piece_expand(owner, from),
                        other_piece = bmr_piece_expand(other, from);
    scene s;
    s.condition = condition;
    s.way = relative_position(&own_piece, &other_piece);
    const double clock = fabs(from) + fabs(from - owner->origin) + fabs(from - other->origin);
    const double width = choose_width(condition, &own_piece, &other_piece, &s.way, clock, longest);
    stretch(&own_piece, width);
    stretch(&other_piece, width);
    s.way = relative_position(&own_piece, &other_piece);
    s.own = make_rotation(&own_piece);
    s.other = make_rotation(&other_piece);
    s.way_size =
        position_size(owner, &own_piece, from, width) + position_size(other, &other_piece, from, width);
    s.own_error = rotation_error(owner, &own_piece, from, width);
    s.other_error = rotation_error(other, &other_piece, from, width);

    double size;
    const polynomial f = condition->kind == BMR_CONDITION_BEYOND ? expand_beyond(&s, &size)
                         : condition->kind == BMR_CONDITION_TURN ? expand_turn(&s, &size)
                                                                 : expand_disks(&s, &size);
    memcpy(result->c, f.c, (f.degree + 1) * sizeof *f.c);
    result->degree = f.degree;
    result->width = width;
    // Each product and sum is wrong by one rounding of terms no larger than `size` times the rotations'.
    result->noise = ((double)f.degree + 8.0) * (DBL_EPSILON / 2.0) * size * fmax(1.0, s.own.size) *
                    fmax(1.0, s.other.size);
}
