// SPDX-License-Identifier: MIT
// What it costs to know, for one pair and one step, that two polygons are still apart: our structures beside
// Box2D's own calls, a warm GJK and a remembered edge. Times alone mean nothing on a shared machine; the
// table at the end gives ratios of this run.
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>

#include "boomerang/pair.h"
#include "rivals.h"

namespace {

constexpr int kSteps = 4096;
constexpr double kPi = 3.14159265358979323846;

/// How the second polygon moves about the first, in diameters a step.
enum Motion { kStill, kSlow, kFast };
const char *const kMotionNames[] = {"holds", "slow", "fast"};
const double kSpeed[] = {1e-7, 5e-4, 2e-2};

struct PolygonDeleter {
    void operator()(bmr_polygon *p) const { bmr_polygon_destroy(p, nullptr); }
};
struct HierarchyDeleter {
    void operator()(bmr_hierarchy *h) const { bmr_hierarchy_destroy(h, nullptr); }
};
struct CompassDeleter {
    void operator()(bmr_compass *c) const { bmr_compass_destroy(c, nullptr); }
};

constexpr double kLong = 1.0, kShort = 0.3; // half axes

/// How far an ellipse turned by `turn` reaches in the direction of `angle`.
double Reach(double turn, double angle) {
    return std::hypot(kLong * std::cos(angle - turn), kShort * std::sin(angle - turn));
}

/// Two n-gons on ellipses (their bounding disks overlap nearly always), and the poses of an orbit on which
/// both spin and the gap between them, along the line of centres, breathes from 0.02 to 0.4.
struct Setting {
    std::unique_ptr<bmr_polygon, PolygonDeleter> polygon;
    std::unique_ptr<bmr_compass, CompassDeleter> compass;
    std::unique_ptr<bmr_hierarchy, HierarchyDeleter> hierarchy;
    std::vector<b2Transform> a, b;

