// SPDX-License-Identifier: MIT
// boomerang::kinetic's functions: motions, failure times, simulations, worlds, analysis. What refuses a call
// goes on as before.
#include <gsl/gsl_rng.h>

#include "boomerang/analysis.h"
#include "boomerang/failure.h"
#include "boomerang/simulation.h"
#include "boomerang/time_of_contact.h"
#include "boomerang/world.h"
#include "contracts.h"
#include "failing_allocator.h"
#include "kds_driver.h"
#include "kinetic/roots.h"

using namespace contracts;

// --- GSL's allocations, which come from malloc: the linker's --wrap counts them with the others ---

// NOLINTBEGIN(bugprone-reserved-identifier): the linker's names
extern "C" {
gsl_rng *__real_gsl_rng_alloc(const gsl_rng_type *type);
gsl_rng *__wrap_gsl_rng_alloc(const gsl_rng_type *type);
void __real_gsl_rng_free(gsl_rng *random);
void __wrap_gsl_rng_free(gsl_rng *random);
}

/// Whose books GSL's generators are in.
static test_heap *counting;

gsl_rng *__wrap_gsl_rng_alloc(const gsl_rng_type *type) {
    if (counting != nullptr && counting->asked++ == counting->fail_at)
        return nullptr;
    gsl_rng *made = __real_gsl_rng_alloc(type);
    if (counting != nullptr && made != nullptr)
        ++counting->blocks;
    return made;
}

void __wrap_gsl_rng_free(gsl_rng *random) {
    if (counting != nullptr && random != nullptr)
        --counting->blocks;
    __real_gsl_rng_free(random);
}
// NOLINTEND(bugprone-reserved-identifier)

namespace {

struct CountGsl {
    explicit CountGsl(const bmr_allocator *allocator) {
        counting = allocator != nullptr ? static_cast<test_heap *>(allocator->context) : nullptr;
    }
    ~CountGsl() { counting = nullptr; }
};

const bmr_pose kSlanted = {{10, 0}, 0.8, 0.6};

/// Two 12-gons, 10 apart, that come together at a speed of 1.
struct MovingPair {
    bmr_polygon *polygon = Polygon(Ellipse(12));
    bmr_motion *rest = nullptr, *comes = nullptr, *other = nullptr;

    MovingPair() {
        const bmr_motion_piece still = bmr_piece_rest({{0, 0}, 1, 0}), far = bmr_piece_rest({{-10, 0}, 1, 0});
        const bmr_motion_piece moves = bmr_piece_screw(0.0, {{10, 0}, 1, 0}, {-1, 0}, 0.0);
        bmr_motion_create(&still, nullptr, &rest);
        bmr_motion_create(&moves, nullptr, &comes);
        bmr_motion_create(&far, nullptr, &other);
    }
    MovingPair(const MovingPair &) = delete;
    MovingPair &operator=(const MovingPair &) = delete;
    ~MovingPair() {
        for (bmr_motion *motion : {rest, comes, other})
            bmr_motion_destroy(motion);
        bmr_polygon_destroy(polygon, nullptr);
    }
    bmr_shape Shape() const { return {polygon, {}, {}}; }
    bmr_course Course(double from = 0.0, double to = 5.0) const {
        return {{polygon, polygon}, {rest, comes}, from, to};
    }
};

const MovingPair &ThePair() {
    static const MovingPair pair;
    return pair;
}

/// The bytes of its poses.
std::string PosesOf(const bmr_motion *motion) {
    std::string bytes;
    for (int i = -5; i <= 30; ++i) {
        const bmr_pose pose = bmr_motion_pose(motion, i, nullptr, nullptr);
        bytes.append(reinterpret_cast<const char *>(&pose), sizeof pose);
    }
    return bytes;
}

void Made(const Asked &ask, const bmr_motion *motion) {
    const std::string poses = PosesOf(motion);
    ask.Made(poses.data(), poses.size());
}

/// The end of a call that makes a motion.
std::string MadeMotion(Asked &ask, bmr_error error, bmr_motion *made) {
    if (error == BMR_OK) {
        Made(ask, made);
        bmr_motion_destroy(made);
    }
    return ask.Says(error);
}

} // namespace

