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
    v.worst = worst;
    v.late = worst < -ORACLE_SLACK;
    if (!isinf(time)) {
        v.early = true;
        for (int i = 0; i <= looks && v.early; i++) {
            const long double part = (long double)tolerance * (looks - i) / looks;
            v.early = oracle_value(r, (long double)time + part, &size) > ORACLE_SLACK * size;
        }
    }
    return v;
}
