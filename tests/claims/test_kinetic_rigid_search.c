// SPDX-License-Identifier: MIT
// The search for a rigid motion of bounded degree that costs more than the square root of D/sigma events
// (docs/open-question.md): motions built by hand, whose growth is fitted. The control is a motion of
// unbounded degree, whose events grow faster and are told apart. BMR_TEST_SCALE=16: D/sigma up to 80,000.
#include "adversaries.h"
#include "checks.h"
#include "kds/registry.h"
#include "kds_driver.h"
#include "motions.h"

#define PI 3.14159265358979323846
#define MOST_VERTICES 2048
/// Of FOCUS: sqrt(3) / 2.
#define ECCENTRICITY 0.86602540378443865
#define MOST_RATIOS 8
#define FIRST_RATIO 16.0
#define LAST_RATIO 5000.0

#define STRUCTURES 3
static const bmr_kds_info *const structures[STRUCTURES] = {&bmr_kds_lazy_compass, &bmr_kds_lazy_dudley,
                                                           &bmr_kds_free_fd2};

// ---- Bodies ----

typedef enum shape_kind {
    REGULAR,
    LENS,
    ELLIPSE,
    RANDOM,
    FOCUS, ///< a 2 : 1 ellipse of half axis 1 with a focus at the frame's origin, its near end on the x axis
    KNEE,  ///< two long sides that meet in a rounded corner, whose centre is the frame's origin
    SHAPES
} shape_kind;

typedef struct body_def {
    shape_kind kind;
    size_t vertices;
    double phase;    ///< turns the polygon
    double x, y;     ///< moves it away from the frame's origin, which is what a rotation turns about
    double rounding; ///< of a knee
} body_def;

static test_kds_body make_body(const body_def *def) {
    static const bmr_ngon plain[] = {BMR_NGON_REGULAR, BMR_NGON_LENS, BMR_NGON_ELLIPSE, BMR_NGON_RANDOM};
    bmr_vec2 points[MOST_VERTICES + 2];
    size_t count = def->vertices;
    assert_true(count >= 3 && count <= MOST_VERTICES);
    if (def->kind == KNEE) {
        // The arc turns by 120 degrees; the third corner is opposite of it.
        for (size_t i = 0; i < count; ++i) {
            const double angle = (2.0 * (double)i / (double)(count - 1) - 1.0) * PI / 3.0;
            points[i] = bmr_vec2_make(def->rounding * cos(angle), def->rounding * sin(angle));
        }
        points[count++] = bmr_vec2_make(-2.0, 0.0);
    } else if (def->kind == FOCUS) {
        for (size_t i = 0; i < count; ++i) {
            const double angle = 2.0 * PI * ((double)i + 0.3) / (double)count;
            points[i] = bmr_vec2_make(cos(angle) - ECCENTRICITY, 0.5 * sin(angle));
        }
    } else {
        assert_int_equal(bmr_ngon_points(plain[def->kind], count, 1, points), BMR_OK);
    }
    test_move_points(points, count, def->phase, def->x, def->y);
    return test_kds_body_make(made_polygon(points, count));
}

// ---- Runs ----

/// Two bodies and their motions over [0, 1]. B may be moved farther out along `out` until the least distance
/// is the wanted one.
typedef struct trial {
    body_def bodies[2];
    bmr_motion_piece pieces[2];
    bmr_vec2 out;
} trial;

static bmr_motion *motion_of(const trial *t, int side, double way) {
    bmr_motion *motion = NULL;
    const bmr_vec2 shift = bmr_scale(side == 1 ? way : 0.0, t->out);
    bmr_motion_piece piece = t->pieces[side];
    if (piece.kind == BMR_PIECE_SCREW) {
        piece.as.screw.start.position = bmr_add(piece.as.screw.start.position, shift);
    } else {
        piece.as.algebraic.x[0] += shift.x;
        piece.as.algebraic.y[0] += shift.y;
    }
    return bmr_motion_create(&piece, NULL, &motion) == BMR_OK ? motion : NULL;
}

