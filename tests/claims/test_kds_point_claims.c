// SPDX-License-Identifier: MIT
// What the paper claims of its structures for a point in section 5, each claim with a control that shows that
// the check can fail. Section 6 is in test_kds_point_hysteresis.c.
#include "checks.h"
#include "kds/point.h"
#include "point_pass.h"

#define LEVELS 40

/// Which triangles were active on each level.
typedef struct visits {
    bmr_edge seen[LEVELS];
    size_t count[LEVELS]; ///< of different ones
} visits;

static void visit(void *context, const test_drive_event *event) {
    visits *v = context;
    const bmr_edge edge = bmr_point_look(event->kds)->edge;
    if (!event->report.apart || edge == BMR_NO_EDGE)
        return;
    const int level = bmr_point_level(event->kds);
    if (v->count[level] == 0 || v->seen[level] != edge)
        ++v->count[level];
    v->seen[level] = edge;
}

static size_t most_on_a_level(test_path_kind kind, const char *name, uint64_t seed, size_t *triangles) {
    visits v;
    memset(&v, 0, sizeof v);
    pass p = pass_make((test_family)(seed % TEST_FAMILY_COUNT), 64, kind, 1e-3, seed);
    p.on_event = visit;
    p.context = &v;
    drive(name, &p);
    size_t most = 0;
    for (int level = 1; level < LEVELS; ++level) { // level 0: the pinwheel cells are outside of P_0
        most = v.count[level] > most ? v.count[level] : most;
        *triangles += v.count[level];
    }
    return most;
}

/// Lemma 3.2: a convex curve beside P meets at most one triangle of a level.
TEST(a_convex_path_meets_at_most_one_triangle_of_a_level) {
    const char *const names[] = {"triangle-levels-compass", "triangle-levels-dudley"};
    for (int i = 0; i < 2; ++i) {
        size_t triangles = 0, orbits_failed = 0;
        for (uint64_t seed = 1; seed <= seeds(40); ++seed) {
            assert_true(most_on_a_level(TEST_PATH_LINE, names[i], seed, &triangles) <= 1);
            assert_true(most_on_a_level(TEST_PATH_PARABOLA, names[i], seed, &triangles) <= 1);
            orbits_failed += most_on_a_level(TEST_PATH_ORBIT, names[i], seed, &triangles) > 1;
        }
        assert_true(triangles > 2 * seeds(40));
        assert_true(orbits_failed >
                    seeds(40) / 4); // the control: a circle around the polygon is no such path
    }
}

/// A cell is left when the point is on one of its sides, and nowhere else.
static void is_on_a_line(const test_drive_event *event) {
    const bmr_hierarchy *h = bmr_point_look(event->kds)->hierarchy;
    const bmr_vec2 x = bmr_point_at(event->kds, &event->now.pose);
    double nearest = INFINITY;
    for (bmr_edge id = 0; id < bmr_hierarchy_edge_count(h); ++id)
        nearest = fmin(nearest, fabs(bmr_edge_slack(h, id, x) - event->kds->def.margin));
    assert_true(nearest <= 8.0 * bmr_point_tolerance(event->kds));
}

/// The cost of a stab: a step for each level passed, or (galloping) two for each doubling of them, which is
/// no more than the paper's O(log log n) nor its O(log D/s); and a look at the certificate, at the old cell
/// and at the new one.
static void took_few_steps(const test_drive_event *event) {
    const bool binary = strstr(event->kds->info->name, "-binary-") != NULL;
    const int levels = event->report.level_after - event->report.level_before;
    const unsigned doublings = (unsigned)floor(log2((double)levels));
    assert_true(event->report.touched <= 3u + (binary ? 1u + 2u * doublings : (unsigned)levels));
}

