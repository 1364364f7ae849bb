// SPDX-License-Identifier: MIT
// Simulations, worlds, analysis. What refuses a call goes on as before.
#include <cstring>

#include <gsl/gsl_rng.h>

#include "boomerang/analysis.h"
#include "boomerang/simulation.h"
#include "boomerang/world.h"
#include "failing_allocator.h"
#include "moving_stage.h"
#include "structure_named.h"

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
    explicit CountGsl(const Given &g) {
        counting = g.allocator != nullptr ? static_cast<test_heap *>(g.allocator->context) : nullptr;
    }
    ~CountGsl() { counting = nullptr; }
};

bmr_shape TheShape() {
    return {ThePair().polygon, {}, {}};
}

std::string CreateSimulation(const Given &g) {
    const MovingPair &pair = ThePair();
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = g.Or(0, test_structure("free-fd2"));
    def.contact_step = g[3];
    def.failure.tolerance = g[4];
    def.kds.margin = g[5];
    const bmr_shape shapes[] = {TheShape(), TheShape(), TheShape()};
    bmr_motion *const motions[] = {pair.rest, pair.comes, pair.other};
    bmr_simulation *made = nullptr;
    const bmr_error error = bmr_simulation_create(&def, shapes, motions, g.Count(1), g[2], nullptr, nullptr,
                                                  g.allocator, g.Or(6, &made));
    if (error != BMR_OK)
        return Said(error, made != nullptr);
    bmr_error ran = bmr_simulation_run(made, 20.0); // it has all the memory that it needs
    const bmr_simulation_counts counts = bmr_simulation_get_counts(made);
    g.Made(&counts, sizeof counts);
    bmr_simulation_destroy(made);
    return Said(ran == BMR_OK ? BMR_OK : BMR_ERROR_COUNT);
}

/// What a simulation says at time 1; and it goes on as before.
std::string Running(const std::function<bmr_error(bmr_simulation *)> &ask) {
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = test_structure("free-fd2");
    const bmr_shape shapes[] = {TheShape(), TheShape()};
    bmr_motion *const motions[] = {ThePair().rest, ThePair().comes};
    bmr_simulation *made = nullptr;
    if (bmr_simulation_create(&def, shapes, motions, 2, 0.0, nullptr, nullptr, nullptr, &made) != BMR_OK ||
        bmr_simulation_run(made, 1.0) != BMR_OK)
        return "does not run";
    std::string answer = Said(ask(made));
    if (bmr_simulation_run(made, std::fmax(2.0, bmr_simulation_time(made))) != BMR_OK ||
        bmr_simulation_audit(made) != BMR_OK)
        answer += ", and it runs no more";
    bmr_simulation_destroy(made);
    return answer;
}

const Table kSimulations("boomerang/simulation.h", [] {
    const bmr_simulation_def def = bmr_default_simulation_def();
    Makes("bmr_simulation_create",
          {{"structure", kNotNull},
           {"bodies", 3, Says("OUT_OF_RANGE", {0, 1})},
           {"time", 0, kFinite},
           {"contact step", def.contact_step, kAboveZero + Says("OUT_OF_RANGE", {kNaN})},
           {"tolerance", def.failure.tolerance, kAboveZero + Says("OUT_OF_RANGE", {kNaN})},
           {"margin", def.kds.margin, kNumber + kAboveZero},
           {"result", kNotNull}},
          CreateSimulation);
    Refuses("bmr_simulation_run",
            {{"simulation", kNotNull},
             {"until", 1,
              kFinite + Says("OUT_OF_RANGE", {0.5}) + Says("OK", {1e9}) + Says("NOT_FINITE", {1e308})}},
            [](const Given &g) {
                return Running([&](bmr_simulation *s) { return bmr_simulation_run(g.Or(0, s), g[1]); });
            });
    Refuses("bmr_simulation_replan",
            {{"simulation", kNotNull}, {"body", Says("OUT_OF_RANGE", {2, kSizeMax})}}, [](const Given &g) {
                return Running(
                    [&](bmr_simulation *s) { return bmr_simulation_replan(g.Or(0, s), g.Count(1)); });
            });
    Refuses("bmr_simulation_audit, bmr_simulation_destroy", {{"simulation", kNotNull}}, [](const Given &g) {
        bmr_simulation_destroy(nullptr);
        return Running([&](bmr_simulation *s) { return bmr_simulation_audit(g.Or(0, s)); });
    });
});

// --- worlds ---

