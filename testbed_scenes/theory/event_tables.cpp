// SPDX-License-Identifier: MIT
#include "theory/event_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>

namespace testbed {

double EventsOf(const Run &run) {
    return static_cast<double>(run.outcome.run.events);
}

double LinesOf(const Run &run) {
    return static_cast<double>(run.outcome.run.lines);
}

std::optional<double> MeanOver(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure, size_t ratioIndex, Count count) {
    double sum = 0.0;
    int found = 0;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure && run.ratioIndex == ratioIndex) {
            sum += count(run);
            ++found;
        }
    if (found == 0)
        return std::nullopt;
    return sum / found;
}

std::optional<double> MeanOptimum(const std::vector<Run> &runs, const std::string &motion,
                                  size_t ratioIndex) {
    // Every structure of a course carries the same optimum: one of them is enough.
    const bmr_kds_info *first = nullptr;
    double sum = 0.0;
    int count = 0;
    for (const Run &run : runs) {
        if (run.motion != motion || run.ratioIndex != ratioIndex || !run.optimum)
            continue;
        if (!first)
            first = run.structure;
        if (run.structure == first) {
            sum += static_cast<double>(run.optimum->least);
            ++count;
        }
    }
    if (count == 0)
        return std::nullopt;
    return sum / count;
}

std::optional<double> OverOptimum(const std::vector<Run> &runs, const bmr_kds_info *structure,
                                  size_t ratioIndex) {
    double logs = 0.0;
    int count = 0;
    for (const std::string &motion : MotionsOf(runs)) {
        const std::optional<double> lines = MeanOver(runs, motion, structure, ratioIndex, LinesOf),
                                    optimum = MeanOptimum(runs, motion, ratioIndex);
        if (!lines || !optimum)
            return std::nullopt;
        logs += std::log(std::max(1.0, *lines) / std::max(1.0, *optimum - 1.0));
        ++count;
    }
    if (count == 0)
        return std::nullopt;
    return std::exp(logs / count);
}

Bound BoundFor(const bmr_kds_info &structure, bool rigid, bool convex) {
    if (structure.role == BMR_KDS_RIVAL)
        return Bound::None;
    const bool compass = structure.hierarchy == BMR_HIERARCHY_COMPASS,
               point = structure.domain == BMR_KDS_POINT;
    if (!point && rigid)
        return compass ? Bound::LinearLog : Bound::Linear;
    // Table 1: on convex paths the Dudley hierarchies of two polygons may cost the square root.
    if (convex && (point || structure.hierarchy != BMR_HIERARCHY_DUDLEY))
        return Bound::Logarithmic;
    return compass ? Bound::RootLog : Bound::Root;
}

/// The exponent that the bound has itself over these ratios, if a power is fitted to it.
double ExponentOf(Bound bound, const std::vector<double> &ratios) {
    std::vector<double> values;
    for (const double ratio : ratios) {
        const double root = std::sqrt(ratio), log = std::log2(ratio);
        values.push_back(bound == Bound::Logarithmic ? log
                         : bound == Bound::Root      ? root
                         : bound == Bound::RootLog   ? root * log
                         : bound == Bound::Linear    ? ratio
                                                     : ratio * log * log);
    }
    bmr_growth fit = {};
    Require(bmr_fit_growth(ratios.data(), values.data(), ratios.size(), &fit), "the bound's growth");
    return fit.exponent;
}

/// Is a logarithm the better fit, in events rather than in parts of them? (Relative residuals weigh the first
/// few events of a wide range most, where a power bends like a logarithm.)
bool IsLogarithmic(const bmr_growth &fit, const std::vector<double> &ratios,
                   const std::vector<double> &values) {
    double ofLogarithm = 0.0, ofPower = 0.0;
    for (size_t i = 0; i < ratios.size(); ++i) {
        const double logarithm = values[i] - (fit.offset + fit.slope * std::log2(ratios[i]));
        const double power = values[i] - fit.constant * std::pow(ratios[i], fit.exponent);
        ofLogarithm += logarithm * logarithm;
        ofPower += power * power;
    }
    return ofLogarithm <= ofPower;
}

/// What a growth that is the bound's own may be fitted above it.
constexpr double kExponentRoom = 0.05;

BoundVerdict VerdictOn(const Growth &growth, const std::vector<double> &ratios,
                       const std::vector<double> &values) {
    const bmr_growth &fit = growth.fit;
    const double bound = ExponentOf(growth.bound, ratios);
    if (growth.bound == Bound::Logarithmic && IsLogarithmic(fit, ratios, values))
        return BoundVerdict::Holds;
    if (fit.exponent + fit.exponent_error <= bound + kExponentRoom)
        return BoundVerdict::Holds;
    return fit.exponent - fit.exponent_error > bound ? BoundVerdict::Refuted : BoundVerdict::Open;
}

