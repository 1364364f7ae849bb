// SPDX-License-Identifier: MIT
// The chain of ratio 5 with thousands of edges, for which double has no room: the rules of
// core/kds/two_lines.c on the numbers themselves, in long double. At t in [0, k] the point (t, 0) is 5^-t or
// so above the chain.
#include "checks.h"

#define RATIO 5.0L
/// Vertices that a polygon has beside its end of the chain: the chain has n - 3 edges.
#define OTHERS 3

typedef enum rule { FREE, COARSE, HYBRID, TWO_LINES } rule;

/// Height of the point at `t` above the line of edge `j`, from (j, -5^-j) to (j + 1, -5^-(j + 1)).
static long double height(int j, long double t) {
    return powl(RATIO, -j) - (powl(RATIO, -j) - powl(RATIO, -j - 1)) * (t - j);
}

/// Where the point crosses the line of edge `j`.
static long double crossing(int j) {
    return j + 1.0L / (1.0L - 1.0L / RATIO);
}

/// The depth of place `i` in the tree over `count` places, the middle one first.
static int depth_of(int i, int count) {
    int low = 0, high = count, depth = 1;
    for (;; ++depth) {
        const int middle = low + (high - low) / 2;
        if (i == middle)
            return depth;
        if (i > middle)
            low = middle + 1;
        else
            high = middle;
    }
}

/// The edge of least rank that separates at `t`: edges are dealt to both bodies in turn, and lie in their
/// arrays from the last to the first.
static int coarse(int k, long double t) {
    int best = -1, least = 0;
    for (int j = 0; j < k; ++j) {
        const int body = j % 2, count = (k + 1 - body) / 2;
        if (!(height(j, t) > 0.0L))
            continue;
        const int rank = 2 * depth_of(count - 1 - j / 2, count) + body;
        if (best < 0 || rank < least) {
            best = j;
            least = rank;
        }
    }
    return best;
}

typedef struct outcome {
    int events, handovers;
} outcome;

static outcome follow(rule r, int n) {
    const int k = n - OTHERS;
    // Both polygons have as many vertices; each is half as long as the chain.
    const long double vertices = (long double)n + OTHERS, diameter = k,
                      threshold = diameter / (vertices * vertices);
    outcome o = {0, 0};
    int spare = -1;
    for (long double t = 0.0L;; ++o.events) {
        const int nearest = (int)floorl(t);
        int line = nearest;
        if (spare >= 0 && height(spare, t) > 0.0L) {
            line = spare;
            spare = -1;
            ++o.handovers;
        } else if (r == COARSE || (r == HYBRID && height(nearest, t) < threshold)) {
            line = coarse(k, t);
        } else if (r == TWO_LINES) {
            spare = coarse(k, t);
        }
        // A crossing is passed by next to nothing.
        t = nextafterl(crossing(line), INFINITY);
        if (!(t <= k))
            return o;
    }
}

TEST(a_chain_costs_one_line_its_length_and_a_coarse_one_its_logarithm) {
    static const struct {
        int n, free, hybrid, repairs;
    } rows[] = {{32, 28, 6, 4}, {128, 124, 8, 6}, {512, 508, 11, 8}, {4096, 4092, 16, 11}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const int n = rows[i].n;
        const outcome fd = follow(FREE, n), hybrid = follow(HYBRID, n), two = follow(TWO_LINES, n),
                      alone = follow(COARSE, n);
        printf("n = %d: free %d, hybrid %d, two-lines %d repairs and %d handovers, coarse %d\n", n, fd.events,
               hybrid.events, two.events - two.handovers, two.handovers, alone.events);
        assert_true(fd.events == rows[i].free);
        assert_true(hybrid.events <= rows[i].hybrid);
        assert_true(two.events - two.handovers <= rows[i].repairs);
        assert_true(two.events <= 2 * rows[i].repairs + 2);
    }
}