    Setting(int n, Motion motion) {
        std::vector<bmr_vec2> points;
        for (int i = 0; i < n; ++i)
            points.push_back({kLong * std::cos(2 * kPi * i / n), kShort * std::sin(2 * kPi * i / n)});
        bmr_polygon *p = nullptr;
        bmr_compass *c = nullptr;
        bmr_hierarchy *h = nullptr;
        if (bmr_polygon_create(points.data(), points.size(), nullptr, &p) != BMR_OK ||
            bmr_compass_create(points.size(), nullptr, &c) != BMR_OK ||
            bmr_hierarchy_build_compass(p, c, nullptr, &h) != BMR_OK)
            std::abort();
        polygon.reset(p);
        compass.reset(c);
        hierarchy.reset(h);
        double angle = 0.3;
        for (int i = 0; i < kSteps; ++i) {
            const double turnA = 0.2 * angle, turnB = -1.3 * angle;
            const double gap = 0.21 + 0.19 * std::cos(7 * angle);
            const double distance = Reach(turnA, angle) + Reach(turnB, angle) + gap;
            b2Transform xfA, xfB;
            xfA.Set(b2Vec2(1.0f, -2.0f), static_cast<float>(turnA));
            xfB.Set(xfA.p + b2Vec2(static_cast<float>(distance * std::cos(angle)),
                                   static_cast<float>(distance * std::sin(angle))),
                    static_cast<float>(turnB));
            a.push_back(xfA);
            b.push_back(xfB);
            angle += kSpeed[motion];
        }
    }
};

bmr_pose PoseOf(const b2Transform &xf) {
    return {{double{xf.p.x}, double{xf.p.y}}, double{xf.q.c}, double{xf.q.s}};
}

bmr_pose Relative(const b2Transform &xfA, const b2Transform &xfB) {
    const bmr_pose a = PoseOf(xfA), b = PoseOf(xfB);
    return bmr_pose_relative(&a, &b);
}

template <typename Ask> void Steps(benchmark::State &state, const Setting &setting, Ask ask) {
    int i = 0;
    bool answer = true;
    for (auto _ : state) {
        answer &= ask(setting.a[static_cast<size_t>(i)], setting.b[static_cast<size_t>(i)]);
        i = i + 1 == kSteps ? 0 : i + 1;
    }
    benchmark::DoNotOptimize(answer);
    if (!answer)
        state.SkipWithError("the polygons of this benchmark never touch, yet an answer said so");
}

void Structure(benchmark::State &state, bmr_structure structure, int n, Motion motion) {
    const Setting setting(n, motion);
    bmr_pair_def def = bmr_default_pair_def();
    def.structure = structure;
    bmr_shape shape = {setting.polygon.get(), {}, {}};
    if (setting.hierarchy != nullptr)
        shape.hierarchies[bmr_hierarchy_get_kind(setting.hierarchy.get())] = setting.hierarchy.get();
    alignas(64) bmr_pair pair;
    bmr_pair_init(&pair);
    Steps(state, setting, [&](const b2Transform &a, const b2Transform &b) {
        const bmr_pose pose = Relative(a, b);
        double gap;
        return bmr_pair_check(&pair, &pose, def.margin, &gap) ||
               bmr_pair_advance(&pair, &def, &shape, &shape, &pose, nullptr, &gap) == BMR_APART;
    });
}

void Edge(benchmark::State &state, int n, Motion motion) {
    const Setting setting(n, motion);
    rival::CachedEdge edge;
    Steps(state, setting, [&](const b2Transform &a, const b2Transform &b) {
        return edge.Apart(*setting.polygon, *setting.polygon, Relative(a, b));
    });
}

void Gjk(benchmark::State &state, int n, Motion motion) {
    const Setting setting(n, motion);
    rival::WarmGjk gjk;
    Steps(state, setting, [&](const b2Transform &a, const b2Transform &b) {
        return gjk.Distance(*setting.polygon, *setting.polygon, Relative(a, b)) > 0.0;
    });
}

b2PolygonShape Octagon(const Setting &setting) {
    b2Vec2 points[8];
    for (uint32_t i = 0; i < 8; ++i)
        points[i].Set(static_cast<float>(setting.polygon->vertices[i].x),
                      static_cast<float>(setting.polygon->vertices[i].y));
    b2PolygonShape shape;
    shape.Set(points, 8);
    shape.m_radius = 0.0f; // what is asked of the others
    return shape;
}

void Collide(benchmark::State &state, Motion motion) {
    const Setting setting(8, motion);
    const b2PolygonShape octagon = Octagon(setting);
    Steps(state, setting, [&](const b2Transform &a, const b2Transform &b) {
        b2Manifold manifold;
        b2CollidePolygons(&manifold, &octagon, a, &octagon, b);
        return manifold.pointCount == 0;
    });
}

void Distance(benchmark::State &state, Motion motion) {
    const Setting setting(8, motion);
    const b2PolygonShape octagon = Octagon(setting);
    b2DistanceInput input;
    input.proxyA.Set(&octagon, 0);
    input.proxyB.Set(&octagon, 0);
    input.useRadii = false;
    b2SimplexCache cache;
    cache.count = 0;
    Steps(state, setting, [&](const b2Transform &a, const b2Transform &b) {
        input.transformA = a;
        input.transformB = b;
        b2DistanceOutput output;
        b2Distance(&output, &cache, &input);
        return output.distance > 0.0f;
    });
}

std::string Name(const std::string &method, int n, Motion motion) {
    return method + "/" + std::to_string(n) + "/" + kMotionNames[motion];
}

void RegisterAll() {
    for (const Motion motion : {kStill, kSlow, kFast}) {
        for (const int n : {8, 64, 1024, 4096}) {
            const auto add = [&](const char *method, auto run) {
                benchmark::RegisterBenchmark(Name(method, n, motion).c_str(), run);
            };
            add("lazy-compass", [=](benchmark::State &s) { Structure(s, BMR_LAZY_COMPASS, n, motion); });
            add("free-direction", [=](benchmark::State &s) { Structure(s, BMR_FREE_DIRECTION, n, motion); });
            add("cached-edge", [=](benchmark::State &s) { Edge(s, n, motion); });
            add("warm-gjk", [=](benchmark::State &s) { Gjk(s, n, motion); });
            if (n == 8) {
                add("b2CollidePolygons", [=](benchmark::State &s) { Collide(s, motion); });
                add("b2Distance", [=](benchmark::State &s) { Distance(s, motion); });
            }
        }
    }
}

/// Prints as usual and keeps the medians (or the only run) for the table.
class Keeper : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run> &runs) override {
        for (const Run &run : runs) {
            if (!run.error_occurred && (run.run_type == Run::RT_Iteration || run.aggregate_name == "median"))
                times_[run.run_name.function_name] = run.GetAdjustedCPUTime();
        }
        ConsoleReporter::ReportRuns(runs);
    }
    /// The time of a benchmark over that of another; 0 where one was not run.
    double Ratio(const std::string &name, const std::string &other) const {
        const auto a = times_.find(name), b = times_.find(other);
        return a == times_.end() || b == times_.end() ? 0.0 : a->second / b->second;
    }

private:
    std::map<std::string, double> times_;
};

void PrintRatios(const Keeper &keeper) {
    std::printf("\nTime of each method over that of a remembered edge (cached-edge), this run:\n%-18s", "");
    for (const Motion motion : {kStill, kSlow, kFast})
        for (const int n : {8, 64, 1024, 4096})
            std::printf(" %s/%-5d", kMotionNames[motion], n);
    for (const char *method :
         {"lazy-compass", "free-direction", "warm-gjk", "b2CollidePolygons", "b2Distance"}) {
        std::printf("\n%-18s", method);
        for (const Motion motion : {kStill, kSlow, kFast}) {
            for (const int n : {8, 64, 1024, 4096}) {
                const double ratio = keeper.Ratio(Name(method, n, motion), Name("cached-edge", n, motion));
                ratio > 0 ? std::printf(" %10.2f", ratio) : std::printf(" %10s", "-");
            }
        }
    }
    std::printf("\n");
    for (const char *method : {"lazy-compass", "free-direction"}) {
        std::printf("%s, a check that holds: b2CollidePolygons takes %.1f times as long on octagons; n = "
                    "4096 takes %.2f "
                    "times as long as n = 8\n",
                    method, keeper.Ratio(Name("b2CollidePolygons", 8, kStill), Name(method, 8, kStill)),
                    keeper.Ratio(Name(method, 4096, kStill), Name(method, 8, kStill)));
    }
}

} // namespace

int main(int argc, char **argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    RegisterAll();
    Keeper keeper;
    benchmark::RunSpecifiedBenchmarks(&keeper);
    PrintRatios(keeper);
    return 0;
}