TEST_CASE("boomerang/motion.h") {
    Row("bmr_motion_create", [](Asked &ask) {
        const bmr_pose pose = {
            {ask.Number("x", 1, kFinite), 0},
            ask.Number("cosine", 1, kFinite + OutOfRange({2, 0, 1 + 1e-8}) + Gives(kOk, {1 + 1e-10})),
            ask.Number("sine", 0, kFinite)};
        bmr_motion_piece piece =
            bmr_piece_screw(ask.Number("origin", 1, kFinite), pose, {0.5, ask.Number("velocity", 1, kFinite)},
                            ask.Number("spin", 1, kFinite));
        const int kind = ask.Or<int>("kind", piece.kind, {{2, BMR_ERROR_OUT_OF_RANGE}});
        static_assert(sizeof piece.kind == sizeof kind, "an enumeration is an int");
        std::memcpy(&piece.kind, &kind, sizeof kind); // C++ has no such value
        bmr_motion *made = nullptr;
        const bmr_error error =
            bmr_motion_create(ask.NotNull("piece", &piece), ask.Allocator(), ask.Result("result", &made));
        return MadeMotion(ask, error, made);
    });
    Row("bmr_motion_create of an algebraic piece", [](Asked &ask) {
        bmr_motion_piece piece = {};
        piece.kind = BMR_PIECE_ALGEBRAIC;
        piece.as.algebraic.degree = Count(ask.Number("degree", 1, OutOfRange({9, kSizeMax})));
        piece.as.algebraic.rotation_degree =
            Count(ask.Number("degree of the rotation", 0, OutOfRange({9, kSizeMax})));
        piece.as.algebraic.x[1] = ask.Number("coefficient", 1, kFinite);
        piece.as.algebraic.a[0] = ask.Number("a, where b is 0", 1, kFinite + OutOfRange({0}));
        piece.as.algebraic.start_c =
            ask.Number("cosine", 1, kFinite + OutOfRange({1 + 1e-8}) + Gives(kOk, {1 + 1e-10}));
        bmr_motion *made = nullptr;
        const bmr_error error = bmr_motion_create(&piece, nullptr, ask.Watched(&made));
        return MadeMotion(ask, error, made);
    });
    Row("bmr_motion_create_sampled", [](Asked &ask) {
        const double time = ask.Number("time", 1, kFinite + OutOfRange({0, -1, 2, 1e-38}));
        const double times[] = {0, time, 2, 3, 4};
        bmr_pose poses[5];
        for (int i = 0; i < 5; ++i)
            poses[i] = {{1.0 * i * i, 0.0}, 0.8, 0.6};
        // As far as a double reaches in next to no time.
        poses[1].position.x = time == 1e-38 ? 1e308 : ask.Number("x", 1, kFinite);
        poses[1].c = ask.Number("cosine", 0.8, kFinite + OutOfRange({2}));
        bmr_motion *made = nullptr;
        const double count = ask.Number("count", 5, Gives(BMR_ERROR_NO_POINTS, {0}));
        const bmr_error error = bmr_motion_create_sampled(ask.NotNull("times", &times[0]), poses,
                                                          Count(count), ask.Allocator(), ask.Watched(&made));
        return MadeMotion(ask, error, made);
    });
    // A motion that is not changed is as it was, and can be changed once there is memory.
    Row("bmr_motion_change", [](Asked &ask) {
        const bmr_motion_piece piece = bmr_piece_screw(0.0, kSlanted, {-1.0, 0.1}, 0.3);
        bmr_motion *made = nullptr;
        bmr_error error = bmr_motion_create(&piece, ask.Allocator(), &made);
        for (int i = 0; i < (ask.IsForMemory() ? 20 : 1) && error == BMR_OK; ++i) {
            const bmr_motion_piece change = bmr_piece_screw(i, kSlanted, {1.0 * i, 1.0}, 0.0);
            const double time = ask.IsForMemory() ? i : ask.Number("time", 0, kFinite + Gives(kOk, {1e308}));
            const std::string before = PosesOf(made);
            error = bmr_motion_change(ask.NotNull("motion", made), time, ask.NotNull("piece", &change));
            if (error != BMR_OK && (PosesOf(made) != before || bmr_motion_change(made, i, &change) != BMR_OK))
                error = BMR_ERROR_COUNT;
        }
        if (made != nullptr && error == BMR_OK)
            Made(ask, made);
        bmr_motion_destroy(made);
        return ask.Says(error);
    });
    Row(
        "bmr_motion_pose",
        [](Asked &ask) {
            const double time =
                ask.Number("time", 1, Gives("NaN", {kNaN}) + Gives("minus infinity", {kInfinity}));
            return Word(bmr_motion_pose(ThePair().comes, time, nullptr, nullptr).position.x);
        },
        "finite");
    Row(
        "bmr_motion_piece_speed",
        [](Asked &ask) {
            bmr_motion_piece piece = {};
            piece.kind = BMR_PIECE_ALGEBRAIC;
            piece.as.algebraic.degree = Count(ask.Number("degree", 1, Gives("infinite", {9, kSizeMax})));
            piece.as.algebraic.rotation_degree =
                Count(ask.Number("degree of the rotation", 0, Gives("infinite", {9, kSizeMax})));
            piece.as.algebraic.a[0] = 1.0;
            return Word(bmr_motion_piece_speed(&piece, 0.0, 1.0, 1.0));
        },
        "finite");
}

