// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TEST_POINT_PASS_H
#define BOOMERANG_TEST_POINT_PASS_H

#include "checks.h"
#include "kds_driver.h"
#include "motions.h"

/// @file
/// A point that passes a polygon, and the structure that follows it: for the tests of what the paper claims
/// of one point (sections 5 and 6).

/// How many seeds: scaled, but never so few that what is rare does not happen at all.
static inline uint64_t seeds(size_t count) {
    const size_t scaled = test_scaled(count);
    return scaled > count / 2 ? scaled : count / 2;
}

static inline bmr_kds *made(const char *name, const bmr_kds_def *def, const test_kds_body *a,
                            const test_kds_body *b) {
    return made_kds(test_structure(name), def, &a->shape, &b->shape);
}

/// A pair's own memory where the polygon's chains are shared.
#define MOST_PAIR_BYTES 512

/// Drives a structure past a polygon of the family along a path of the kind that comes as near as gap *
/// diameter; the polygon and the path depend on the seed alone.
typedef struct pass {
    test_family family;
    size_t n;
    test_path_kind kind;
    double gap;
    uint64_t seed;
    bmr_kds_def def;
    void (*on_event)(void *context, const test_drive_event *event);
    void *context;
    bool shares_chains; ///< those of the polygon
} pass;

static inline test_drive_result drive(const char *name, const pass *p) {
    test_random random = {p->seed};
    test_kds_body a = test_kds_body_make(test_polygon(p->family, p->n, &random));
    test_kds_body b = test_kds_point_make(0.0, 0.0);
    const test_path path =
        test_path_make(p->kind, a.polygon, b.polygon, 2.0 * p->gap * a.polygon->radius, false, &random);
    const test_drive how = {.path = &path,
                            .resolution = 1e-6,
                            .audit_every = 64,
                            .margin = p->def.margin,
                            .on_event = p->on_event,
                            .context = p->context};
    const int kind = test_structure(name)->hierarchy;
    bmr_chains *chains = NULL;
    if (p->shares_chains) {
        assert_int_equal(bmr_chains_create(a.hierarchies[kind], NULL, &chains), BMR_OK);
        a.shape.chains[kind] = chains;
    }
    bmr_kds *kds = made(name, &p->def, &a, &b);
    if (p->shares_chains)
        assert_true(bmr_kds_bytes(kds) <= MOST_PAIR_BYTES && bmr_chains_bytes(chains) > MOST_PAIR_BYTES);
    const test_drive_result r = test_drive_run(kds, a.polygon, b.polygon, &how);
    assert_true(test_drive_is_sound(&r));
    bmr_kds_destroy(kds, NULL);
    bmr_chains_destroy(chains, NULL);
    test_kds_body_destroy(&a);
    test_kds_body_destroy(&b);
    return r;
}

static inline pass pass_make(test_family family, size_t n, test_path_kind kind, double gap, uint64_t seed) {
    const pass p = {family, n, kind, gap, seed, bmr_default_kds_def(), NULL, NULL, false};
    return p;
}

#endif
