// SPDX-License-Identifier: MIT
// What a failure time costs: each kind of condition, by Bernstein subdivision and by GSL's complex roots, and
// by safe steps where a body spins; and events of a whole simulation. Times alone mean nothing on a shared
// machine: the table at the end gives ratios of this run (use --benchmark_repetitions and
// --benchmark_enable_random_interleaving=true).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "boomerang/simulation.h"
#include "structure_named.h"

namespace {

constexpr int kTrials = 256;
constexpr double kPi = 3.14159265358979323846;
constexpr double kUntil = 4.0;

struct MotionDeleter {
    void operator()(bmr_motion *m) const { bmr_motion_destroy(m); }
};
using Motion = std::unique_ptr<bmr_motion, MotionDeleter>;

double Uniform(std::mt19937_64 &engine, double low, double high) {
    return low + (high - low) * (static_cast<double>(engine() >> 11) * 0x1p-53);
}

/// How both bodies move, and the degree of BEYOND under it.
struct Setting {
    const char *name;
    size_t degree, rotation; // of an algebraic piece
    double spin;             // not 0: a screw
};
// BEYOND has degree `degree` + 4 `rotation`.
const Setting kSettings[] = {{"path-4", 4, 0, 0.0},  {"path-8", 8, 0, 0.0},   {"rigid-4", 0, 1, 0.0},
                             {"rigid-8", 4, 1, 0.0}, {"rigid-16", 8, 2, 0.0}, {"screw", 1, 0, 2.0}};
const char *const kKinds[] = {"beyond", "turn", "disks"};
const char *const kMethods[] = {"bernstein", "gsl"};

bmr_motion_piece RandomPiece(std::mt19937_64 &engine, const Setting &setting) {
    const double angle = Uniform(engine, -kPi, kPi);
    const bmr_pose pose = {
        {Uniform(engine, -3, 3), Uniform(engine, -3, 3)}, std::cos(angle), std::sin(angle)};
    if (setting.spin != 0.0)
        return bmr_piece_screw(0.0, pose, {Uniform(engine, -1, 1), Uniform(engine, -1, 1)},
                               Uniform(engine, -setting.spin, setting.spin));
    bmr_motion_piece piece = {};
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = 0.5 * kUntil;
    bmr_algebraic_piece &w = piece.as.algebraic;
    w.degree = setting.degree;
    w.rotation_degree = setting.rotation;
    double scale = 3.0;
    for (size_t k = 0; k <= BMR_MOTION_MAX_DEGREE; ++k, scale /= 2.5) {
        w.x[k] = Uniform(engine, -scale, scale);
        w.y[k] = Uniform(engine, -scale, scale);
        w.a[k] = Uniform(engine, -scale, scale);
        w.b[k] = Uniform(engine, -scale, scale);
    }
    w.start_c = pose.c;
    w.start_s = pose.s;
    return piece;
}

struct Trial {
    Motion a, b;
    bmr_condition condition;
};

/// Conditions that hold at 0; most fail before kUntil.
std::vector<Trial> MakeTrials(const Setting &setting, int kind) {
    std::mt19937_64 engine(7);
    std::vector<Trial> trials;
    while (trials.size() < kTrials) {
        bmr_motion *a = nullptr, *b = nullptr;
        const bmr_motion_piece p = RandomPiece(engine, setting), q = RandomPiece(engine, setting);
        if (bmr_motion_create(&p, nullptr, &a) != BMR_OK || bmr_motion_create(&q, nullptr, &b) != BMR_OK)
            std::abort();
        Trial trial{Motion(a), Motion(b), {}};
        const double angle = Uniform(engine, -kPi, kPi);
        const bmr_vec2 n = {std::cos(angle), std::sin(angle)}, v = {Uniform(engine, -1, 1), 1.0};
        trial.condition = kind == BMR_CONDITION_BEYOND
                              ? bmr_condition_beyond(0, n, Uniform(engine, -2, 0), v, 0)
                          : kind == BMR_CONDITION_TURN ? bmr_condition_turn(0, n, v, 0)
                                                       : bmr_condition_disks(n, v, 1.0, 0);
        const bmr_pose x = bmr_motion_pose(a, 0.0, nullptr, nullptr);
        const bmr_pose y = bmr_motion_pose(b, 0.0, nullptr, nullptr);
        const bmr_pose relative = bmr_pose_relative(&x, &y);
        if (bmr_condition_value(&trial.condition, &relative) > 0.01)
            trials.push_back(std::move(trial));
    }
    return trials;
}

void FailureTime(benchmark::State &state, const Setting &setting, int kind, int method) {
    const std::vector<Trial> trials = MakeTrials(setting, kind);
    bmr_failure_options options = bmr_default_failure_options();
    options.method = static_cast<bmr_root_method>(method);
    size_t i = 0, failing = 0, calls = 0;
    for ([[maybe_unused]] auto _ : state) {
        const Trial &trial = trials[i++ % kTrials];
        double time = 0.0;
        if (bmr_failure_time(&trial.condition, trial.a.get(), trial.b.get(), 0.0, kUntil, &options, &time) !=
            BMR_OK)
            std::abort();
        failing += time <= kUntil;
        ++calls;
        benchmark::DoNotOptimize(time);
    }
    state.counters["failing"] = static_cast<double>(failing) / static_cast<double>(calls);
}

/// Ellipses of n vertices in rows, each spinning at its own rate.
void Events(benchmark::State &state, const char *structure, int n, int bodies) {
    std::vector<bmr_vec2> points;
    points.reserve(static_cast<size_t>(n));
    for (int i = 0; i < n; ++i)
        points.push_back({std::cos(2 * kPi * i / n), 0.4 * std::sin(2 * kPi * i / n)});
    bmr_polygon *polygon = nullptr;
    if (bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) != BMR_OK)
        std::abort();
    std::vector<bmr_shape> shapes(static_cast<size_t>(bodies), bmr_shape{polygon, {}, {}});
    std::vector<bmr_motion *> motions;
    for (int i = 0; i < bodies; ++i) {
        const int column = i % 4, row = i / 4;
        const bmr_pose pose = {{2.2 * column, 2.2 * row}, 1.0, 0.0};
        const bmr_motion_piece piece = bmr_piece_screw(0.0, pose, {0.0, 0.0}, 1.0 + 0.3 * i);
        motions.push_back(nullptr);
        if (bmr_motion_create(&piece, nullptr, &motions.back()) != BMR_OK)
            std::abort();
    }
    bmr_simulation_def def = bmr_default_simulation_def();
    def.structure = test_structure(structure);
    size_t events = 0, searches = 0;
    for ([[maybe_unused]] auto _ : state) {
        bmr_simulation *simulation = nullptr;
        if (bmr_simulation_create(&def, shapes.data(), motions.data(), shapes.size(), 0.0, nullptr, nullptr,
                                  nullptr, &simulation) != BMR_OK ||
            bmr_simulation_run(simulation, 5.0) != BMR_OK)
            std::abort();
        const bmr_simulation_counts counts = bmr_simulation_get_counts(simulation);
        for (const uint64_t count : counts.events)
            events += count;
        searches += counts.failure_times;
        bmr_simulation_destroy(simulation);
    }
    state.counters["events/s"] = benchmark::Counter(static_cast<double>(events), benchmark::Counter::kIsRate);
    state.counters["searches/event"] = static_cast<double>(searches) / static_cast<double>(events);
    for (bmr_motion *motion : motions)
        bmr_motion_destroy(motion);
    bmr_polygon_destroy(polygon, nullptr);
}