/// Brute force: every node whose triangle holds the point, tolerances left out.
static void compare_with_all_triangles(void *context, const test_drive_event *event) {
    size_t *compared = context;
    const bmr_point_state *state = bmr_point_look(event->kds);
    if (event->report.kind == BMR_KDS_CROSS && state->edge != BMR_NO_EDGE && event->failed.label > 0)
        is_on_a_line(event);
    if (event->report.kind == BMR_KDS_STAB && state->edge != BMR_NO_EDGE)
        took_few_steps(event);
    if (!event->report.apart || state->edge == BMR_NO_EDGE || bmr_point_level(event->kds) == 0)
        return;
    const bmr_hierarchy *h = state->hierarchy;
    const bmr_vec2 x = bmr_point_at(event->kds, &event->now.pose);
    const double margin = bmr_default_kds_def().margin, slop = 8.0 * bmr_point_tolerance(event->kds);
    size_t surely = 0;
    bool mine = false;
    for (bmr_edge id = 4; id < bmr_hierarchy_edge_count(h); ++id) {
        const bmr_boomerang b = bmr_hierarchy_boomerang(h, id);
        const double inner = bmr_edge_slack(h, id, x) - margin;
        const double outer =
            fmax(bmr_edge_slack(h, b.outer_before, x), bmr_edge_slack(h, b.outer_after, x)) - margin;
        surely += inner > slop && outer < -slop;
        mine = mine || (id == state->edge && inner > -slop && outer < slop);
        // No other triangle holds it.
        assert_false(id != state->edge && inner > slop && outer < -slop);
    }
    assert_true(mine && surely <= 1);
    ++*compared;
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
TEST(the_active_triangle_is_the_one_of_brute_force) {
    const char *const names[] = {"triangle-levels-compass", "triangle-levels-dudley",
                                 "triangle-binary-dudley"};
    for (int i = 0; i < 3; ++i) {
        size_t compared = 0;
        for (uint64_t seed = 1; seed <= seeds(40); ++seed) {
            pass p = pass_make((test_family)(seed % TEST_FAMILY_COUNT), 48,
                               seed % 2 ? TEST_PATH_WANDER : TEST_PATH_CUBIC, 0.01, seed);
            p.on_event = compare_with_all_triangles;
            p.context = &compared;
            drive(names[i], &p);
        }
        assert_true(compared > 2 * seeds(40));
    }
}

/// Records what a structure did.
typedef struct record {
    bmr_edge edges[4096];
    size_t count;
    unsigned most_steps; ///< of a stab
} record;

static void write_down(void *context, const test_drive_event *event) {
    record *r = context;
    if (r->count < sizeof r->edges / sizeof *r->edges)
        r->edges[r->count++] = bmr_point_look(event->kds)->edge;
    if (event->report.kind == BMR_KDS_STAB && event->report.touched > r->most_steps)
        r->most_steps = event->report.touched;
}

/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
TEST(both_searches_find_the_same_triangles) {
    static record levels, binary;
    bool dudley_differs = false;
    levels.most_steps = binary.most_steps = 0;
    for (uint64_t seed = 1; seed <= seeds(20); ++seed) {
        pass p = pass_make(TEST_ELLIPSE, 200, TEST_PATH_WANDER, 1e-3, seed);
        p.on_event = write_down;
        levels.count = binary.count = 0;
        p.context = &levels;
        drive("triangle-levels-dudley", &p);
        p.context = &binary;
        drive("triangle-binary-dudley", &p);
        assert_int_equal(levels.count, binary.count);
        assert_memory_equal(levels.edges, binary.edges, levels.count * sizeof *levels.edges);
        binary.count = 0;
        p.shares_chains = true;
        drive("triangle-binary-dudley", &p);
        p.shares_chains = false;
        assert_int_equal(levels.count, binary.count);
        assert_memory_equal(levels.edges, binary.edges, levels.count * sizeof *levels.edges);
        // The control: another hierarchy's triangles are others.
        p.context = &binary;
        binary.count = 0;
        drive("triangle-levels-compass", &p);
        dudley_differs = dudley_differs || levels.count != binary.count;
    }
    assert_true(dudley_differs);
    printf("a stab: at most %u steps level by level, %u galloping\n", levels.most_steps, binary.most_steps);
    // Doubling, then halving: twice the logarithm of what the other search takes.
    assert_true(binary.most_steps <= 2.0 * log2(levels.most_steps) + 5.0);
}

/// Chains are of one hierarchy.
TEST(chains_of_another_hierarchy_are_refused) {
    test_random random = {7};
    own_kds_body a = test_kds_body_make(test_polygon(TEST_ELLIPSE, 60, &random));
    own_kds_body c = test_kds_body_make(test_polygon(TEST_ELLIPSE, 60, &random));
    own_kds_body b = test_kds_point_make(0.0, 0.0);
    bmr_chains *chains = NULL;
    own_kds *kds = NULL;
    const bmr_kds_def def = bmr_default_kds_def();
    const bmr_kds_info *info = test_structure("triangle-binary-dudley");
    assert_int_equal(bmr_chains_create(NULL, NULL, &chains), BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_chains_create(c.hierarchies[BMR_HIERARCHY_DUDLEY], NULL, NULL),
                     BMR_ERROR_NULL_ARGUMENT);
    assert_int_equal(bmr_chains_create(c.hierarchies[BMR_HIERARCHY_DUDLEY], NULL, &chains), BMR_OK);
    a.shape.chains[BMR_HIERARCHY_DUDLEY] = chains;
    assert_int_equal(bmr_kds_create(info, &def, &a.shape, &b.shape, NULL, &kds), BMR_ERROR_WRONG_HIERARCHY);
    c.shape.chains[BMR_HIERARCHY_DUDLEY] = chains; // control
    assert_int_equal(bmr_kds_create(info, &def, &c.shape, &b.shape, NULL, &kds), BMR_OK);
    bmr_chains_destroy(chains, NULL);
}

/// Mean number of events at a separation of 10^-decade diameters.
static double mean_events(const char *name, test_path_kind kind, int decade) {
    const int count = 4;
    double events = 0.0;
    for (int seed = 1; seed <= count; ++seed) {
        pass p = pass_make(TEST_REGULAR, 1024, kind, pow(10.0, -decade), (uint64_t)seed);
        p.def.margin = 1e-7;
        const test_drive_result r = drive(name, &p);
        events += (double)test_drive_events(&r) / count;
    }
    return events;
}

/// Lemma 3.3(c): a convex curve at distance s meets O(log(D/s)) compass triangles.
/// Lemma 3.4(c): a convex curve at distance s meets O(log(D/s)) Dudley triangles.
/// Theorem 5.1: a point: O(min{log log n, log(D/s)}) an event, O(log mu) or O(mu) events.
/// Theorem ptpoly. Measured: 1 to 2 events for each decade of D / sigma on convex paths, and an exponent of
/// 0.5 on orbits.
TEST(events_grow_logarithmically_on_convex_paths_and_with_the_square_root_on_orbits) {
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        if (info->domain != BMR_KDS_POINT || info->role == BMR_KDS_RIVAL)
            continue;
        const double line =
            mean_events(info->name, TEST_PATH_LINE, 4) - mean_events(info->name, TEST_PATH_LINE, 1);
        const double parabola =
            mean_events(info->name, TEST_PATH_PARABOLA, 4) - mean_events(info->name, TEST_PATH_PARABOLA, 1);
        assert_true(line / 3.0 <= 3.0 && parabola / 3.0 <= 3.0); // a decade
        assert_true(line > 0.0);
        const double near = mean_events(info->name, TEST_PATH_ORBIT, 4);
        const double exponent = log10(near / mean_events(info->name, TEST_PATH_ORBIT, 2)) / 2.0;
        assert_true(exponent >= 0.4 && exponent <= 0.65);
        assert_true(near <= 5.0 * 100.0);        // 5 sqrt(D / sigma)
        assert_true(near > 10.0 * (line + 3.0)); // the control: an orbit is no convex path
    }
}
