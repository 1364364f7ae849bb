// SPDX-License-Identifier: MIT
// Bad arguments of boomerang::kinetic: motions, failure times, simulations, analysis.
#include <climits>

#include "arguments.h"
#include "boomerang/analysis.h"
#include "boomerang/families.h"
#include "boomerang/simulation.h"
#include "boomerang/time_of_contact.h"
#include "boomerang/world.h"
#include "kinetic/first_root.h"
#include "points.h"
#include "structure_named.h"

using namespace bad_input;

namespace {

const bmr_pose kHere = {{0, 0}, 1, 0};

bmr_polygon *Polygon(size_t count) {
    const std::vector<double> xy = Circle(count, 1.0);
    bmr_polygon *polygon = nullptr;
    bmr_polygon_create(reinterpret_cast<const bmr_vec2 *>(xy.data()), count, nullptr, &polygon);
    return polygon;
}

/// Two 8-gons, 10 apart, that come together at a speed of 1; every cell frees its own.
struct Pair {
    bmr_polygon *polygon = Polygon(8);
    bmr_motion *rest = nullptr, *comes = nullptr;
    bmr_course course = {};

    Pair() {
        const bmr_motion_piece still = bmr_piece_rest(kHere);
        const bmr_motion_piece moves = bmr_piece_screw(0.0, {{10, 0}, 1, 0}, {-1, 0}, 0.0);
        bmr_motion_create(&still, nullptr, &rest);
        bmr_motion_create(&moves, nullptr, &comes);
        course = {{polygon, polygon}, {rest, comes}, 0.0, 5.0};
    }
    Pair(const Pair &) = delete;
    Pair &operator=(const Pair &) = delete;
    ~Pair() {
        bmr_motion_destroy(rest);
        bmr_motion_destroy(comes);
        bmr_polygon_destroy(polygon, nullptr);
    }
};

std::string Motion(void (*spoil)(bmr_motion_piece *)) {
    bmr_motion_piece piece = bmr_piece_screw(0.0, kHere, {1, 0}, 1.0);
    spoil(&piece);
    bmr_motion *motion = nullptr;
    const bmr_error error = bmr_motion_create(&piece, nullptr, &motion);
    bmr_motion_destroy(motion);
    return Said(error);
}

std::string Algebraic(void (*spoil)(bmr_algebraic_piece *)) {
    bmr_motion_piece piece = {};
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.as.algebraic.degree = 1;
    piece.as.algebraic.x[1] = 1.0;
    piece.as.algebraic.a[0] = 1.0;
    piece.as.algebraic.start_c = 1.0;
    spoil(&piece.as.algebraic);
    bmr_motion *motion = nullptr;
    const bmr_error error = bmr_motion_create(&piece, nullptr, &motion);
    bmr_motion_destroy(motion);
    return Said(error);
}

std::string Sampled(const std::vector<double> &times, const std::vector<bmr_pose> &poses) {
    bmr_motion *motion = nullptr;
    const bmr_error error =
        bmr_motion_create_sampled(times.data(), poses.data(), times.size(), nullptr, &motion);
    bmr_motion_destroy(motion);
    return Said(error);
}

std::string Change(double time) {
    const Pair pair;
    const bmr_motion_piece still = bmr_piece_rest(kHere);
    const bmr_error error = bmr_motion_change(pair.comes, time, &still);
    return Said(error) + (error != BMR_OK && bmr_motion_piece_count(pair.comes) != 1 ? ", changed" : "");
}

std::string FirstRoot(const std::vector<double> &coefficients, double from, double to) {
    double root = -77.0;
    const bmr_error error =
        bmr_polynomial_first_root(coefficients.data(), coefficients.size() - 1, from, to, &root);
    return error != BMR_OK ? Said(error) + (root == -77.0 ? "" : ", and the root is written") : Said(root);
}

std::string FailureTime(double after, double until, double tolerance,
                        void (*spoil)(bmr_condition *, bmr_failure_options *) = nullptr) {
    const Pair pair;
    bmr_condition condition = bmr_condition_beyond(0, {1, 0}, 5.0, {0, 0}, 0);
    bmr_failure_options options = bmr_default_failure_options();
    options.tolerance = tolerance;
    if (spoil != nullptr)
        spoil(&condition, &options);
    double time = -77.0;
    const bmr_error error =
        bmr_failure_time(&condition, pair.rest, pair.comes, after, until, &options, &time);
    if (error != BMR_OK)
        return Said(error) + (time == -77.0 ? "" : ", and the time is written");
    return std::isinf(time) ? "never" : "a time";
}

using SpoilDef = void (*)(bmr_simulation_def *);

bmr_error Simulation(const Pair &pair, size_t count, double time, SpoilDef spoil, bmr_simulation **made) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = test_structure("free-fd1");
    if (spoil != nullptr)
        spoil(&def);
    const bmr_shape shapes[] = {{pair.polygon, {}, {}}, {pair.polygon, {}, {}}};
    bmr_motion *const motions[] = {pair.rest, pair.comes};
    return bmr_simulation_create(&def, shapes, motions, count, time, nullptr, nullptr, nullptr, made);
}