bmr_error OpenWorld(const bmr_allocator *allocator, bmr_world **made) {
    bmr_world_def def = bmr_default_world_def();
    def.structure = test_structure("free-fd2");
    def.boundary = BMR_WALLED;
    def.low = {-30.0, -30.0};
    def.high = {30.0, 30.0};
    return bmr_world_create(&def, 0.0, allocator, made);
}

std::string CreateWorld(const Given &g) {
    bmr_world_def def = bmr_default_world_def();
    def.structure = g.Or(0, test_structure(g[0] == 2.0 ? "point-lazy-dudley" : "free-fd2"));
    def.kds.margin = g[2];
    def.response.restitution = g[3];
    def.boundary = g[5] != 10.0 ? BMR_PERIODIC : BMR_WALLED;
    def.high = {g[5] != 10.0 ? g[5] : g[4], 10.0};
    bmr_world *made = nullptr;
    const bmr_error error = bmr_world_create(&def, g[1], g.allocator, g.Or(6, &made));
    if (error == BMR_OK) {
        const size_t bodies = bmr_world_body_count(made);
        g.Made(&bodies, sizeof bodies);
        bmr_world_destroy(made);
        made = nullptr;
    }
    return Said(error, made != nullptr);
}

/// A walled world of one body, id 0, at time 1; what it says, and that it is as good as before.
std::string InWorld(const Given &g, const std::function<bmr_error(bmr_world *)> &ask) {
    const bmr_shape shape = TheShape();
    bmr_world *world = nullptr;
    bmr_body body = BMR_NO_BODY;
    const bmr_body_def def = bmr_default_body_def(&shape, ThePair().rest);
    if (OpenWorld(nullptr, &world) != BMR_OK || bmr_world_add(world, &def, &body) != BMR_OK ||
        bmr_world_advance(world, 1.0) != BMR_OK)
        return "does not run";
    const bmr_error error = ask(g.Or(0, world));
    const bool good = (error == BMR_OK || bmr_world_body_count(world) == 1) &&
                      bmr_world_advance(world, 2.0) == BMR_OK && bmr_world_audit(world) == BMR_OK;
    bmr_world_destroy(world);
    return Said(error) + (good ? "" : ", and it is not as before");
}

/// A world of three bodies with memory that fails: each call that does changes nothing, and can be made once
/// there is some.
class TightWorld {
public:
    explicit TightWorld(const Given &g) : m_given(g), m_error(OpenWorld(g.allocator, &m_world)) {}
    /// `same` says that nothing has changed.
    void Try(const std::function<bmr_error(bmr_world *)> &call,
             const std::function<bool(bmr_world *)> &same) {
        if (m_world == nullptr)
            return;
        const bmr_error error = call(m_world);
        if (error == BMR_OK)
            return;
        m_error = error;
        if (!same(m_world) || bmr_world_audit(m_world) != BMR_OK || call(m_world) != BMR_OK)
            m_error = BMR_ERROR_COUNT;
    }
    void AddBodies() {
        const bmr_shape shape = TheShape();
        size_t count = 0;
        for (bmr_motion *motion : {ThePair().comes, ThePair().rest, ThePair().other}) {
            const bmr_body_def def = bmr_default_body_def(&shape, motion);
            bmr_body body = 77;
            Try([&](bmr_world *world) { return bmr_world_add(world, &def, &body); },
                [&](bmr_world *world) { return body == 77 && bmr_world_body_count(world) == count; });
            ++count;
        }
    }
    std::string Close() {
        if (m_world == nullptr)
            return Said(m_error);
        const bmr_world_totals totals = bmr_world_get_totals(m_world);
        const bmr_world_counts counts = bmr_world_get_counts(m_world);
        m_given.Made(&totals, sizeof totals);
        m_given.Made(counts.events, sizeof counts.events);
        if (bmr_world_audit(m_world) != BMR_OK)
            m_error = BMR_ERROR_COUNT;
        bmr_world_destroy(m_world);
        return Said(m_error);
    }

private:
    const Given &m_given;
    bmr_world *m_world = nullptr;
    bmr_error m_error;
};

std::string AddTightly(const Given &g) {
    TightWorld world(g);
    world.AddBodies();
    return world.Close();
}

std::string AdvanceTightly(const Given &g) {
    TightWorld world(g);
    world.AddBodies();
    world.Try([](bmr_world *w) { return bmr_world_advance(w, 30.0); }, [](bmr_world *) { return true; });
    return world.Close();
}

