// SPDX-License-Identifier: MIT
// Never compiled: sites that the script must find here, and traps where it must find none (sample.txt).
#include <assert.h>
#define PLUS(a, b) ((a) + (b))
enum { FIRST = 1, SECOND = FIRST + 1 };
typedef struct pair {
    double x[2], y; // an array's size in a type is none: 2 < 3
} pair;
static const double WIDTH = 0.5;
static int least(const int *values, int count);

static double work(pair *p, double a, double b, int n) {
    assert(n > 0 && "n < 0 is nobody's");
    const double *first = &p->x[0];
    double sum = a - b / *first;
    if (a < -b && !n)
        sum += fmax(a, (double)n);
    else if (n == 3)
        tell(p, n); /* a + b */
    else
        sum = 1e-9;
    for (int i = 0; i < n; ++i)
        sum *= p->x[i];
    printf("%d + %d", n + 1, n - 1);
    return sum;
}