std::string Create(size_t count, double time, SpoilDef spoil = nullptr) {
    const Pair pair;
    bmr_simulation *simulation = nullptr;
    const bmr_error error = Simulation(pair, count, time, spoil, &simulation);
    bmr_simulation_destroy(simulation);
    return Said(error);
}

std::string TimeOfContact(double from, double until, double margin, bool shapes = true) {
    const Pair pair;
    const bmr_shape shape = {shapes ? pair.polygon : nullptr, {}, {}};
    double time = -77.0;
    const bmr_error error =
        bmr_time_of_contact(&shape, pair.rest, &shape, pair.comes, from, until, margin, nullptr, &time);
    return Said(error) + (error != BMR_OK && time != -77.0 ? ", and the time is written" : "");
}

template <typename Ask> std::string Running(const Ask &ask) {
    const Pair pair;
    bmr_simulation *simulation = nullptr;
    if (Simulation(pair, 2, 0.0, nullptr, &simulation) != BMR_OK ||
        bmr_simulation_run(simulation, 1.0) != BMR_OK)
        return "does not run";
    std::string answer = Said(ask(simulation));
    // It is as good as before.
    if (bmr_simulation_run(simulation, std::fmax(2.0, bmr_simulation_time(simulation))) != BMR_OK ||
        bmr_simulation_audit(simulation) != BMR_OK)
        answer += ", and it runs no more";
    bmr_simulation_destroy(simulation);
    return answer;
}

using SpoilWorld = void (*)(bmr_world_def *);

std::string World(SpoilWorld spoil, double time = 0.0) {
    bmr_world_def def = bmr_default_world_def();
    def.high = {10.0, 10.0};
    spoil(&def);
    bmr_world *world = nullptr;
    const bmr_error error = bmr_world_create(&def, time, nullptr, &world);
    std::string answer = Said(error);
    if (error != BMR_OK && world != nullptr)
        answer += ", and the world is written";
    bmr_world_destroy(world);
    return answer;
}

/// What a world of one body, id 0, says; and that it is as good as before.
template <typename Ask> std::string InWorld(const Ask &ask) {
    const Pair pair;
    const bmr_shape shape = {pair.polygon, {}, {}};
    bmr_world_def def = bmr_default_world_def();
    bmr_world *world = nullptr;
    bmr_body body = BMR_NO_BODY;
    bmr_body_def good = bmr_default_body_def(&shape, pair.rest);
    if (bmr_world_create(&def, 0.0, nullptr, &world) != BMR_OK ||
        bmr_world_add(world, &good, &body) != BMR_OK || bmr_world_advance(world, 1.0) != BMR_OK)
        return "does not run";
    good.motion = pair.comes;
    std::string answer = Said(ask(world, &good));
    if (bmr_world_body_count(world) != 1 || bmr_world_advance(world, 2.0) != BMR_OK ||
        bmr_world_audit(world) != BMR_OK)
        answer += ", and it is not as before";
    bmr_world_destroy(world);
    return answer;
}

std::string Body(void (*spoil)(bmr_body_def *)) {
    return InWorld([spoil](bmr_world *world, bmr_body_def *def) {
        spoil(def);
        bmr_body body;
        return bmr_world_add(world, def, &body);
    });
}

std::string Optimum(double margin, double resolution, double from, double to) {
    Pair pair;
    pair.course.from = from;
    pair.course.to = to;
    bmr_optimum optimum;
    return Said(bmr_offline_optimum(&pair.course, margin, resolution, nullptr, 0, &optimum));
}

std::string Clear(double kappa, double diameter) {
    const Pair pair;
    bmr_clear clear;
    return Said(bmr_clear_decomposition(&pair.course, kappa, diameter, &clear));
}