/// A motion that jumps at once, and again later.
std::string SetMotionTightly(const Given &g) {
    TightWorld world(g);
    world.AddBodies();
    const bmr_motion_piece there = bmr_piece_rest({{20, 0}, 1, 0}), back = bmr_piece_rest({{-20, 0}, 1, 0});
    bmr_motion *plan = nullptr;
    bmr_motion_create(&there, nullptr, &plan);
    bmr_motion_change(plan, 1.0, &back);
    world.Try([&](bmr_world *w) { return bmr_world_set_motion(w, 1, plan); },
              [](bmr_world *w) {
                  bmr_body_state state;
                  return bmr_world_get(w, 1, &state) == BMR_OK && state.pose.position.x == 0.0;
              });
    bmr_motion_destroy(plan);
    return world.Close();
}

/// The bodies that there are not: the second, which has not been added; a wall; none.
const Rules kNoBody = Says("OUT_OF_RANGE", {1, {"a wall", 2}, {"`BMR_NO_BODY`", 3}});
bmr_body BodyOf(double value) {
    return value == 3.0 ? BMR_NO_BODY : value == 2.0 ? BMR_WALL(0) : static_cast<bmr_body>(value);
}

const Table kWorlds("boomerang/world.h", [] {
    const bmr_world_def def = bmr_default_world_def();
    Makes("bmr_world_create",
          {{"structure", kNotNull + Says("OUT_OF_RANGE", {{"for points", 2}})},
           {"time", 0, kFinite},
           {"margin", def.kds.margin, kFinite + kAboveZero},
           {"restitution", kNotBelowZero + Says("OUT_OF_RANGE", {2})},
           {"width between walls", 10, kFinite + kAboveZero},
           {"period", 10, kFinite + kAboveZero + Says("OK", {20})},
           {"result", kNotNull}},
          CreateWorld);
    Refuses("bmr_world_add",
            {{"world", kNotNull},
             {"motion", kNotNull},
             {"mass", 1, kAboveZero + Says("NOT_FINITE", {kNaN})},
             {"inertia", 1, kAboveZero + Says("NOT_FINITE", {kNaN})},
             {"shape", kNotNull}},
            [](const Given &g) {
                return InWorld(g, [&](bmr_world *world) {
                    const bmr_shape shape = TheShape();
                    bmr_body_def body = bmr_default_body_def(g.Or(4, &shape), g.Or(1, ThePair().comes));
                    body.mass = g[2];
                    body.inertia = g[3];
                    bmr_body added;
                    return bmr_world_add(world, &body, &added);
                });
            });
    Allocates("bmr_world_add", AddTightly);
    Refuses("bmr_world_remove", {{"world", kNotNull}, {"body", 0, kNoBody}}, [](const Given &g) {
        return InWorld(g, [&](bmr_world *world) { return bmr_world_remove(world, BodyOf(g[1])); });
    });
    Refuses("bmr_world_set_motion", {{"world", kNotNull}, {"body", 0, kNoBody}, {"motion", kNotNull}},
            [](const Given &g) {
                return InWorld(g, [&](bmr_world *world) {
                    return bmr_world_set_motion(world, BodyOf(g[1]), g.Or(2, ThePair().comes));
                });
            });
    Allocates("bmr_world_set_motion", SetMotionTightly);
    Refuses("bmr_world_set_piece",
            {{"world", kNotNull}, {"body", 0, kNoBody}, {"piece", kNotNull}, {"x of the piece", kFinite}},
            [](const Given &g) {
                return InWorld(g, [&](bmr_world *world) {
                    const bmr_motion_piece piece = bmr_piece_rest({{g[3], 0}, 1, 0});
                    return bmr_world_set_piece(world, BodyOf(g[1]), g.Or(2, &piece));
                });
            });
    Refuses("bmr_world_advance", {{"world", kNotNull}, {"until", 1, kFinite + Says("OUT_OF_RANGE", {0.5})}},
            [](const Given &g) {
                return InWorld(g, [&](bmr_world *world) { return bmr_world_advance(world, g[1]); });
            });
    Allocates("bmr_world_advance", AdvanceTightly);
    Refuses("bmr_world_get", {{"world", kNotNull}, {"body", 0, kNoBody}, {"result", kNotNull}},
            [](const Given &g) {
                return InWorld(g, [&](bmr_world *world) {
                    bmr_body_state state;
                    return bmr_world_get(world, BodyOf(g[1]), g.Or(2, &state));
                });
            });
    Refuses("bmr_world_audit", {{"world", kNotNull}}, [](const Given &g) {
        return InWorld(g, [](bmr_world *world) { return bmr_world_audit(world); });
    });
});