typedef struct price {
    double ratio; ///< D over the least distance, as measured
    double events[STRUCTURES];
} price;

static bool run_structures(const bmr_course *course, const bmr_shape *a, const bmr_shape *b, double diameter,
                           price *cost) {
    for (size_t k = 0; k < STRUCTURES; ++k) {
        bmr_run_def def = {
            .structure = structures[k], .shapes = {*a, *b}, .simulation = bmr_default_simulation_def()};
        // No margin to speak of: sigma is the least distance less the margin.
        def.simulation.kds.margin = 1e-6 * diameter / cost->ratio;
        bmr_run run;
        if (bmr_run_course(&def, course, diameter, NULL, &run) != BMR_OK || run.counts.external > 0)
            return false;
        cost->events[k] = (double)run.events;
    }
    return true;
}

/// Moves B in from afar by what the least distance is too much, which never passes the wanted one. False:
/// not found soon, or an angle without a value.
static bool measure(const trial *t, double ratio, price *cost) {
    enum { ROUNDS = 40 };
    own_kds_body a = make_body(&t->bodies[0]), b = make_body(&t->bodies[1]);
    const double diameter = fmax(bmr_polygon_diameter(a.polygon), bmr_polygon_diameter(b.polygon));
    const double sigma = diameter / ratio;
    double way = 12.0, before = diameter;
    *cost = (price){.ratio = 0.0};
    for (int round = 0; round < ROUNDS; ++round) {
        own_motion *p = motion_of(t, 0, way), *q = motion_of(t, 1, way);
        double distance = 0.0, time;
        if (!p || !q ||
            bmr_least_distance(a.polygon, b.polygon, p, q, 0.0, 1.0, fmax(0.1 * sigma, 0.05 * before),
                               &distance, &time) != BMR_OK ||
            !(distance > 0.0))
            return false;
        if (distance < 1.2 * sigma) {
            cost->ratio = diameter / distance;
            const bmr_course course = {{a.polygon, b.polygon}, {p, q}, 0.0, 1.0};
            return run_structures(&course, &a.shape, &b.shape, diameter, cost);
        }
        way -= 0.97 * (distance - sigma);
        before = distance;
    }
    return false;
}

// ---- By hand ----

typedef enum hand {
    ROLL,  ///< two discs turn against each other, each in place: they roll on each other without sliding
    SLIDE, ///< two discs turn the same way
    TEETH, ///< the same as ROLL, with sqrt(D/sigma) corners: each as high as the distance
    KNEES, ///< two corners of radius and corner angles (D/sigma)^(-1/3) roll on each other: see the document
    FOCI,  ///< elliptic gears: equal ellipses that roll on each other about their foci, rationally
    WALTZ, ///< an ellipse and a lens turn off their centres, rationally, while B passes
    GEAR,  ///< the adversary's with sqrt(D/sigma) corners
    TURNS, ///< the control: SLIDE with sqrt(D/sigma) / 4 turns
    HANDS
} hand;
static const char *const hand_names[HANDS] = {"roll", "slide", "teeth", "knees",
                                              "foci", "waltz", "gear",  "turns"};

static bmr_motion_piece spin(double radians) {
    return bmr_piece_screw(0.5, bmr_pose_identity(), bmr_vec2_make(0.0, 0.0), radians);
}

/// x + vx t, y + vy t with a half turn or so: tan of half the angle is `rate` times the time.
static bmr_motion_piece rational(double rate, double vx, double bend) {
    return test_algebraic(
        0.5, (bmr_algebraic_piece){
                 .degree = 2, .rotation_degree = 1, .x = {0.0, vx}, .y = {0.0, 0.0, bend}, .b = {0.0, rate}});
}

