// SPDX-License-Identifier: MIT
#include "failure_oracle.h"

static long double horner(const double *c, size_t degree, long double u) {
    long double value = c[degree];
    for (size_t k = degree; k-- > 0;)
        value = value * u + (long double)c[k];
    return value;
}

/// The sum of the terms' magnitudes, and what u's roundings add to it where times are as large as `far`.
static long double terms(const double *c, size_t degree, long double u, long double far) {
    long double value = fabsl((long double)c[degree]), rate = 0.0L;
    for (size_t k = degree; k-- > 0;) {
        rate = rate * u + value;
        value = value * u + fabsl((long double)c[k]);
    }
    return value + far * rate;
}

typedef struct place {
    long double x, y, c, s;
    long double way;  ///< size of x and y: they themselves, or their terms
    long double turn; ///< what a rounding may be multiplied by in c and s
} place;

typedef enum side { BEFORE, AFTER } side; // of a time at which the motion changes

static place place_at(const oracle_plan *p, long double t, side which, bool by_terms) {
    size_t i = 0;
    while (i + 1 < p->count &&
           (which == BEFORE ? (long double)p->from[i + 1] < t : (long double)p->from[i + 1] <= t))
        i++;
    const bmr_motion_piece *piece = &p->pieces[i];
    const long double u = t - (long double)piece->origin;
    const long double far = fabsl(t) + fabsl((long double)piece->origin);
    place at;
    long double c, s, c0, s0;
    if (piece->kind == BMR_PIECE_SCREW) {
        const bmr_screw_motion *w = &piece->as.screw;
        const long double vx = w->velocity.x, vy = w->velocity.y, spin = w->spin;
        at.x = (long double)w->start.position.x + u * vx;
        at.y = (long double)w->start.position.y + u * vy;
        at.way =
            hypotl((long double)w->start.position.x, (long double)w->start.position.y) + far * hypotl(vx, vy);
        at.turn = 1.0L + fabsl(spin) * far;
        c = cosl(spin * u);
        s = sinl(spin * u);
        c0 = w->start.c;
        s0 = w->start.s;
    } else {
        const bmr_algebraic_piece *w = &piece->as.algebraic;
        at.x = horner(w->x, w->degree, u);
        at.y = horner(w->y, w->degree, u);
        const long double a = horner(w->a, w->rotation_degree, u), b = horner(w->b, w->rotation_degree, u);
        c = (a * a - b * b) / (a * a + b * b);
        s = 2.0L * a * b / (a * a + b * b);
        at.way = hypotl(terms(w->x, w->degree, fabsl(u), far), terms(w->y, w->degree, fabsl(u), far));
        const long double all_a = terms(w->a, w->rotation_degree, fabsl(u), far),
                          all_b = terms(w->b, w->rotation_degree, fabsl(u), far);
        at.turn = (all_a * all_a + all_b * all_b) / (a * a + b * b);
        c0 = w->start_c;
        s0 = w->start_s;
    }
    if (!by_terms) {
        at.way = hypotl(at.x, at.y);
        at.turn = 1.0L;
    }
    const long double unit = hypotl(c0, s0);
    at.c = (c * c0 - s * s0) / unit;
    at.s = (s * c0 + c * s0) / unit;
    return at;
}

static long double value_at(const oracle_trial *r, long double t, side which, long double *size) {
    const bmr_condition *k = &r->condition;
    const place o = place_at(k->owner == 0 ? &r->a : &r->b, t, which, r->by_terms),
                x = place_at(k->owner == 0 ? &r->b : &r->a, t, which, r->by_terms);
    const long double nx = o.c * (long double)k->normal.x - o.s * (long double)k->normal.y,
                      ny = o.s * (long double)k->normal.x + o.c * (long double)k->normal.y;
    const long double px = x.c * (long double)k->point.x - x.s * (long double)k->point.y,
                      py = x.s * (long double)k->point.x + x.c * (long double)k->point.y;
    const long double n = hypotl(nx, ny) * o.turn, p = hypotl(px, py) * x.turn;
    const long double ways = o.way + x.way;
    if (size)
        *size = k->kind == BMR_CONDITION_TURN    ? n * p
                : k->kind == BMR_CONDITION_DISKS ? n + p + ways + fabsl((long double)k->offset)
                                                 : n * (p + ways) + fabsl((long double)k->offset);
    if (k->kind == BMR_CONDITION_TURN)
        return nx * py - ny * px;
    if (k->kind == BMR_CONDITION_DISKS)
        return hypotl(px + x.x - o.x - nx, py + x.y - o.y - ny) - (long double)k->offset;
    return nx * (px + x.x - o.x) + ny * (py + x.y - o.y) - (long double)k->offset;
}