// --- analysis and families ---

std::string RunCourse(const Given &g) {
    bmr_run_def def = {};
    def.structure = test_structure("free-fd2");
    def.shapes[0] = def.shapes[1] = TheShape();
    def.simulation = bmr_default_simulation_def();
    const MovingPair &pair = ThePair();
    const bmr_course course = {{pair.polygon, pair.polygon}, {pair.rest, pair.comes}, 0.0, 5.0};
    bmr_run run;
    std::memset(&run, 0x77, sizeof run);
    const bmr_run untouched = run;
    const bmr_error error = bmr_run_course(g.Or(0, &def), g.Or(1, &course), 2.0, g.allocator, g.Or(2, &run));
    if (error != BMR_OK)
        return Said(error, std::memcmp(&run, &untouched, sizeof run) != 0);
    g.Made(&run.counts, sizeof run.counts);
    g.Made(&run.events, sizeof run.events);
    return Said(error);
}

bmr_course Course(double from, double to) {
    const MovingPair &pair = ThePair();
    return {{pair.polygon, pair.polygon}, {pair.rest, pair.comes}, from, to};
}

std::string CreateAdversary(const Given &g) {
    for (int kind = 0; kind < (g.allocator != nullptr ? BMR_ADVERSARY_COUNT : 1); ++kind) {
        bmr_adversary made = {};
        const bmr_error error = bmr_adversary_create(static_cast<bmr_adversary_kind>(kind), g.Count(0), g[1],
                                                     g.allocator, g.Or(2, &made));
        if (error != BMR_OK)
            return Said(error, made.polygons[0] != nullptr || made.motions[0] != nullptr);
        for (int k = 0; k < 2; ++k) {
            HashMotion(g, made.motions[k]);
            g.Made(made.polygons[k]->vertices, made.polygons[k]->count * sizeof *made.polygons[k]->vertices);
        }
        bmr_adversary_destroy(&made, g.allocator);
    }
    return "OK";
}

std::string CreateFamily(const Given &g) {
    const CountGsl here(g);
    const bmr_polygon *polygon = ThePair().polygon;
    for (int family = 0; family < (g.allocator != nullptr ? BMR_FAMILY_COUNT : 1); ++family) {
        const bmr_family_def def = {static_cast<bmr_family>(g.allocator != nullptr ? family : g[0]), g[1], 1,
                                    static_cast<unsigned>(g[2]), 0};
        bmr_family_motion made;
        std::memset(&made, 0x77, sizeof made);
        const bmr_family_motion untouched = made;
        const bmr_error error =
            bmr_family_create(&def, g.Or(3, polygon), g.Or(4, polygon), g.allocator, g.Or(5, &made));
        if (error != BMR_OK)
            return Said(error, std::memcmp(&made, &untouched, sizeof made) != 0);
        HashMotion(g, made.motions[0]);
        HashMotion(g, made.motions[1]);
        bmr_family_destroy(&made);
    }
    return "OK";
}

std::string OutlinePoints(const Given &g) {
    const CountGsl here(g);
    for (int outline = 0; outline < (g.allocator != nullptr ? BMR_OUTLINE_COUNT : 1); ++outline) {
        std::vector<bmr_vec2> points(65536, {77.0, 77.0});
        const bmr_error error =
            bmr_outline_points(static_cast<bmr_outline>(g.allocator != nullptr ? outline : g[0]), g.Count(1),
                               7, g.Or(2, points.data()));
        if (error != BMR_OK)
            return Said(error, points[0].x != 77.0);
        g.Made(points.data(), g.Count(1) * sizeof points[0]);
    }
    return "OK";
}

