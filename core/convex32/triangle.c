// SPDX-License-Identifier: MIT
#include "convex32/triangle.h"

#include <math.h>

/// Below this part of the products, a cross product of rounded differences is not trusted: above, it is
/// within 4e-9 of its value.
#define FIRM 1e-7

/// Adds a number to an exact sum of `count` others, smallest first, none of which has bits where another has
/// (Shewchuk's expansions). There is room for one more. The new count.
static int add_exactly(double *sum, int count, double term) {
    for (int i = 0; i < count; ++i) {
        const double total = term + sum[i], part = total - term;
        sum[i] = (term - (total - part)) + (sum[i] - part);
        term = total;
    }
    sum[count] = term;
    return count + 1;
}

double convex32_twice_area(bmr_vec32 a, bmr_vec32 b, bmr_vec32 c) {
    const double ax = (double)a.x, ay = (double)a.y, bx = (double)b.x, by = (double)b.y, cx = (double)c.x,
                 cy = (double)c.y;
    const double left = (bx - ax) * (cy - ay), right = (by - ay) * (cx - ax);
    if (fabs(left - right) >= FIRM * (fabs(left) + fabs(right)))
        return left - right;
    // A needle's area is lost in the rounding of the products. Those of the coordinates themselves are exact,
    // and summed so.
    const double terms[6] = {ax * by, -ay * bx, bx * cy, -by * cx, cx * ay, -cy * ax};
    double sum[6];
    int count = 0;
    for (int i = 0; i < 6; ++i)
        count = add_exactly(sum, count, terms[i]);
    double total = 0.0;
    for (int i = 0; i < count; ++i)
        total += sum[i];
    return total;
}