std::string Fit(const std::vector<double> &x, const std::vector<double> &y) {
    bmr_growth growth;
    return Said(bmr_fit_growth(x.data(), y.data(), x.size(), &growth));
}

std::string Adversary(size_t n, double separation) {
    bmr_adversary adversary = {};
    const bmr_error error = bmr_adversary_create(BMR_ADVERSARY_PASS, n, separation, nullptr, &adversary);
    if (error == BMR_OK)
        bmr_adversary_destroy(&adversary, nullptr);
    return Said(error);
}

std::string Family(void (*spoil)(bmr_family_def *)) {
    const Pair pair;
    bmr_family_def def = {BMR_FAMILY_LINE, 4.0, 1, 0, 0};
    spoil(&def);
    bmr_family_motion made = {};
    const bmr_error error = bmr_family_create(&def, pair.polygon, pair.polygon, nullptr, &made);
    if (error == BMR_OK)
        bmr_family_destroy(&made);
    return Said(error);
}

std::string LeastDistance(double from, double to, double tolerance) {
    const Pair pair;
    double distance, time;
    return Said(bmr_least_distance(pair.polygon, pair.polygon, pair.rest, pair.comes, from, to, tolerance,
                                   &distance, &time));
}

std::string Outline(size_t n) {
    std::vector<bmr_vec2> points(n > 65535 ? 1 : n + 1);
    return Said(bmr_outline_points(BMR_OUTLINE_REGULAR, n, 1, points.data()));
}