long double oracle_value(const oracle_trial *r, long double t, long double *size) {
    return value_at(r, t, AFTER, size);
}

long double oracle_least(const oracle_trial *r, long double low, long double high) {
    const long double ratio = 0.6180339887498949L;
    long double p = high - ratio * (high - low), q = low + ratio * (high - low);
    long double fp = oracle_value(r, p, NULL), fq = oracle_value(r, q, NULL);
    for (int i = 0; i < 60; i++) {
        if (fp < fq) {
            high = q;
            q = p;
            fq = fp;
            p = high - ratio * (high - low);
            fp = oracle_value(r, p, NULL);
        } else {
            low = p;
            p = q;
            fp = fq;
            q = low + ratio * (high - low);
            fq = oracle_value(r, q, NULL);
        }
    }
    return fminl(fp, fq);
}

/// The next time after `t` at which one of the two changes its plan; INFINITY: none.
static long double next_change(const oracle_trial *r, long double t) {
    long double next = INFINITY;
    for (int body = 0; body < 2; body++) {
        const oracle_plan *p = body == 0 ? &r->a : &r->b;
        for (size_t i = 1; i < p->count; i++)
            if ((long double)p->from[i] > t)
                next = fminl(next, (long double)p->from[i]);
    }
    return next;
}

/// The value in parts of the lengths that go into it.
static long double part_at(const oracle_trial *r, long double t, side which) {
    long double size;
    const long double value = value_at(r, t, which, &size);
    return value / size;
}

/// The least of such parts on both sides of all changes of plan in (low, high): there, values jump or bend,
/// and a touch lasts for no time at all.
static long double least_at_changes(const oracle_trial *r, long double low, long double high) {
    long double worst = INFINITY;
    for (long double t = next_change(r, low); t < high; t = next_change(r, t))
        worst = fminl(worst, fminl(part_at(r, t, BEFORE), part_at(r, t, AFTER)));
    return worst;
}

/// Is the value about zero or below at some time in [low, high]? Least values between looks are sought out.
static bool comes_to_zero(const oracle_trial *r, long double low, long double high, int looks) {
    const long double step = (high - low) / looks;
    if (part_at(r, high, BEFORE) <= ORACLE_SLACK || least_at_changes(r, low, high) <= ORACLE_SLACK)
        return true;
    long double after = INFINITY, here = INFINITY;
    for (int i = 0; i <= looks + 1; i++) { // from the end, where it is below zero mostly
        const long double before = i <= looks ? part_at(r, high - step * i, AFTER) : INFINITY;
        if (before <= ORACLE_SLACK)
            return true;
        if (i > 0 && here <= after && here <= before) {
            const long double t = high - step * (i - 1);
            long double size;
            oracle_value(r, t, &size);
            if (oracle_least(r, fmaxl(low, t - step), fminl(high, t + step)) <= ORACLE_SLACK * size)
                return true;
        }
        after = here;
        here = before;
    }
    return false;
}

oracle_verdict oracle_judge(const oracle_trial *r, double after, double until, double time, double tolerance,
                            int looks) {
    oracle_verdict v = {false, false, 0.0L};
    const long double last = fminl((long double)time, (long double)until);
    const long double step = (last - (long double)after) / looks;
    long double size, before = INFINITY, here = oracle_value(r, after, &size), worst = 0.0L;
    for (int i = 1; i <= looks && step > 0.0L; i++) {
        const long double t = (long double)after + step * i - (i == looks ? 1e-17L : 0.0L);
        const long double next = value_at(r, t, BEFORE, &size);
        if (i < looks)
            worst = fminl(worst, next / size);
        if (here <= before && here <= next && i > 1 && here < 0.05L * size)
            worst = fminl(worst, oracle_least(r, t - 2.0L * step, t) / size);
        before = here;
        here = next;
    }
    // Nearer and nearer to the end, and there.
    for (int i = 0; i < 60 && step > 0.0L; i++) {
        const long double value = value_at(r, last - ldexpl(step, -i), BEFORE, &size);
        worst = fminl(worst, value / size);
    }
    if (!isinf(time) && step > 0.0L)
        worst = fminl(worst, value_at(r, last, BEFORE, &size) / size);
    worst = fminl(worst, least_at_changes(r, after, last));
    v.worst = worst;
    v.late = worst < -ORACLE_SLACK;
    if (!isinf(time))
        v.early = !comes_to_zero(r, time, (long double)time + (long double)tolerance, looks);
    return v;
}