TEST_CASE("boomerang/failure.h, boomerang/time_of_contact.h") {
    Row(
        "bmr_failure_time",
        [](Asked &ask) {
            bmr_condition condition = bmr_condition_beyond(0, {ask.Number("normal", 1, kFinite), 0},
                                                           ask.Number("offset", 5, kFinite), {0, 0}, 0);
            condition.kind = ask.Or("kind of condition", condition.kind,
                                    {{BMR_CONDITION_KIND_COUNT, BMR_ERROR_OUT_OF_RANGE}});
            condition.owner = ask.Or<uint8_t>("owner", 0, {{2, BMR_ERROR_OUT_OF_RANGE}});
            bmr_failure_options options = bmr_default_failure_options();
            options.tolerance =
                ask.Number("tolerance", 1e-12, kAboveZero + Gives(BMR_ERROR_NOT_FINITE, {kNaN}));
            const double after = ask.Number("after", 0, kFinite + OutOfRange({101})),
                         until = ask.Number("until", 100, kFinite + Gives("a time", {1e308}));
            double time = -77.0;
            const bmr_error error = bmr_failure_time(
                ask.NotNull("condition", &condition), ask.NotNull("motion of A", ThePair().rest),
                ask.NotNull("motion of B", ThePair().comes), after, until, ask.NotNull("options", &options),
                ask.Result("result", &time));
            return error != BMR_OK ? ask.Says(error) : std::isinf(time) ? "never" : "a time";
        },
        "a time");
    Row("bmr_time_of_contact", [](Asked &ask) {
        const MovingPair &pair = ThePair();
        const bmr_shape a = {ask.NotNull("polygon of a", pair.polygon), {}, {}},
                        b = {ask.NotNull("polygon of b", pair.polygon), {}, {}};
        const double from = ask.Number("from", 0, kFinite + OutOfRange({21})),
                     until = ask.Number("until", 20, kFinite),
                     margin = ask.Number("margin", 1e-6, kNumber + kAboveZero);
        double time = -77.0;
        const bmr_error error = bmr_time_of_contact(&a, ask.NotNull("motion of a", pair.rest), &b,
                                                    ask.NotNull("motion of b", pair.comes), from, until,
                                                    margin, ask.Allocator(), ask.Result("result", &time));
        ask.Made(&time, sizeof time);
        return ask.Says(error);
    });
}

// --- simulations ---

namespace {

/// What a simulation says at time 1; and it goes on as before.
std::string Running(Asked &ask, const std::function<bmr_error(bmr_simulation *)> &call) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = test_structure("free-fd2");
    const bmr_shape shapes[] = {ThePair().Shape(), ThePair().Shape()};
    bmr_motion *const motions[] = {ThePair().rest, ThePair().comes};
    bmr_simulation *made = nullptr;
    if (bmr_simulation_create(&def, shapes, motions, 0.0, nullptr, nullptr, nullptr, &made) != BMR_OK ||
        bmr_simulation_run(made, 1.0) != BMR_OK)
        return "does not run";
    std::string answer = ask.Says(call(ask.NotNull("simulation", made)));
    if (bmr_simulation_run(made, std::fmax(2.0, bmr_simulation_time(made))) != BMR_OK ||
        bmr_simulation_audit(made) != BMR_OK)
        answer += ", and it runs no more";
    bmr_simulation_destroy(made);
    return answer;
}

} // namespace

