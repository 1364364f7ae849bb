// SPDX-License-Identifier: MIT
// What a repair of each kinetic structure costs, by the number of vertices: every event of an orbit, found
// beforehand, is repaired again and again. Times alone mean nothing on a shared machine; the table at the end
// gives ratios of this run.
//
//   bench_kds --once NAME VERTICES    one orbit of one structure: prints how many repairs it took
//   bench_kds --list                  the structures' names
//
// are for measure_repairs.sh, which counts the instructions of those repairs.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "boomerang/kds.h"

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kSizes[] = {16, 64, 256, 1024, 4096};
constexpr int kReference = 64;
/// Looks between events, and the most events of one orbit.
constexpr int kSteps = 20000;
constexpr size_t kMostEvents = 512;

struct PolygonDeleter {
    void operator()(bmr_polygon *p) const { bmr_polygon_destroy(p, nullptr); }
};
struct HierarchyDeleter {
    void operator()(bmr_hierarchy *h) const { bmr_hierarchy_destroy(h, nullptr); }
};
struct CompassDeleter {
    void operator()(bmr_compass *c) const { bmr_compass_destroy(c, nullptr); }
};
struct KdsDeleter {
    void operator()(bmr_kds *k) const { bmr_kds_destroy(k, nullptr); }
};
using Kds = std::unique_ptr<bmr_kds, KdsDeleter>;

/// A polygon with all its hierarchies.
struct Body {
    std::unique_ptr<bmr_polygon, PolygonDeleter> polygon;
    std::unique_ptr<bmr_hierarchy, HierarchyDeleter> hierarchies[BMR_HIERARCHY_KIND_COUNT];
    bmr_shape shape = {};

    Body(const std::vector<bmr_vec2> &points, const bmr_compass *compass) {
        bmr_polygon *p = nullptr;
        bmr_hierarchy *h[BMR_HIERARCHY_KIND_COUNT] = {};
        if (bmr_polygon_create(points.data(), points.size(), nullptr, &p) != BMR_OK ||
            bmr_hierarchy_build_compass(p, compass, nullptr, &h[BMR_HIERARCHY_COMPASS]) != BMR_OK ||
            bmr_hierarchy_build_dudley(p, nullptr, &h[BMR_HIERARCHY_DUDLEY]) != BMR_OK ||
            bmr_hierarchy_build_dobkin_kirkpatrick(p, nullptr, &h[BMR_HIERARCHY_DOBKIN_KIRKPATRICK]) !=
                BMR_OK)
            std::abort();
        polygon.reset(p);
        shape.polygon = p;
        for (int kind = 0; kind < BMR_HIERARCHY_KIND_COUNT; ++kind) {
            hierarchies[kind].reset(h[kind]);
            shape.hierarchies[kind] = h[kind];
        }
    }
};

std::vector<bmr_vec2> Ellipse(int n, double half_width, double half_height) {
    std::vector<bmr_vec2> points;
    for (int i = 0; i < n; ++i)
        points.push_back({half_width * std::cos(2 * kPi * (i + 0.3) / n),
                          half_height * std::sin(2 * kPi * (i + 0.3) / n)});
    return points;
}

/// Once around a 2 : 1 ellipse at a gap that breathes, turning three times where the structure bears it.
bmr_instant OrbitAt(double time, bool turns) {
    const double angle = 2 * kPi * time, w = 2 * kPi;
    const double x = 1.6 + 0.05 * std::cos(5 * angle), dx = -0.05 * 5 * w * std::sin(5 * angle);
    const double turn = turns ? 0.4 + 3 * angle : 0.4;
    bmr_instant now;
    now.pose = {{x * std::cos(angle), 0.7 * x * std::sin(angle)}, std::cos(turn), std::sin(turn)};
    now.velocity = {dx * std::cos(angle) - x * w * std::sin(angle),
                    0.7 * (dx * std::sin(angle) + x * w * std::cos(angle))};
    now.spin = turns ? 3 * w : 0.0;
    return now;
}

struct Event {
    bmr_instant now;
    size_t failed;
};

/// The first of the structure's conditions that has failed at an instant, or their number.
size_t FirstFailed(const bmr_condition *conditions, size_t count, const bmr_instant &now) {
    size_t i = 0;
    while (i < count && bmr_condition_value(&conditions[i], &now.pose) > 0.0)
        ++i;
    return i;
}

/// Takes the structure once around, repairing what fails, and notes the events.
std::vector<Event> EventsOf(bmr_kds *kds, bool turns) {
    std::vector<Event> events;
    bmr_kds_report report;
    bmr_instant now = OrbitAt(0.0, turns);
    bmr_kds_start(kds, &now, &report);
    double time = 0.0;
    for (int step = 1; step <= kSteps && events.size() < kMostEvents; ++step) {
        const double end = static_cast<double>(step) / kSteps;
        for (;;) {
            bmr_condition conditions[BMR_KDS_MAX_CONDITIONS];
            const size_t count = bmr_kds_conditions(kds, conditions);
            if (FirstFailed(conditions, count, OrbitAt(end, turns)) == count || events.size() == kMostEvents)
                break;
            double low = time, high = end;
            for (int i = 0; i < 50; ++i) {
                const double middle = 0.5 * (low + high);
                (FirstFailed(conditions, count, OrbitAt(middle, turns)) < count ? high : low) = middle;
            }
            // Whatever has not moved on by then is no event to measure.
            time = std::min(end, std::max(high, time + 1e-12));
            now = OrbitAt(time, turns);
            const size_t failed = FirstFailed(conditions, count, now);
            if (failed == count)
                continue;
            bmr_kds_repair(kds, &now, failed, &report);
            if (bmr_kds_in_contact(kds))
                return events;
            events.push_back({now, failed});
        }
        time = end;
    }
    return events;
}