std::vector<Argument> OfMotions() {
    return {
        {"`bmr_motion_create`: `NULL`",
         [] {
             bmr_motion *motion = nullptr;
             return Said(bmr_motion_create(nullptr, nullptr, &motion));
         }},
        {"`bmr_motion_create`: a position of NaN",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.start.position.x = kNone; }); }},
        {"`bmr_motion_create`: an infinite velocity",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.velocity.y = kInfinite; }); }},
        {"`bmr_motion_create`: a spin of NaN",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.spin = kNone; }); }},
        {"`bmr_motion_create`: an origin of NaN",
         [] { return Motion([](bmr_motion_piece *p) { p->origin = kNone; }); }},
        {"`bmr_motion_create`: a rotation of length 2",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.start.c = 2.0; }); }},
        {"`bmr_motion_create`: a rotation of length 0",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.start.c = 0.0; }); }},
        {"`bmr_motion_create`: a rotation of NaN",
         [] { return Motion([](bmr_motion_piece *p) { p->as.screw.start.s = kNone; }); }},
        {"`bmr_motion_create`: degree 9",
         [] { return Algebraic([](bmr_algebraic_piece *p) { p->degree = 9; }); }},
        {"`bmr_motion_create`: degree `SIZE_MAX`",
         [] { return Algebraic([](bmr_algebraic_piece *p) { p->degree = SIZE_MAX; }); }},
        {"`bmr_motion_create`: rotation degree `SIZE_MAX`",
         [] { return Algebraic([](bmr_algebraic_piece *p) { p->rotation_degree = SIZE_MAX; }); }},
        {"`bmr_motion_create`: a coefficient of NaN",
         [] { return Algebraic([](bmr_algebraic_piece *p) { p->x[1] = kNone; }); }},
        {"`bmr_motion_create`: a and b both zero",
         [] { return Algebraic([](bmr_algebraic_piece *p) { p->a[0] = 0.0; }); }},
        {"`bmr_motion_create_sampled`: no samples",
         [] {
             const double time = 0.0;
             bmr_motion *motion = nullptr;
             return Said(bmr_motion_create_sampled(&time, &kHere, 0, nullptr, &motion));
         }},
        {"`bmr_motion_create_sampled`: a time of NaN",
         [] {
             return Sampled({0, kNone}, {kHere, kHere});
         }},
        {"`bmr_motion_create_sampled`: an infinite time",
         [] {
             return Sampled({0, kInfinite}, {kHere, kHere});
         }},
        {"`bmr_motion_create_sampled`: a time twice",
         [] {
             return Sampled({0, 0}, {kHere, kHere});
         }},
        {"`bmr_motion_create_sampled`: times that descend",
         [] {
             return Sampled({1, 0}, {kHere, kHere});
         }},
        {"`bmr_motion_create_sampled`: a pose of NaN",
         [] {
             return Sampled({0, 1}, {kHere, {{kNone, 0}, 1, 0}});
         }},
        {"`bmr_motion_create_sampled`: 1e308 away in 1e-38",
         [] {
             return Sampled({0, 1e-38}, {kHere, {{1e308, 0}, 1, 0}});
         }},
        {"`bmr_motion_change`: at NaN", [] { return Change(kNone); }},
        {"`bmr_motion_change`: at infinity", [] { return Change(kInfinite); }},
        {"`bmr_motion_change`: at 1e308", [] { return Change(1e308); }},
        {"`bmr_motion_destroy`: `NULL`",
         [] {
             bmr_motion_destroy(nullptr);
             return std::string("nothing happens");
         }},
        {"`bmr_motion_pose`: at NaN",
         [] {
             const Pair pair;
             return Said(bmr_motion_pose(pair.comes, kNone, nullptr, nullptr).position.x);
         }},
        {"`bmr_motion_pose`: at infinity",
         [] {
             const Pair pair;
             return Said(bmr_motion_pose(pair.comes, kInfinite, nullptr, nullptr).position.x);
         }},
        {"`bmr_motion_piece_speed`: degree `SIZE_MAX`",
         [] {
             bmr_motion_piece piece = {};
             piece.kind = BMR_PIECE_ALGEBRAIC;
             piece.as.algebraic.degree = SIZE_MAX;
             return Said(bmr_motion_piece_speed(&piece, 0.0, 1.0, 1.0));
         }},
        {"`bmr_screw_motion_pose`: at NaN",
         [] {
             const bmr_screw_motion motion = {kHere, {1, 0}, 1.0};
             return Said(bmr_screw_motion_pose(&motion, kNone).c);
         }},
        {"`bmr_screw_motion_pose`: at infinity",
         [] {
             const bmr_screw_motion motion = {kHere, {1, 0}, 1.0};
             return Said(bmr_screw_motion_pose(&motion, kInfinite).c);
         }},
        {"`bmr_time_of_contact`: no polygon", [] { return TimeOfContact(0, 1, 0.01, false); }},
        {"`bmr_time_of_contact`: from NaN", [] { return TimeOfContact(kNone, 1, 0.01); }},
        {"`bmr_time_of_contact`: until infinity", [] { return TimeOfContact(0, kInfinite, 0.01); }},
        {"`bmr_time_of_contact`: from after until", [] { return TimeOfContact(2, 1, 0.01); }},
        {"`bmr_time_of_contact`: a margin of 0", [] { return TimeOfContact(0, 1, 0.0); }},
        {"`bmr_time_of_contact`: a margin of NaN", [] { return TimeOfContact(0, 1, kNone); }},
        {"`bmr_polynomial_first_root`: a coefficient of NaN",
         [] {
             return FirstRoot({1, kNone}, 0, 1);
         }},
        {"`bmr_polynomial_first_root`: an infinite coefficient",
         [] {
             return FirstRoot({1, -kInfinite}, 0, 1);
         }},
        {"`bmr_polynomial_first_root`: from NaN",
         [] {
             return FirstRoot({1, -2}, kNone, 1);
         }},
        {"`bmr_polynomial_first_root`: to infinity",
         [] {
             return FirstRoot({1, -2}, 0, kInfinite);
         }},
        {"`bmr_polynomial_first_root`: from after to",
         [] {
             return FirstRoot({1, -2}, 1, 0);
         }},
        {"`bmr_polynomial_first_root`: degree 49",
         [] { return FirstRoot(std::vector<double>(50, 1.0), 0, 1); }},
        {"`bmr_polynomial_first_root`: degree `SIZE_MAX`",
         [] {
             const double one = 1.0;
             double root = 0.0;
             return Said(bmr_polynomial_first_root(&one, SIZE_MAX, 0, 1, &root));
         }},
        {"`bmr_polynomial_first_root`: coefficients of 1e308 and 1e-308",
         [] {
             return FirstRoot({1e308, -1e308, 1e-308, 1e308}, 0, 1e9);
         }},
        {"`bmr_failure_time`: a good one", [] { return FailureTime(0, 100, 1e-12); }},
        {"`bmr_failure_time`: after NaN", [] { return FailureTime(kNone, 100, 1e-12); }},
        {"`bmr_failure_time`: until infinity", [] { return FailureTime(0, kInfinite, 1e-12); }},
        {"`bmr_failure_time`: until before after", [] { return FailureTime(1, 0, 1e-12); }},
        {"`bmr_failure_time`: until 1e308", [] { return FailureTime(0, 1e308, 1e-12); }},
        {"`bmr_failure_time`: a tolerance of 0", [] { return FailureTime(0, 100, 0.0); }},
        {"`bmr_failure_time`: a tolerance below 0", [] { return FailureTime(0, 100, -1.0); }},
        {"`bmr_failure_time`: a tolerance of NaN", [] { return FailureTime(0, 100, kNone); }},
        {"`bmr_failure_time`: no such condition",
         [] {
             return FailureTime(0, 100, 1e-12, [](bmr_condition *c, bmr_failure_options *) { c->kind = 77; });
         }},
        {"`bmr_failure_time`: a normal of NaN",
         [] {
             return FailureTime(0, 100, 1e-12,
                                [](bmr_condition *c, bmr_failure_options *) { c->normal.x = kNone; });
         }},
    };
}