TEST_CASE("boomerang/simulation.h") {
    static const Rules positive = kAboveZero + OutOfRange({kNaN});
    Row("bmr_simulation_create", [](Asked &ask) {
        const MovingPair &pair = ThePair();
        bmr_simulation_def def = bmr_default_simulation_def();
        def.structure = ask.NotNull("structure", test_structure("free-fd2"));
        def.contact_step = ask.Number("contact step", def.contact_step, positive);
        def.failure.tolerance = ask.Number("tolerance", def.failure.tolerance, positive);
        def.kds.margin = ask.Number("margin", def.kds.margin, kNumber + kAboveZero);
        const bmr_shape shapes[] = {pair.Shape(), pair.Shape()};
        bmr_motion *const motions[] = {pair.rest, ask.NotNull("motion", pair.comes)};
        const double time = ask.Number("time", 0, kFinite);
        bmr_simulation *made = nullptr;
        const bmr_error error = bmr_simulation_create(&def, shapes, motions, time, nullptr, nullptr,
                                                      ask.Allocator(), ask.Result("result", &made));
        if (error != BMR_OK)
            return ask.Says(error);
        const bmr_error ran = bmr_simulation_run(made, 20.0); // it has all the memory that it needs
        const bmr_simulation_counts counts = bmr_simulation_get_counts(made);
        ask.Made(&counts, sizeof counts);
        bmr_simulation_destroy(made);
        return ran == BMR_OK ? kOk.text : "does not run";
    });
    Row("bmr_simulation_run", [](Asked &ask) {
        return Running(ask, [&ask](bmr_simulation *s) {
            return bmr_simulation_run(s, ask.Number("until", 1,
                                                    kFinite + OutOfRange({0.5}) + Gives(kOk, {1e9}) +
                                                        Gives(BMR_ERROR_NOT_FINITE, {1e308})));
        });
    });
    Row("bmr_simulation_replan", [](Asked &ask) { return Running(ask, bmr_simulation_replan); });
    Row("bmr_simulation_audit", [](Asked &ask) {
        bmr_simulation_destroy(nullptr);
        return Running(ask, bmr_simulation_audit);
    });
}

// --- worlds ---

