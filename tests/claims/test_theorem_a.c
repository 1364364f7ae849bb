// SPDX-License-Identifier: MIT
// Theorem A's adversary (docs/open-question.md, section 2): a chain that comes geometrically nearer to a
// straight path. Each structure that keeps one line, and has hysteresis beta, has at least k/2 - 1 events on
// it.
#include <math.h>

#include "checks.h"

#define LONGEST 60

/// The chain p_i = (i, -rho^-i), i = 0 to k, below the path (t, 0).
typedef struct chain {
    int k;
    long double depth[LONGEST + 1];
} chain;

static chain chain_of(int k, long double beta) {
    chain c = {.k = k};
    for (int i = 0; i <= k; ++i)
        c.depth[i] = powl(5.0L * beta, -i);
    return c;
}

/// The height of (t, 0) above the chain.
static long double height(const chain *c, long double t) {
    const int j = t < c->k ? (int)t : c->k - 1;
    return c->depth[j] + (t - j) * (c->depth[j + 1] - c->depth[j]);
}

/// Events of the structure that does best if it must keep `part` of the height at each event: it takes the
/// line y = -l(t) through (t0, -part v(t0)) that rises least, so that it reaches the path last. (The nearer
/// to the path it begins, the later it may reach it.) All chain points stay below the line, those before t0
/// too.
static int events(const chain *c, long double part) {
    int count = 0;
    for (long double t = 0.0L;;) {
        const long double l = part * height(c, t);
        long double slope = 0.0L;
        for (int i = (int)floorl(t) + 1; i <= c->k; ++i)
            slope = fmaxl(slope, (l - c->depth[i]) / (i - t));
        if (!(slope > 0.0L) || t + l / slope >= c->k)
            return count;
        for (int i = 0; i < t; ++i)
            assert_true(l + slope * (t - i) <= c->depth[i]);
        t += l / slope;
        ++count;
    }
}

/// Theorem A: one line that has hysteresis costs k/2 - 1 events.
TEST(each_line_with_hysteresis_fails_at_every_other_edge) {
    int fewest = LONGEST;
    for (long double beta = 1.0L; beta <= 1e6L; beta *= 10.0L)
        for (int k = 2; k <= LONGEST; ++k) {
            const chain c = chain_of(k, beta);
            // The distance is more than the height over sqrt 2, and the slack at least that over beta.
            const int count = events(&c, 1.0L / (sqrtl(2.0L) * beta));
            assert_true(2 * count >= k - 2);
            if (k == LONGEST)
                fewest = count < fewest ? count : fewest;
            // The control: lines that keep next to nothing need no event.
            assert_int_equal(events(&c, c.depth[k]), 0);
        }
    printf("%d vertices: at least %d events, %d are proved\n", LONGEST + 3, fewest, LONGEST / 2 - 1);
    assert_true(fewest >= 47 - 4); // 47 was seen
}