std::vector<Argument> OfRuns() {
    return {
        {"`bmr_simulation_create`: no structure",
         [] { return Create(2, 0.0, [](bmr_simulation_def *d) { d->structure = nullptr; }); }},
        {"`bmr_simulation_create`: no bodies", [] { return Create(0, 0.0); }},
        {"`bmr_simulation_create`: one body", [] { return Create(1, 0.0); }},
        {"`bmr_simulation_create`: at NaN", [] { return Create(2, kNone); }},
        {"`bmr_simulation_create`: at infinity", [] { return Create(2, kInfinite); }},
        {"`bmr_simulation_create`: a contact step of 0",
         [] { return Create(2, 0.0, [](bmr_simulation_def *d) { d->contact_step = 0.0; }); }},
        {"`bmr_simulation_create`: a contact step of NaN",
         [] { return Create(2, 0.0, [](bmr_simulation_def *d) { d->contact_step = kNone; }); }},
        {"`bmr_simulation_create`: a tolerance of 0",
         [] { return Create(2, 0.0, [](bmr_simulation_def *d) { d->failure.tolerance = 0.0; }); }},
        {"`bmr_simulation_create`: a margin of NaN",
         [] { return Create(2, 0.0, [](bmr_simulation_def *d) { d->kds.margin = kNone; }); }},
        {"`bmr_simulation_run`: `NULL`", [] { return Said(bmr_simulation_run(nullptr, 1.0)); }},
        {"`bmr_simulation_run`: until NaN",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, kNone); }); }},
        {"`bmr_simulation_run`: until infinity",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, kInfinite); }); }},
        {"`bmr_simulation_run`: until before now",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, 0.5); }); }},
        {"`bmr_simulation_run`: until now",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, 1.0); }); }},
        {"`bmr_simulation_run`: until 1e9",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, 1e9); }); }},
        {"`bmr_simulation_run`: until 1e308",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_run(s, 1e308); }); }},
        {"`bmr_simulation_replan`: body 2 of 2",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_replan(s, 2); }); }},
        {"`bmr_simulation_replan`: body `SIZE_MAX`",
         [] { return Running([](bmr_simulation *s) { return bmr_simulation_replan(s, SIZE_MAX); }); }},
        {"`bmr_simulation_audit`: `NULL`", [] { return Said(bmr_simulation_audit(nullptr)); }},
        {"`bmr_simulation_destroy`: `NULL`",
         [] {
             bmr_simulation_destroy(nullptr);
             return std::string("nothing happens");
         }},
        {"`bmr_world_create`: no structure",
         [] { return World([](bmr_world_def *d) { d->structure = nullptr; }); }},
        {"`bmr_world_create`: a structure for points",
         [] { return World([](bmr_world_def *d) { d->structure = test_structure("point-lazy-dudley"); }); }},
        {"`bmr_world_create`: at NaN", [] { return World([](bmr_world_def *) {}, kNone); }},
        {"`bmr_world_create`: a margin of 0",
         [] { return World([](bmr_world_def *d) { d->kds.margin = 0.0; }); }},
        {"`bmr_world_create`: a margin of NaN",
         [] { return World([](bmr_world_def *d) { d->kds.margin = kNone; }); }},
        {"`bmr_world_create`: a restitution of 2",
         [] { return World([](bmr_world_def *d) { d->response.restitution = 2.0; }); }},
        {"`bmr_world_create`: walls without a box",
         [] { return World([](bmr_world_def *d) { d->boundary = BMR_WALLED, d->high = d->low; }); }},
        {"`bmr_world_create`: an infinite periodic box",
         [] { return World([](bmr_world_def *d) { d->boundary = BMR_PERIODIC, d->high.x = kInfinite; }); }},
        {"`bmr_world_add`: no motion", [] { return Body([](bmr_body_def *d) { d->motion = nullptr; }); }},
        {"`bmr_world_add`: a mass of 0", [] { return Body([](bmr_body_def *d) { d->mass = 0.0; }); }},
        {"`bmr_world_add`: a mass of NaN", [] { return Body([](bmr_body_def *d) { d->mass = kNone; }); }},
        {"`bmr_world_add`: an inertia below 0",
         [] { return Body([](bmr_body_def *d) { d->inertia = -1.0; }); }},
        {"`bmr_world_remove`: no such body",
         [] { return InWorld([](bmr_world *w, bmr_body_def *) { return bmr_world_remove(w, 1); }); }},
        {"`bmr_world_remove`: a wall",
         [] {
             return InWorld([](bmr_world *w, bmr_body_def *) { return bmr_world_remove(w, BMR_WALL(0)); });
         }},
        {"`bmr_world_set_motion`: `NULL`",
         [] {
             return InWorld([](bmr_world *w, bmr_body_def *) { return bmr_world_set_motion(w, 0, nullptr); });
         }},
        {"`bmr_world_set_motion`: no such body",
         [] {
             return InWorld(
                 [](bmr_world *w, bmr_body_def *d) { return bmr_world_set_motion(w, 7, d->motion); });
         }},
        {"`bmr_world_set_piece`: a place of NaN",
         [] {
             return InWorld([](bmr_world *w, bmr_body_def *) {
                 const bmr_motion_piece piece = bmr_piece_rest({{kNone, 0}, 1, 0});
                 return bmr_world_set_piece(w, 0, &piece);
             });
         }},
        {"`bmr_world_advance`: until NaN",
         [] { return InWorld([](bmr_world *w, bmr_body_def *) { return bmr_world_advance(w, kNone); }); }},
        {"`bmr_world_advance`: until before now",
         [] { return InWorld([](bmr_world *w, bmr_body_def *) { return bmr_world_advance(w, 0.5); }); }},
        {"`bmr_world_get`: no such body",
         [] {
             return InWorld([](bmr_world *w, bmr_body_def *) {
                 bmr_body_state state;
                 return bmr_world_get(w, 3, &state);
             });
         }},
        {"`bmr_world_audit`: `NULL`", [] { return Said(bmr_world_audit(nullptr)); }},
        {"`bmr_run_course`: `NULL`",
         [] {
             bmr_run run;
             return Said(bmr_run_course(nullptr, nullptr, 1.0, nullptr, &run));
         }},
        {"`bmr_offline_optimum`: `NULL`",
         [] {
             bmr_optimum optimum;
             return Said(bmr_offline_optimum(nullptr, 1e-6, 0.02, nullptr, 0, &optimum));
         }},
        {"`bmr_offline_optimum`: a good one", [] { return Optimum(1e-6, 0.02, 0, 5); }},
        {"`bmr_offline_optimum`: a margin of 0", [] { return Optimum(0.0, 0.02, 0, 5); }},
        {"`bmr_offline_optimum`: a margin of NaN", [] { return Optimum(kNone, 0.02, 0, 5); }},
        {"`bmr_offline_optimum`: an infinite margin", [] { return Optimum(kInfinite, 0.02, 0, 5); }},
        {"`bmr_offline_optimum`: a resolution of 1", [] { return Optimum(1e-6, 1.0, 0, 5); }},
        {"`bmr_offline_optimum`: a resolution of NaN", [] { return Optimum(1e-6, kNone, 0, 5); }},
        {"`bmr_offline_optimum`: from after to", [] { return Optimum(1e-6, 0.02, 5, 0); }},
        {"`bmr_offline_optimum`: from NaN", [] { return Optimum(1e-6, 0.02, kNone, 5); }},
        {"`bmr_clear_decomposition`: kappa 2 (a good one)", [] { return Clear(2.0, 1.0); }},
        {"`bmr_clear_decomposition`: kappa 1", [] { return Clear(1.0, 1.0); }},
        {"`bmr_clear_decomposition`: kappa NaN", [] { return Clear(kNone, 1.0); }},
        {"`bmr_clear_decomposition`: infinite kappa", [] { return Clear(kInfinite, 1.0); }},
        {"`bmr_clear_decomposition`: a diameter below 0", [] { return Clear(2.0, -1.0); }},
        {"`bmr_clear_decomposition`: a diameter of NaN", [] { return Clear(2.0, kNone); }},
        {"`bmr_clear_decomposition`: an infinite diameter", [] { return Clear(2.0, kInfinite); }},
        {"`bmr_fit_growth`: no points",
         [] {
             const double one = 1.0;
             bmr_growth growth;
             return Said(bmr_fit_growth(&one, &one, 0, &growth));
         }},
        {"`bmr_fit_growth`: one point", [] { return Fit({1}, {1}); }},
        {"`bmr_fit_growth`: the same x twice",
         [] {
             return Fit({2, 2}, {1, 3});
         }},
        {"`bmr_fit_growth`: x of NaN",
         [] {
             return Fit({1, kNone}, {1, 2});
         }},
        {"`bmr_fit_growth`: x of 0",
         [] {
             return Fit({0, 1}, {1, 2});
         }},
        {"`bmr_fit_growth`: y below 0",
         [] {
             return Fit({1, 2}, {1, -2});
         }},
        {"`bmr_fit_growth`: 100,000 points",
         [] { return Fit(std::vector<double>(100000, 1.0), std::vector<double>(100000, 1.0)); }},
        {"`bmr_adversary_create`: 2 vertices", [] { return Adversary(2, 0.1); }},
        {"`bmr_adversary_create`: 4,097 vertices", [] { return Adversary(4097, 0.1); }},
        {"`bmr_adversary_create`: `SIZE_MAX` vertices", [] { return Adversary(SIZE_MAX, 0.1); }},
        {"`bmr_adversary_create`: a separation of 0", [] { return Adversary(8, 0.0); }},
        {"`bmr_adversary_create`: a separation of NaN", [] { return Adversary(8, kNone); }},
        {"`bmr_adversary_create`: an infinite separation", [] { return Adversary(8, kInfinite); }},
        {"`bmr_adversary_name`, `bmr_family_name`, `bmr_outline_name`: none",
         [] {
             return bmr_adversary_name(BMR_ADVERSARY_COUNT) == nullptr &&
                            bmr_family_name(BMR_FAMILY_COUNT) == nullptr &&
                            bmr_outline_name(BMR_OUTLINE_COUNT) == nullptr
                        ? "`NULL`"
                        : "a name";
         }},
        {"`bmr_family_create`: no family",
         [] { return Family([](bmr_family_def *d) { d->family = BMR_FAMILY_COUNT; }); }},
        {"`bmr_family_create`: a ratio of NaN",
         [] { return Family([](bmr_family_def *d) { d->ratio = kNone; }); }},
        {"`bmr_family_create`: a ratio below 1",
         [] { return Family([](bmr_family_def *d) { d->ratio = 0.5; }); }},
        {"`bmr_family_create`: a ratio of 1e38",
         [] { return Family([](bmr_family_def *d) { d->ratio = 1e38; }); }},
        {"`bmr_family_create`: a zigzag of 7 legs",
         [] {
             return Family([](bmr_family_def *d) {
                 d->family = BMR_FAMILY_ZIGZAG;
                 d->steps = 7;
             });
         }},
        {"`bmr_least_distance`: a tolerance of 0", [] { return LeastDistance(0, 1, 0.0); }},
        {"`bmr_least_distance`: a tolerance of NaN", [] { return LeastDistance(0, 1, kNone); }},
        {"`bmr_least_distance`: from after to", [] { return LeastDistance(1, 0, 0.1); }},
        {"`bmr_least_distance`: to infinity", [] { return LeastDistance(0, kInfinite, 0.1); }},
        {"`bmr_outline_points`: 2 points", [] { return Outline(2); }},
        {"`bmr_outline_points`: 65,536 points", [] { return Outline(65536); }},
        {"`bmr_outline_points`: no place for them",
         [] { return Said(bmr_outline_points(BMR_OUTLINE_LENS, 8, 1, nullptr)); }},
    };
}

} // namespace

int main(int argc, char **argv) {
    return Main(argc, argv,
                {ArgumentTable("motions and failure times", OfMotions()),
                 ArgumentTable("simulations and analysis", OfRuns())});
}