std::optional<Growth> GrowthOf(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure) {
    std::vector<double> ratios, values;
    Growth growth;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure && std::isfinite(run.ratio)) {
            ratios.push_back(run.ratio);
            values.push_back(EventsOf(run));
            growth.bound = BoundFor(*structure, run.rigid, run.convex);
        }
    std::vector<double> different = ratios;
    std::sort(different.begin(), different.end());
    // Ratios are as measured: seeds differ a little.
    const auto isNear = [](double a, double b) { return b < 1.5 * a; };
    different.erase(std::unique(different.begin(), different.end(), isNear), different.end());
    if (different.size() < 3 ||
        bmr_fit_growth(ratios.data(), values.data(), ratios.size(), &growth.fit) != BMR_OK)
        return std::nullopt;
    if (growth.bound != Bound::None)
        growth.verdict = VerdictOn(growth, ratios, values);
    return growth;
}

const char *NameOf(Bound bound) {
    switch (bound) {
    case Bound::Logarithmic:
        return "log";
    case Bound::Root:
        return "1/2";
    case Bound::RootLog:
        return "1/2 log";
    case Bound::Linear:
        return "1";
    case Bound::LinearLog:
        return "1 log2";
    case Bound::None:
        break;
    }
    return "-";
}

std::string TextOf(const Growth &growth) {
    char number[32];
    if (growth.bound == Bound::Logarithmic)
        std::snprintf(number, sizeof number, "+%.1f", growth.fit.slope);
    else
        std::snprintf(number, sizeof number, "%.2f", growth.fit.exponent);
    std::string text = number;
    if (growth.verdict != BoundVerdict::None)
        text += std::string(" <") + NameOf(growth.bound);
    if (growth.verdict == BoundVerdict::Refuted)
        text += " NO";
    else if (growth.verdict == BoundVerdict::Open)
        text += " ?";
    return text;
}

QualitySummary QualitiesOver(const std::vector<Run> &runs, const bmr_kds_info *structure) {
    QualitySummary summary;
    int count = 0;
    for (const Run &run : runs) {
        if (run.structure != structure)
            continue;
        const bmr_qualities &qualities = run.outcome.run.qualities;
        summary.conditions = std::max(summary.conditions, qualities.conditions);
        summary.bytes = std::max(summary.bytes, qualities.bytes);
        summary.touched += qualities.touched;
        summary.touchedMost = std::max(summary.touchedMost, qualities.touched_most);
        summary.replanned = std::max(summary.replanned, qualities.replanned);
        summary.efficiency += qualities.efficiency;
        summary.rho = std::min(summary.rho, run.outcome.run.hysteresis.both);
        ++count;
    }
    if (count > 0) {
        summary.touched /= count;
        summary.efficiency /= count;
    }
    return summary;
}

std::vector<std::string> MotionsOf(const std::vector<Run> &runs) {
    std::vector<std::string> motions;
    for (const Run &run : runs)
        if (std::find(motions.begin(), motions.end(), run.motion) == motions.end())
            motions.push_back(run.motion);
    return motions;
}

std::vector<const bmr_kds_info *> StructuresOf(const std::vector<Run> &runs) {
    std::vector<const bmr_kds_info *> structures;
    for (const Run &run : runs)
        if (std::find(structures.begin(), structures.end(), run.structure) == structures.end())
            structures.push_back(run.structure);
    return structures;
}

void WriteCsv(std::ostream &out, const std::vector<Run> &runs) {
    constexpr int kDigits = 9;
    out << "motion,structure,n,ratio,seed,events,outside,lines,touched,failure_times,external,conditions,"
           "pair_bytes,hysteresis,optimum,wanted_ratio";
    for (int kind = 0; kind < BMR_KDS_NONE; ++kind)
        out << ',' << bmr_kds_event_name(static_cast<bmr_kds_event_kind>(kind));
    out << '\n' << std::setprecision(kDigits);
    const auto writeFinite = [&out](double value) {
        if (std::isfinite(value))
            out << value;
        out << ',';
    };
    for (const Run &run : runs) {
        const bmr_simulation_counts &counts = run.outcome.run.counts;
        out << run.motion << ',' << run.structure->name << ',' << run.n << ',';
        writeFinite(run.ratio);
        out << run.seed << ',' << run.outcome.run.events << ',' << run.outcome.outsideEvents << ','
            << run.outcome.run.lines << ',' << counts.touched << ',' << counts.failure_times << ','
            << counts.external << ',' << counts.conditions << ',' << counts.pair_bytes << ',';
        writeFinite(run.outcome.run.hysteresis.both);
        if (run.optimum)
            out << run.optimum->least;
        out << ',' << run.wantedRatio;
        for (int kind = 0; kind < BMR_KDS_NONE; ++kind)
            out << ',' << counts.events[kind];
        out << '\n';
    }
}

} // namespace testbed