Kds Make(const bmr_kds_info *info, const Body &a, const Body &b) {
    const bmr_kds_def def = bmr_default_kds_def();
    bmr_kds *kds = nullptr;
    if (bmr_kds_create(info, &def, &a.shape, &b.shape, nullptr, &kds) != BMR_OK)
        std::abort();
    return Kds(kds);
}

/// The bodies of a benchmark: their structure, and the events of the orbit.
struct Orbit {
    std::unique_ptr<bmr_compass, CompassDeleter> compass;
    bool turns;
    Body a, b;
    Kds kds;
    std::vector<Event> events;

    Orbit(const bmr_kds_info *info, int n)
        : compass(CompassFor(n)), turns(info->domain == BMR_KDS_RIGID),
          a(Ellipse(n, 1.0, 0.5), compass.get()),
          b(info->domain == BMR_KDS_POINT ? std::vector<bmr_vec2>{{0.0, 0.0}} : Ellipse(n, 0.4, 0.1),
            compass.get()),
          kds(Make(info, a, b)), events(EventsOf(kds.get(), turns)) {}

    static bmr_compass *CompassFor(int n) {
        bmr_compass *table = nullptr;
        if (bmr_compass_create(static_cast<size_t>(n), nullptr, &table) != BMR_OK)
            std::abort();
        return table;
    }
};

void Repair(benchmark::State &state, const bmr_kds_info *info, int n) {
    const Orbit orbit(info, n);
    const std::vector<Event> &events = orbit.events;
    if (events.empty()) {
        state.SkipWithError("no events on this orbit");
        return;
    }
    const bmr_instant begin = OrbitAt(0.0, orbit.turns);
    bmr_kds_report report;
    size_t next = events.size();
    uint64_t touched = 0;
    for (auto _ : state) {
        if (next == events.size()) { // some thousandth of the time: the orbit begins anew
            bmr_kds_start(orbit.kds.get(), &begin, &report);
            next = 0;
        }
        bmr_kds_repair(orbit.kds.get(), &events[next].now, events[next].failed, &report);
        touched += report.touched;
        ++next;
    }
    state.counters["events"] = static_cast<double>(events.size());
    state.counters["touched"] = static_cast<double>(touched) / static_cast<double>(state.iterations());
}

std::string Name(const bmr_kds_info *info, int n) {
    return std::string(info->name) + "/" + std::to_string(n);
}

/// Prints as usual and keeps the times for the table.
class Keeper : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run> &runs) override {
        for (const Run &run : runs)
            if (!run.error_occurred && (run.run_type == Run::RT_Iteration || run.aggregate_name == "median"))
                times_[run.run_name.function_name] = run.GetAdjustedCPUTime();
        ConsoleReporter::ReportRuns(runs);
    }
    /// 0 where it was not run.
    double Time(const std::string &name) const {
        const auto at = times_.find(name);
        return at == times_.end() ? 0.0 : at->second;
    }

private:
    std::map<std::string, double> times_;
};

void PrintRatios(const Keeper &keeper) {
    std::printf("\nTime of a repair over that of the same structure at n = %d; log2 n itself grows as in the "
                "first row:\n"
                "%-26s",
                kReference, "");
    for (const int n : kSizes)
        std::printf(" %8d", n);
    std::printf("\n%-26s", "log2 n");
    for (const int n : kSizes)
        std::printf(" %8.2f", std::log2(n) / std::log2(kReference));
    for (size_t i = 0; i < bmr_kds_count(); ++i) {
        const bmr_kds_info *info = bmr_kds_at(i);
        const double reference = keeper.Time(Name(info, kReference));
        if (!(reference > 0.0))
            continue;
        std::printf("\n%-26s", info->name);
        for (const int n : kSizes) {
            const double time = keeper.Time(Name(info, n));
            time > 0 ? std::printf(" %8.2f", time / reference) : std::printf(" %8s", "-");
        }
    }
    std::printf("\n");
}

} // namespace

int main(int argc, char **argv) {
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode == "--list") {
        for (size_t i = 0; i < bmr_kds_count(); ++i)
            std::printf("%s\n", bmr_kds_at(i)->name);
        return 0;
    }
    if (mode == "--once") {
        const int n = argc > 3 ? std::atoi(argv[3]) : 0;
        for (size_t i = 0; n >= 3 && i < bmr_kds_count(); ++i)
            if (bmr_kds_at(i)->name == std::string(argv[2])) {
                std::printf("%zu\n", Orbit(bmr_kds_at(i), n).events.size());
                return 0;
            }
        return 2;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        for (const int n : kSizes) {
            const bmr_kds_info *info = bmr_kds_at(i);
            benchmark::RegisterBenchmark(Name(info, n).c_str(),
                                         [=](benchmark::State &s) { Repair(s, info, n); });
        }
    Keeper keeper;
    benchmark::RunSpecifiedBenchmarks(&keeper);
    PrintRatios(keeper);
    return 0;
}
