// SPDX-License-Identifier: MIT
#include "theory/event_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <stdexcept>

namespace testbed {
namespace {

const char *const kQuantityNames[] = {"events", "lines", "touched", "work", "handovers"};

nlohmann::json Number(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

/// A line as "owner:angle:offset": the angle in radians in the owner's frame.
void WriteLine(std::ostream &out, const bmr_kds_proof &proof, bool exists) {
    if (!exists) {
        out << '-';
        return;
    }
    out << (proof.owner == 0 ? 'A' : 'B') << ':' << std::atan2(proof.line.normal.y, proof.line.normal.x)
        << ':' << proof.line.offset;
}

/// How far the other body's polygon is beyond a line at a pose, every vertex looked at.
double SlackOf(const bmr_simulation_event &event, const bmr_polygon *a, const bmr_polygon *b) {
    const bmr_kds_proof &proof = event.after;
    const bmr_polygon *other = proof.owner == 0 ? b : a;
    const bmr_pose otherInOwner = proof.owner == 0 ? event.pose : bmr_pose_inverse(&event.pose);
    double least = INFINITY;
    for (uint32_t i = 0; i < other->count; ++i)
        least = std::min(least, bmr_dot(proof.line.normal, bmr_transform(&otherInOwner, other->vertices[i])));
    return least - proof.line.offset;
}

} // namespace

Quantity QuantityNamed(const std::string &name) {
    for (size_t i = 0; i < std::size(kQuantityNames); ++i)
        if (name == kQuantityNames[i])
            return static_cast<Quantity>(i);
    throw std::invalid_argument("there is no quantity \"" + name + "\"");
}

double QuantityOf(const Run &run, Quantity quantity) {
    switch (quantity) {
    case Quantity::Events:
        break;
    case Quantity::Lines:
        return static_cast<double>(run.outcome.run.lines);
    case Quantity::Touched:
        return static_cast<double>(run.outcome.run.counts.touched);
    case Quantity::Work:
        return static_cast<double>(run.outcome.run.counts.failure_times);
    case Quantity::Handovers:
        return static_cast<double>(run.outcome.run.counts.events[BMR_KDS_HANDOVER]);
    }
    return static_cast<double>(run.outcome.run.events);
}

std::optional<double> MeanOver(const std::vector<Run> &runs, const std::string &motion,
                               const bmr_kds_info *structure, size_t ratioIndex, Quantity quantity) {
    double sum = 0.0;
    int count = 0;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure && run.ratioIndex == ratioIndex) {
            sum += QuantityOf(run, quantity);
            ++count;
        }
    if (count == 0)
        return std::nullopt;
    return sum / count;
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
        const std::optional<double> lines = MeanOver(runs, motion, structure, ratioIndex, Quantity::Lines),
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
                               const bmr_kds_info *structure, Quantity quantity) {
    std::vector<double> ratios, values;
    Growth growth;
    for (const Run &run : runs)
        if (run.motion == motion && run.structure == structure && std::isfinite(run.ratio)) {
            ratios.push_back(run.ratio);
            values.push_back(QuantityOf(run, quantity));
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

nlohmann::json ToJson(const std::vector<Run> &runs) {
    nlohmann::json list = nlohmann::json::array();
    for (const Run &run : runs) {
        const bmr_simulation_counts &counts = run.outcome.run.counts;
        nlohmann::json kinds;
        for (int kind = 0; kind < BMR_KDS_NONE; ++kind)
            kinds[bmr_kds_event_name(static_cast<bmr_kds_event_kind>(kind))] = counts.events[kind];
        nlohmann::json entry = {{"motion", run.motion},
                                {"structure", run.structure->name},
                                {"n", run.n},
                                {"ratio", Number(run.ratio)},
                                {"wanted_ratio", run.wantedRatio},
                                {"seed", run.seed},
                                {"rigid", run.rigid},
                                {"convex", run.convex},
                                {"events", run.outcome.run.events},
                                {"outside", run.outcome.outsideEvents},
                                {"lines", run.outcome.run.lines},
                                {"touched", counts.touched},
                                {"failure_times", counts.failure_times},
                                {"external", counts.external},
                                {"conditions", counts.conditions},
                                {"pair_bytes", counts.pair_bytes},
                                {"kinds", kinds}};
        const bmr_qualities &qualities = run.outcome.run.qualities;
        entry["qualities"] = {{"conditions", qualities.conditions}, {"bytes", qualities.bytes},
                              {"touched", qualities.touched},       {"touched_most", qualities.touched_most},
                              {"replanned", qualities.replanned},   {"efficiency", qualities.efficiency}};
        const bmr_hysteresis &hysteresis = run.outcome.run.hysteresis;
        entry["hysteresis"] = {{"both", Number(hysteresis.both)},
                               {"displacement", Number(hysteresis.displacement)},
                               {"rotation", Number(hysteresis.rotation)}};
        entry["optimum"] = nullptr;
        if (run.optimum)
            entry["optimum"] = {{"least", run.optimum->least}, {"found", run.optimum->found}};
        list.push_back(std::move(entry));
    }
    return list;
}

std::vector<std::pair<std::string, std::string>> EventColumns() {
    std::vector<std::pair<std::string, std::string>> columns;
    for (const char *name : {"motion", "structure", "n", "ratio", "seed", "events", "outside", "lines",
                             "touched", "failure_times", "external", "conditions", "pair_bytes"})
        columns.emplace_back(name, std::string("/") + name);
    columns.insert(columns.end(), {{"hysteresis", "/hysteresis/both"},
                                   {"optimum", "/optimum/least"},
                                   {"wanted_ratio", "/wanted_ratio"}});
    for (int kind = 0; kind < BMR_KDS_NONE; ++kind) {
        const std::string name = bmr_kds_event_name(static_cast<bmr_kds_event_kind>(kind));
        columns.emplace_back(name, "/kinds/" + name);
    }
    return columns;
}

void WriteTraceHeader(std::ostream &out) {
    out << "# motion structure D/sigma seed time kind level-before level-after touched line-before "
           "line-after "
           "separation\n"
           "# a line: the body it is fixed in, the angle of its normal there, its offset; separation: what "
           "the "
           "new line proves\n";
}

void WriteTraceLine(std::ostream &out, const Run &run, const bmr_simulation_event &event) {
    const bmr_kds_event_kind kind = event.report.kind;
    const bool hadLine = kind != BMR_KDS_START && kind != BMR_KDS_LEAVE, hasLine = event.report.apart;
    out << run.motion << ' ' << run.structure->name << ' ' << std::setprecision(6) << run.ratio << ' '
        << run.seed << ' ' << std::setprecision(17) << event.time << ' ' << bmr_kds_event_name(kind) << ' '
        << event.report.level_before << ' ' << event.report.level_after << ' ' << event.report.touched << ' '
        << std::setprecision(9);
    WriteLine(out, event.before, hadLine);
    out << ' ';
    WriteLine(out, event.after, hasLine);
    out << ' ';
    if (hasLine)
        out << SlackOf(event, run.bodies[0]->Polygon(), run.bodies[1]->Polygon());
    else
        out << 0;
    out << '\n';
}

} // namespace testbed