const Table kAnalysis("boomerang/analysis.h", [] {
    Makes("bmr_run_course", {{"def", kNotNull}, {"course", kNotNull}, {"result", kNotNull}}, RunCourse);
    Refuses("bmr_offline_optimum",
            {{"course", kNotNull},
             {"result", kNotNull},
             {"margin", 1e-6, kAboveZero + Says("OUT_OF_RANGE", {kNaN}) + Says("OK", {kInfinity})},
             {"resolution", 0.02, kNumber + kAboveZero + Says("OUT_OF_RANGE", {1})},
             {"from", 0, kNumber + Says("OUT_OF_RANGE", {6})},
             {"to", 5, kNumber}},
            [](const Given &g) {
                const bmr_course course = Course(g[4], g[5]);
                bmr_optimum optimum = {77, 0, 0, 0};
                const bmr_error error =
                    bmr_offline_optimum(g.Or(0, &course), g[2], g[3], nullptr, 0, g.Or(1, &optimum));
                return Said(error, optimum.least != 77);
            });
    Refuses("bmr_clear_decomposition",
            {{"course", kNotNull},
             {"result", kNotNull},
             {"kappa", 2, kNumber + Says("OUT_OF_RANGE", {1, 0})},
             {"diameter", 1, kNumber + kNotBelowZero}},
            [](const Given &g) {
                const bmr_course course = Course(0.0, 5.0);
                bmr_clear clear = {77, 0, 0};
                const bmr_error error =
                    bmr_clear_decomposition(g.Or(0, &course), g[2], g[3], g.Or(1, &clear));
                return Said(error, clear.least != 77);
            });
    Refuses("bmr_fit_growth",
            {{"x", kNotNull},
             {"y", kNotNull},
             {"result", kNotNull},
             {"count", 2, Says("OUT_OF_RANGE", {0, 1, 257, 100000})},
             {"second x", 2, kFinite + kAboveZero + Says("OUT_OF_RANGE", {{"the same as the first", 1}})},
             {"second y", 2, kFinite + kNotBelowZero}},
            [](const Given &g) {
                std::vector<double> x(100000, 1.0), y(100000, 1.0);
                x[1] = g[4];
                y[1] = g[5];
                bmr_growth growth = {};
                growth.count = 77;
                const bmr_error error =
                    bmr_fit_growth(g.Or(0, x.data()), g.Or(1, y.data()), g.Count(3), g.Or(2, &growth));
                return Said(error, growth.count != 77);
            });
    Makes("bmr_adversary_create",
          {{"vertices", 12, Says("OUT_OF_RANGE", {2, 4097, kSizeMax})},
           {"separation", 0.1, kNumber + kAboveZero},
           {"result", kNotNull}},
          CreateAdversary);
});

const Table kFamilies("boomerang/families.h", [] {
    Makes("bmr_family_create",
          {{"family", BMR_FAMILY_ZIGZAG, Says("OUT_OF_RANGE", {{"none", BMR_FAMILY_COUNT}})},
           {"ratio", 4, kNumber + kAboveZero + Says("OUT_OF_RANGE", {0.5, 1e38})},
           {"legs of a zigzag", 16, Says("OUT_OF_RANGE", {7})},
           {"a", kNotNull},
           {"b", kNotNull},
           {"result", kNotNull}},
          CreateFamily);
    Refuses("bmr_least_distance",
            {{"a", kNotNull},
             {"result", kNotNull},
             {"from", 0, kNumber + Says("OUT_OF_RANGE", {2})},
             {"to", 1, kNumber},
             {"tolerance", 0.1, kAboveZero + Says("OUT_OF_RANGE", {kNaN}) + Says("OK", {kInfinity})}},
            [](const Given &g) {
                const MovingPair &pair = ThePair();
                double distance = -77.0, time;
                const bmr_error error =
                    bmr_least_distance(g.Or(0, pair.polygon), pair.polygon, pair.rest, pair.comes, g[2], g[3],
                                       g[4], g.Or(1, &distance), &time);
                return Said(error, distance != -77.0);
            });
    Makes("bmr_outline_points",
          {{"outline", BMR_OUTLINE_LENS, Says("OUT_OF_RANGE", {{"none", BMR_OUTLINE_COUNT}})},
           {"points", 12, Says("OUT_OF_RANGE", {2, 65536})},
           {"place of the points", kNotNull}},
          OutlinePoints);
    Answers("bmr_adversary_name, bmr_family_name, bmr_outline_name", "names",
            {{"kind", 0, Says("`NULL`", {{"none", 1}})}}, [](const Given &g) {
                const bool none = g[0] == 1.0;
                const char *const names[] = {
                    bmr_adversary_name(none ? BMR_ADVERSARY_COUNT : BMR_ADVERSARY_PASS),
                    bmr_family_name(none ? BMR_FAMILY_COUNT : BMR_FAMILY_LINE),
                    bmr_outline_name(none ? BMR_OUTLINE_COUNT : BMR_OUTLINE_LENS)};
                return (names[0] == nullptr) != (names[1] == nullptr) ||
                               (names[0] == nullptr) != (names[2] == nullptr)
                           ? "some names"
                       : names[0] != nullptr ? "names"
                                             : "`NULL`";
            });
});

} // namespace