/// tan(x / 2) goes from -FOCI_RATE / 2 to FOCI_RATE / 2: nearly a turn.
#define FOCI_RATE 40.0

static trial by_hand(hand kind, double ratio) {
    trial t = {.bodies = {{REGULAR, MOST_VERTICES, 0.1, 0.0, 0.0, 0.0},
                          {REGULAR, MOST_VERTICES, 0.3, 0.0, 0.0, 0.0}},
               .pieces = {spin(2.0 * PI), spin(-2.0 * PI)},
               .out = {1.0, 0.0}};
    const double third = cbrt(ratio);
    switch (kind) {
    case SLIDE:
        t.pieces[1] = spin(2.0 * PI);
        break;
    case TEETH:
        t.bodies[0].vertices = (size_t)ceil(fmax(3.0, sqrt(ratio)));
        t.bodies[1].vertices = t.bodies[0].vertices + 1;
        break;
    case KNEES:
        for (int side = 0; side < 2; ++side)
            t.bodies[side] =
                (body_def){KNEE, (size_t)ceil(third) + 2, side == 0 ? 0.0 : PI, 0.0, 0.0, 2.0 / third};
        t.pieces[0] = spin(PI / 2.0);
        t.pieces[1] = spin(-PI / 2.0);
        break;
    case FOCI:
        // Seen from the near ends, the angles of the contact have tan(x / 2) tan(y / 2) = (1 + e) / (1 - e).
        for (int side = 0; side < 2; ++side) {
            bmr_algebraic_piece *algebraic = &t.pieces[side].as.algebraic;
            t.bodies[side] = (body_def){FOCUS, MOST_VERTICES, 0.0, 0.0, 0.0, 0.0};
            t.pieces[side] = rational(0.0, 0.0, 0.0);
            algebraic->a[0] = 1.0 - side;
            algebraic->a[1] = FOCI_RATE * side;
            algebraic->b[0] = -side * (1.0 + ECCENTRICITY) / (1.0 - ECCENTRICITY);
            algebraic->b[1] = -FOCI_RATE * (1.0 - side);
            algebraic->start_c = 1.0 - 2.0 * side;
        }
        break;
    case WALTZ:
        t.bodies[0] = (body_def){ELLIPSE, MOST_VERTICES, 0.0, 0.3, 0.1, 0.0};
        t.bodies[1] = (body_def){LENS, MOST_VERTICES, 0.5, -0.2, 0.3, 0.0};
        t.pieces[0] = rational(6.0, 0.0, 0.0);
        t.pieces[1] = rational(-5.0, 2.0, -1.0);
        t.out = bmr_vec2_make(0.6, 0.8);
        break;
    case TURNS:
        t.pieces[0] = t.pieces[1] = spin(0.5 * PI * sqrt(ratio));
        break;
    case ROLL:
    case GEAR:
    case HANDS:
        break;
    }
    return t;
}

static bool measure_gear(double ratio, price *cost) {
    const size_t corners = (size_t)ceil(fmax(4.0, sqrt(ratio)));
    const adversary gear = adversary_make(ADVERSARY_GEAR, corners, 2.0 / ratio);
    *cost = (price){.ratio = ratio};
    own_kds_body a = test_kds_body_make(gear.polygons[0]), b = test_kds_body_make(gear.polygons[1]);
    own_motion *p = gear.motions[0], *q = gear.motions[1];
    const bmr_course course = {{a.polygon, b.polygon}, {p, q}, 0.0, 1.0};
    return run_structures(&course, &a.shape, &b.shape, 2.0, cost);
}