std::string Name(const Setting &setting, int kind, int method) {
    return std::string(setting.name) + "/" + kKinds[kind] + "/" +
           (setting.spin != 0.0 ? "safe-steps" : kMethods[method]);
}

void RegisterAll() {
    for (const Setting &setting : kSettings)
        for (int kind = 0; kind < BMR_CONDITION_KIND_COUNT; ++kind)
            for (int method = 0; method < (setting.spin != 0.0 ? 1 : 2); ++method)
                benchmark::RegisterBenchmark(Name(setting, kind, method).c_str(), [=](benchmark::State &s) {
                    FailureTime(s, setting, kind, method);
                });
    for (const char *structure : {"free-fd1", "free-fdx", "inflated-window"})
        for (const int n : {8, 64})
            if (test_structure(structure)->hierarchy < 0)
                benchmark::RegisterBenchmark(
                    ("events/" + std::string(structure) + "/" + std::to_string(n)).c_str(),
                    [=](benchmark::State &s) { Events(s, structure, n, 8); });
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
    double Ratio(const std::string &name, const std::string &other) const {
        const auto a = times_.find(name), b = times_.find(other);
        return a == times_.end() || b == times_.end() ? 0.0 : a->second / b->second;
    }

private:
    std::map<std::string, double> times_;
};

void PrintRatios(const Keeper &keeper) {
    std::printf("\nTime of a failure time, this run%-8s %10s %10s %10s\n", "", kKinds[0], kKinds[1],
                kKinds[2]);
    const std::string unit = Name(kSettings[0], BMR_CONDITION_BEYOND, BMR_ROOT_BERNSTEIN);
    for (const Setting &setting : kSettings) {
        std::printf("%-10s %-28s", setting.name,
                    setting.spin != 0.0 ? "safe steps / path-4" : "gsl / bernstein");
        for (int kind = 0; kind < BMR_CONDITION_KIND_COUNT; ++kind)
            std::printf(" %10.2f", setting.spin != 0.0
                                       ? keeper.Ratio(Name(setting, kind, 0), unit)
                                       : keeper.Ratio(Name(setting, kind, 1), Name(setting, kind, 0)));
        std::printf("\n");
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