namespace {

bmr_error OpenWorld(const bmr_allocator *allocator, bmr_world **made) {
    bmr_world_def def = bmr_default_world_def();
    def.structure = test_structure("free-fd2");
    def.boundary = BMR_WALLED;
    def.low = {-30.0, -30.0};
    def.high = {30.0, 30.0};
    return bmr_world_create(&def, 0.0, allocator, made);
}

/// A walled world of one body, id 0, at time 1; what it says, and that it is as good as before.
std::string InWorld(Asked &ask, const std::function<bmr_error(bmr_world *)> &call) {
    const bmr_shape shape = ThePair().Shape();
    bmr_world *world = nullptr;
    bmr_body body = BMR_NO_BODY;
    const bmr_body_def def = bmr_default_body_def(&shape, ThePair().rest);
    if (OpenWorld(nullptr, &world) != BMR_OK || bmr_world_add(world, &def, &body) != BMR_OK ||
        bmr_world_advance(world, 1.0) != BMR_OK)
        return "does not run";
    const bmr_error error = call(ask.NotNull("world", world));
    const bool good = (error == BMR_OK || bmr_world_get_counts(world).bodies == 1) &&
                      bmr_world_advance(world, 2.0) == BMR_OK && bmr_world_audit(world) == BMR_OK;
    bmr_world_destroy(world);
    return ask.Says(error) + (good ? "" : ", and it is not as before");
}

/// The body, or one that there is not: the second, which has not been added; a wall; none.
bmr_body BodyOf(Asked &ask) {
    return ask.Or<bmr_body>("another body", 0,
                            {{1, BMR_ERROR_OUT_OF_RANGE},
                             {BMR_WALL(0), BMR_ERROR_OUT_OF_RANGE},
                             {BMR_NO_BODY, BMR_ERROR_OUT_OF_RANGE}});
}

/// A world of three bodies, of which one jumps, and of some that come and go, with memory that fails: each
/// call that does changes nothing, and can be made once there is some.
std::string LiveInTightWorld(Asked &ask) {
    bmr_world *world = nullptr;
    bmr_error answer = OpenWorld(ask.Allocator(), &world);
    if (answer != BMR_OK)
        return ask.Says(answer);
    const auto attempt = [&](const std::function<bmr_error()> &call, const std::function<bool()> &same) {
        const bmr_error error = call();
        if (error == BMR_OK)
            return;
        answer = error;
        if (!same() || bmr_world_audit(world) != BMR_OK || call() != BMR_OK)
            answer = BMR_ERROR_COUNT;
    };
    const bmr_shape shape = ThePair().Shape();
    size_t count = 0;
    for (bmr_motion *motion : {ThePair().comes, ThePair().rest, ThePair().other}) {
        const bmr_body_def def = bmr_default_body_def(&shape, motion);
        bmr_body body = 77;
        attempt([&] { return bmr_world_add(world, &def, &body); },
                [&] { return body == 77 && bmr_world_get_counts(world).bodies == count; });
        ++count;
    }
    for (int i = 0; i < 9; ++i) {
        const bmr_motion_piece aside = bmr_piece_rest({{25.0, 6.0 * i - 24.0}, 1, 0});
        bmr_motion *rests = nullptr;
        bmr_motion_create(&aside, nullptr, &rests);
        const bmr_body_def def = bmr_default_body_def(&shape, rests);
        bmr_body body = 77;
        attempt([&] { return bmr_world_add(world, &def, &body); },
                [&] { return body == 77 && bmr_world_get_counts(world).bodies == count; });
        bmr_motion_destroy(rests);
        ++count;
    }
    for (; count > 5; --count)
        attempt([&] { return bmr_world_remove(world, count - 1); },
                [&] { return bmr_world_get_counts(world).bodies == count; });
    // A motion that jumps at once, and again later.
    const bmr_motion_piece there = bmr_piece_rest({{20, 0}, 1, 0}), back = bmr_piece_rest({{-20, 0}, 1, 0});
    bmr_motion *plan = nullptr;
    bmr_motion_create(&there, nullptr, &plan);
    bmr_motion_change(plan, 1.0, &back);
    attempt([&] { return bmr_world_set_motion(world, 1, plan); },
            [&] {
                bmr_body_state state;
                return bmr_world_get(world, 1, &state) == BMR_OK && state.pose.position.x == 0.0;
            });
    bmr_motion_destroy(plan);
    attempt([&] { return bmr_world_advance(world, 30.0); }, [] { return true; });
    const bmr_world_totals totals = bmr_world_get_totals(world);
    const bmr_world_counts counts = bmr_world_get_counts(world);
    ask.Made(&totals, sizeof totals);
    ask.Made(counts.events, sizeof counts.events);
    if (bmr_world_audit(world) != BMR_OK)
        answer = BMR_ERROR_COUNT;
    bmr_world_destroy(world);
    return ask.Says(answer);
}

} // namespace