static void grow(hand kind, double last, bmr_growth growth[STRUCTURES]) {
    double x[MOST_RATIOS], y[STRUCTURES][MOST_RATIOS];
    size_t count = 0;
    for (double ratio = FIRST_RATIO; ratio <= 1.01 * last && count < MOST_RATIOS; ratio *= 4.0) {
        const trial t = by_hand(kind, ratio);
        price cost;
        assert_true(kind == GEAR ? measure_gear(ratio, &cost) : measure(&t, ratio, &cost));
        printf("%-6s D/sigma %8.0f: events %6.0f %6.0f %6.0f\n", hand_names[kind], cost.ratio, cost.events[0],
               cost.events[1], cost.events[2]);
        x[count] = cost.ratio;
        for (size_t k = 0; k < STRUCTURES; ++k)
            y[k][count] = cost.events[k];
        ++count;
    }
    for (size_t k = 0; k < STRUCTURES; ++k) {
        assert_int_equal(bmr_fit_growth(x, y[k], count, &growth[k]), BMR_OK);
        printf("%-6s %-12s exponent %.2f +- %.2f\n", hand_names[kind], structures[k]->name,
               growth[k].exponent, growth[k].exponent_error);
    }
}

static double last_ratio(void) {
    return fmin(LAST_RATIO * (double)test_scaled(16) / 16.0, 16.0 * LAST_RATIO);
}

/// Half, and what few points of small counts scatter by: measured are at most 0.57 (0.56 where the distances
/// go on to 80,000) of motions that are said to cost the root, and 1 of the control.
static bool is_root_at_most(const bmr_growth *growth) {
    return growth->exponent <= 0.6;
}

TEST(no_motion_by_hand_costs_more_than_the_root) {
    for (int kind = 0; kind < TURNS; ++kind) {
        bmr_growth growth[STRUCTURES];
        grow((hand)kind, fmax(last_ratio(), LAST_RATIO), growth);
        for (size_t k = 0; k < STRUCTURES; ++k)
            assert_true(is_root_at_most(&growth[k]));
    }
}

TEST(control_many_turns_cost_more_than_the_root) {
    bmr_growth growth[STRUCTURES];
    grow(TURNS, LAST_RATIO / 4.0, growth); // it costs as much as the motions above together
    for (size_t k = 0; k < STRUCTURES; ++k)
        assert_false(is_root_at_most(&growth[k]));
}

/// The gear of half as many corners, sqrt(D/sigma)/2: the repairs of one structure.
static double repairs_on_gear(const char *name) {
    enum { CORNERS = 128 };
    const double separation = 2.0 / (4.0 * CORNERS * CORNERS);
    const adversary gear = adversary_make(ADVERSARY_GEAR, CORNERS, separation);
    own_kds_body a = test_kds_body_make(gear.polygons[0]), b = test_kds_body_make(gear.polygons[1]);
    own_motion *p = gear.motions[0], *q = gear.motions[1];
    const bmr_course course = {{a.polygon, b.polygon}, {p, q}, 0.0, 1.0};
    bmr_run_def def = {.structure = test_structure(name),
                       .shapes = {a.shape, b.shape},
                       .simulation = bmr_default_simulation_def()};
    bmr_run run;
    assert_int_equal(bmr_run_course(&def, &course, 2.0, NULL, &run), BMR_OK);
    assert_int_equal(run.counts.external, 0);
    const double handovers = (double)run.counts.events[BMR_KDS_HANDOVER];
    printf("%-16s %4.0f events, %4.0f of them handovers, %4.0f lines\n", name, (double)run.events, handovers,
           (double)run.lines);
    return (double)run.events - handovers;
}

/// The row of docs/open-question.md, "All families".
TEST(on_a_gear_two_lines_have_fewer_repairs_than_one_line_has_events) {
    const double hybrid = repairs_on_gear("hybrid"), free_direction = repairs_on_gear("free-fd2"),
                 two_lines = repairs_on_gear("two-lines");
    repairs_on_gear("coarse");
    repairs_on_gear("lazy-dudley");
    repairs_on_gear("predict-adaptive");
    assert_true(two_lines > 0.0 && two_lines <= 0.5 * free_direction && free_direction <= 0.5 * hybrid);
}
