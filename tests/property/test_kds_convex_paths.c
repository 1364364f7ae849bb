// SPDX-License-Identifier: MIT
// Convex translation where mu is n (docs/open-question.md): chains that come geometrically nearer to a
// straight or bent path. The free direction has an event at each edge; the structures that take a coarse line
// have a logarithm of them, and each keeps the bound that is proved of it.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "convex_paths.h"
#include "kds/cone.h"
#include "kds/structure.h"
#include "structure_named.h"
#include "test_scale.h"

/// Far below all gaps here.
#define MARGIN 1e-9
/// What an audit and the contact of a structure grant to rounding, in units of the extents.
#define CONTACT_PART 4e-10
#define PI 3.14159265358979323846

/// What one run came to.
typedef struct count {
    double events, handovers, ratio; ///< ratio: D/sigma, at least 1
    double sigma, threshold;         ///< D/N^2
    double n, depths;                ///< N; the depths of both trees together
} count;

static count run(const char *name, const test_kds_body *a, const test_kds_body *b, const test_path *path) {
    bmr_kds_def def = bmr_default_kds_def();
    def.margin = MARGIN;
    bmr_kds *kds = NULL;
    assert_int_equal(bmr_kds_create(test_structure(name), &def, &a->shape, &b->shape, NULL, &kds), BMR_OK);
    const test_drive drive = {.path = path, .margin = MARGIN};
    const test_drive_result r = test_drive_run(kds, a->polygon, b->polygon, &drive);
    bmr_kds_destroy(kds, NULL);
    assert_true(test_drive_is_sound(&r));
    assert_int_equal(r.events[BMR_KDS_CONTACT], 0);
    count c = {.events = (double)test_drive_events(&r), .handovers = (double)r.events[BMR_KDS_HANDOVER]};
    const double diameter = test_diameter(a->polygon, b->polygon, MARGIN);
    c.sigma = r.nearest - MARGIN;
    c.ratio = fmax(1.0, diameter / c.sigma);
    c.n = (double)a->polygon->count + b->polygon->count;
    // The structure's diameters are those of bounding disks.
    c.threshold = 2.0 * (a->polygon->radius + b->polygon->radius + MARGIN) / (c.n * c.n);
    c.depths = test_tree_depth(a->polygon) + test_tree_depth(b->polygon);
    return c;
}

/// 5 + log4(6) events beyond the logarithm.
#define BEYOND 6.3

static double free_bound(const count *c) {
    return log2(c->ratio) + BEYOND;
}
static double hybrid_bound(const count *c) {
    const double far = fmin(log2(c->ratio), 2.0 * log2(c->n)) + BEYOND;
    return far + (c->sigma < c->threshold ? c->depths + 8.0 : 0.0);
}
static double repairs_bound(const count *c) {
    return fmin(free_bound(c), c->depths + 6.0);
}
static double coarse_bound(const count *c) {
    return c->depths + 7.0;
}

/// How much of the bounds the worst run used.
typedef struct worst {
    double free, hybrid, repairs, coarse;
} worst;

static void keep_bounds(const test_kds_body *a, const test_kds_body *b, const test_path *path, worst *w) {
    const count fd = run("free-fd2", a, b, path), hybrid = run("hybrid", a, b, path),
                two = run("two-lines", a, b, path), coarse = run("coarse", a, b, path);
    const double repairs = two.events - two.handovers;
    assert_true(fd.events <= free_bound(&fd));
    assert_true(hybrid.events <= hybrid_bound(&hybrid));
    assert_true(repairs <= repairs_bound(&two));
    assert_true(two.events <= 2.0 * repairs_bound(&two) + 2.0);
    assert_true(coarse.events <= coarse_bound(&coarse));
    w->free = fmax(w->free, fd.events / free_bound(&fd));
    w->hybrid = fmax(w->hybrid, hybrid.events / hybrid_bound(&hybrid));
    w->repairs = fmax(w->repairs, repairs / repairs_bound(&two));
    w->coarse = fmax(w->coarse, coarse.events / coarse_bound(&coarse));
}

/// A chain whose least gap is well above rounding.
static test_chain_def any_chain(test_random *random) {
    test_chain_def def = {.ratio = test_random_uniform(random, 2.0, 5.0),
                          .deal = (test_deal)test_random_below(random, TEST_DEAL_COUNT)};
    const double most = -log(1e3 * CONTACT_PART) / log(def.ratio);
    def.edges = 3 + test_random_below(random, (uint32_t)fmin(25.0, most) - 3);
    for (int i = 0; i < 2; ++i)
        def.turn[i] = test_random_uniform(random, 0.0, 2.0 * PI);
    if (test_random_below(random, 2))
        def.bend = pow(10.0, test_random_uniform(random, -8.0, 0.0));
    return def;
}

/// Section 7, open question: hysteresis, path-sensitivity and all bounds, in one structure of linear size.
/// None has more events than is proved of it.
static void no_convex_path_is_above_its_bound(void **state) {
    (void)state;
    test_random random = {34};
    worst w = {0.0, 0.0, 0.0, 0.0};
    for (size_t i = 0; i < test_scaled(1700); ++i) {
        if (i % 2) {
            const test_chain_def def = any_chain(&random);
            test_chain chain = test_chain_make(&def, &random);
            keep_bounds(&chain.body[0], &chain.body[1], &chain.path, &w);
            test_chain_destroy(&chain);
            continue;
        }
        test_kds_body body[2];
        for (int k = 0; k < 2; ++k)
            body[k] = test_kds_body_make(test_polygon((test_family)test_random_below(&random, TEST_LENS + 1),
                                                      3 + test_random_below(&random, 60), &random));
        const double gap = (body[0].polygon->radius + body[1].polygon->radius) *
                           pow(10.0, -test_random_uniform(&random, 0.0, 5.0));
        const test_path path = test_path_make(i % 4 ? TEST_PATH_LINE : TEST_PATH_PARABOLA, body[0].polygon,
                                              body[1].polygon, gap, false, &random);
        keep_bounds(&body[0], &body[1], &path, &w);
        for (int k = 0; k < 2; ++k)
            test_kds_body_destroy(&body[k]);
    }
    print_message("of the bounds: free-fd2 %.2f, hybrid %.2f, two-lines %.2f, coarse %.2f\n", w.free,
                  w.hybrid, w.repairs, w.coarse);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_convex_path_is_above_its_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