TEST_CASE("boomerang/world.h") {
    static const Rules positive = kAboveZero + Gives(BMR_ERROR_NOT_FINITE, {kNaN});
    Row("bmr_world_create", [](Asked &ask) {
        bmr_world_def def = bmr_default_world_def();
        const bmr_kds_info *info = ask.Or("a structure for points", test_structure("free-fd2"),
                                          {{test_structure("point-lazy-dudley"), BMR_ERROR_OUT_OF_RANGE}});
        def.structure = ask.NotNull("structure", info);
        def.kds.margin = ask.Number("margin", def.kds.margin, kFinite + kAboveZero);
        def.response.restitution = ask.Number("restitution", 1, kNotBelowZero + OutOfRange({2}));
        const double period = ask.Number("period", 10, kFinite + kAboveZero + Gives(kOk, {20}));
        def.boundary = period != 10.0 ? BMR_PERIODIC : BMR_WALLED;
        def.high = {period != 10.0 ? period : ask.Number("width between walls", 10, kFinite + kAboveZero),
                    10.0};
        const double time = ask.Number("time", 0, kFinite);
        bmr_world *made = nullptr;
        const bmr_error error = bmr_world_create(&def, time, ask.Allocator(), ask.Result("result", &made));
        if (error == BMR_OK) {
            const size_t bodies = bmr_world_get_counts(made).bodies;
            ask.Made(&bodies, sizeof bodies);
            bmr_world_destroy(made);
        }
        return ask.Says(error);
    });
    Row("bmr_world_add of a bad body", [](Asked &ask) {
        return InWorld(ask, [&ask](bmr_world *world) {
            const bmr_shape shape = ThePair().Shape();
            bmr_body_def body =
                bmr_default_body_def(ask.NotNull("shape", &shape), ask.NotNull("motion", ThePair().comes));
            body.mass = ask.Number("mass", 1, positive);
            body.inertia = ask.Number("inertia", 1, positive);
            bmr_body added = 77;
            return bmr_world_add(world, &body, &added);
        });
    });
    Row("bmr_world_add, bmr_world_set_motion, bmr_world_advance", LiveInTightWorld);
    Row("bmr_world_remove", [](Asked &ask) {
        return InWorld(ask, [&](bmr_world *world) { return bmr_world_remove(world, BodyOf(ask)); });
    });
    Row("bmr_world_set_motion of a bad motion", [](Asked &ask) {
        return InWorld(ask, [&](bmr_world *world) {
            return bmr_world_set_motion(world, BodyOf(ask), ask.NotNull("motion", ThePair().comes));
        });
    });
    Row("bmr_world_set_piece", [](Asked &ask) {
        return InWorld(ask, [&](bmr_world *world) {
            const bmr_motion_piece piece =
                bmr_piece_rest({{ask.Number("x of the piece", 1, kFinite), 0}, 1, 0});
            return bmr_world_set_piece(world, BodyOf(ask), ask.NotNull("piece", &piece));
        });
    });
    Row("bmr_world_advance to a bad time", [](Asked &ask) {
        return InWorld(ask, [&](bmr_world *world) {
            return bmr_world_advance(world, ask.Number("until", 1, kFinite + OutOfRange({0.5})));
        });
    });
    Row("bmr_world_get", [](Asked &ask) {
        bmr_body_state state = {};
        return InWorld(ask, [&](bmr_world *world) {
            return bmr_world_get(world, BodyOf(ask), ask.Result("result", &state));
        });
    });
    Row("bmr_world_audit", [](Asked &ask) { return InWorld(ask, bmr_world_audit); });
}

// --- analysis and families ---

TEST_CASE("boomerang/analysis.h") {
    Row("bmr_run_course", [](Asked &ask) {
        bmr_run_def def = {};
        def.structure = test_structure("free-fd2");
        def.shapes[0] = def.shapes[1] = ThePair().Shape();
        def.simulation = bmr_default_simulation_def();
        const bmr_course course = ThePair().Course();
        bmr_run run;
        std::memset(&run, 0x77, sizeof run);
        const bmr_error error = bmr_run_course(ask.NotNull("def", &def), ask.NotNull("course", &course), 2.0,
                                               ask.Allocator(), ask.Result("result", &run));
        if (error == BMR_OK) {
            ask.Made(&run.counts, sizeof run.counts);
            ask.Made(&run.events, sizeof run.events);
        }
        return ask.Says(error);
    });
    Row("bmr_offline_optimum", [](Asked &ask) {
        const bmr_course course =
            ThePair().Course(ask.Number("from", 0, kNumber + OutOfRange({6})), ask.Number("to", 5, kNumber));
        const double margin = ask.Number("margin", 1e-6,
                                         kAboveZero + OutOfRange({kNaN}) + Gives(kOk, {kInfinity})),
                     resolution = ask.Number("resolution", 0.02, kNumber + kAboveZero + OutOfRange({1}));
        bmr_optimum optimum = {77, 0, 0, 0};
        return ask.Says(bmr_offline_optimum(ask.NotNull("course", &course), margin, resolution, nullptr, 0,
                                            ask.Result("result", &optimum)));
    });
    Row("bmr_clear_decomposition", [](Asked &ask) {
        const bmr_course course = ThePair().Course();
        const double kappa = ask.Number("kappa", 2, kNumber + OutOfRange({1, 0})),
                     diameter = ask.Number("diameter", 1, kNumber + kNotBelowZero);
        bmr_clear clear = {77, 0, 0};
        return ask.Says(bmr_clear_decomposition(ask.NotNull("course", &course), kappa, diameter,
                                                ask.Result("result", &clear)));
    });
    Row("bmr_fit_growth", [](Asked &ask) {
        std::vector<double> x(100000, 1.0), y(100000, 1.0);
        x[1] = ask.Number("second x", 2, kFinite + kAboveZero + OutOfRange({1}));
        y[1] = ask.Number("second y", 2, kFinite + kNotBelowZero);
        const double count = ask.Number("count", 2, OutOfRange({0, 1, 257, 100000}));
        bmr_growth growth = {};
        growth.count = 77;
        return ask.Says(bmr_fit_growth(ask.NotNull("x", x.data()), ask.NotNull("y", y.data()), Count(count),
                                       ask.Result("result", &growth)));
    });
}

TEST_CASE("boomerang/families.h") {
    for (int family = 0; family < BMR_FAMILY_COUNT; ++family)
        Row("bmr_family_create", [family](Asked &ask) {
            const CountGsl here(ask.Allocator());
            const bmr_polygon *polygon = ThePair().polygon;
            const auto kind =
                ask.Or("a family", bmr_family(family), {{BMR_FAMILY_COUNT, BMR_ERROR_OUT_OF_RANGE}});
            // A zigzag reads all of them.
            const bool all = family == BMR_FAMILY_ZIGZAG;
            const double ratio = ask.Number("ratio", 4,
                                            all ? kNumber + kAboveZero + OutOfRange({0.5, 1e38}) : Rules()),
                         legs = ask.Number("legs of a zigzag", 16, all ? OutOfRange({7}) : Rules());
            const bmr_family_def def = {kind, ratio, 1, static_cast<unsigned>(legs), 0};
            bmr_family_motion made;
            std::memset(&made, 0x77, sizeof made);
            const bmr_error error =
                bmr_family_create(ask.NotNull("def", &def), ask.NotNull("a", polygon),
                                  ask.NotNull("b", polygon), ask.Allocator(), ask.Result("result", &made));
            if (error == BMR_OK) {
                Made(ask, made.motions[0]);
                Made(ask, made.motions[1]);
                bmr_family_destroy(&made);
            }
            return ask.Says(error);
        });
    Row("bmr_least_distance", [](Asked &ask) {
        const MovingPair &pair = ThePair();
        const double from = ask.Number("from", 0, kNumber + OutOfRange({2})),
                     to = ask.Number("to", 1, kNumber),
                     tolerance = ask.Number("tolerance", 0.1,
                                            kAboveZero + OutOfRange({kNaN}) + Gives(kOk, {kInfinity}));
        double distance = -77.0, time;
        return ask.Says(bmr_least_distance(ask.NotNull("a", pair.polygon), pair.polygon, pair.rest,
                                           ask.NotNull("motion of B", pair.comes), from, to, tolerance,
                                           ask.Result("result", &distance), &time));
    });
    Row("bmr_ngon_points", [](Asked &ask) {
        std::vector<bmr_vec2> points(65536);
        const CountGsl here(ask.Allocator());
        for (int ngon = 0; ngon < (ask.IsForMemory() ? BMR_NGON_COUNT : 1); ++ngon) {
            const auto kind = ask.Or("a kind of polygon", ask.IsForMemory() ? bmr_ngon(ngon) : BMR_NGON_LENS,
                                     {{BMR_NGON_COUNT, BMR_ERROR_OUT_OF_RANGE}});
            const size_t count = Count(ask.Number("points", 12, OutOfRange({2, 65536})));
            points[0] = {77.0, 77.0};
            const bmr_error error =
                bmr_ngon_points(kind, count, 7, ask.Result("place of the points", points.data()));
            if (error != BMR_OK)
                return ask.Says(error);
            ask.Made(points.data(), count * sizeof points[0]);
        }
        return kOk.text;
    });
    CHECK(bmr_family_name(BMR_FAMILY_COUNT) == nullptr);
    CHECK(bmr_ngon_name(BMR_NGON_COUNT) == nullptr);
}
