// SPDX-License-Identifier: MIT
#include "report/page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "report/html.h"
#include "report/number_text.h"
#include "report/scene_tables.h"
#include "theory/event_tables.h"

namespace testbed {
namespace {

/// The geometric mean of a figure over all scenes that have it.
std::optional<double> MeanOf(const std::vector<SceneNumbers> &scenes, const char *figure) {
    double logs = 0.0;
    int count = 0;
    for (const SceneNumbers &scene : scenes)
        if (const std::optional<double> value = scene[figure]; value && *value > 0.0) {
            logs += std::log(*value);
            ++count;
        }
    if (count == 0)
        return std::nullopt;
    return std::exp(logs / count);
}

bool Has(const std::vector<SceneNumbers> &scenes, const SceneTable &layout) {
    for (const SceneNumbers &scene : scenes)
        for (const SceneColumn &column : layout.columns)
            if (scene[column.figure])
                return true;
    return false;
}

/// Writes the page from top to bottom; counts what needs names of its own.
class Writer {
public:
    Writer(std::ostream &out, const Numbers &numbers) : m_out(out), m_numbers(numbers) {}

    void Write(const ReportPage &page) {
        m_out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                 "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                 "<meta name=\"color-scheme\" content=\"light dark\">\n"
                 // Whatever a name in somebody's file says, nothing is fetched and nothing runs.
                 "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
                 "'unsafe-inline'\">\n<title>"
              << Escaped(page.title) << "</title>\n<style>\n"
              << kReportStyle << "</style>\n</head>\n<body>\n<header>\n<h1>" << Escaped(page.title)
              << "</h1>\n";
        Summary();
        Contents();
        m_out << "</header>\n<main>\n";
        Scenes();
        Events();
        Costs();
        m_out << "</main>\n<footer>\n<h2>Where the numbers come from</h2>\n<ul>\n";
        for (const std::string &source : m_numbers.sources)
            m_out << "<li>" << Escaped(source) << "</li>\n";
        m_out << "</ul>\n<p>" << Escaped(page.made) << "</p>\n</footer>\n</body>\n</html>\n";
    }

private:
    void Summary() {
        const std::vector<SceneNumbers> &scenes = m_numbers.scenes;
        if (scenes.empty())
            return;
        auto count = [&scenes](const char *verdict) {
            return std::count_if(scenes.begin(), scenes.end(),
                                 [verdict](const auto &scene) { return scene.verdict == verdict; });
        };
        m_out << "<dl class=\"summary\">\n";
        auto entry = [this](const std::string &name, const std::string &value, const char *kind) {
            m_out << "<div class=\"" << kind << "\"><dt>" << Escaped(name) << "</dt><dd>" << Escaped(value)
                  << "</dd></div>\n";
        };
        const auto identical = static_cast<size_t>(count("identical"));
        entry(m_numbers.verified ? "scenes without a wrong answer" : "scenes with the same bits as stock",
              std::to_string(identical) + " of " + std::to_string(scenes.size()),
              identical == scenes.size() ? "good" : "bad");
        if (count("different") != 0)
            entry("scenes that differ", std::to_string(count("different")), "bad");
        if (count("failed") != 0)
            entry("scenes that failed", std::to_string(count("failed")), "bad");
        if (const auto mean = MeanOf(scenes, "ratio.step"))
            entry("whole step, times as fast (geometric mean)", Fixed(mean, 2), "plain");
        if (const auto mean = MeanOf(scenes, "ratio.narrow_phase"))
            entry("narrow phase, times as fast (geometric mean)", Fixed(mean, 2), "plain");
        m_out << "</dl>\n";
        for (const std::string &setting : m_numbers.settings)
            m_out << "<p class=\"setting\">" << Escaped(setting) << "</p>\n";
    }

    void Contents() {
        m_out << "<nav aria-label=\"Contents\">\n<ul>\n";
        if (!m_numbers.scenes.empty())
            m_out << "<li><a href=\"#scenes\">Scenes: Box2D with the plugin against stock</a></li>\n";
        if (!m_numbers.runs.empty())
            m_out << "<li><a href=\"#events\">Events of the kinetic structures</a></li>\n";
        if (!CostPictures(m_numbers).empty())
            m_out << "<li><a href=\"#costs\">How cost grows</a></li>\n";
        m_out << "</ul>\n</nav>\n";
    }

    void Scenes() {
        const std::vector<SceneNumbers> &scenes = m_numbers.scenes;
        if (scenes.empty())
            return;
        m_out << "<section id=\"scenes\">\n<h2>Scenes: Box2D with the plugin against stock</h2>\n";
        Differences();
        Verdicts();
        if (m_numbers.verified)
            Layout(VerifyTable());
        Figures(ScenePictures(m_numbers), false);
        if (m_numbers.repeat > 0)
            Layout(TimeTable(m_numbers.repeat));
        Layout(TestTable());
        Layout(BudgetTable());
        Layout(EventTable());
        m_out << "</section>\n";
    }

    /// What differs is what a reader must see first.
    void Differences() {
        for (const SceneNumbers &scene : m_numbers.scenes) {
            std::string words;
            const nlohmann::json &difference = scene.entry.value("difference", nlohmann::json());
            const nlohmann::json &failure = scene.entry.value("failure", nlohmann::json());
            if (difference.is_object()) {
                words = "differs at step " + difference.value("step", nlohmann::json()).dump() +
                        ", in the hash of " + difference.value("hashes", "") + ". " +
                        difference.value("field", "") + ": stock " + difference.value("stock", "") +
                        ", plugin " + difference.value("plugin", "");
            } else if (failure.is_string()) {
                words = "failed: " + failure.get<std::string>();
            }
            if (!words.empty())
                m_out << "<p class=\"alarm\"><strong>" << Escaped(scene.name) << "</strong> "
                      << Escaped(words) << "</p>\n";
        }
    }

    void Verdicts() {
        HtmlTable table;
        table.caption = "Whether the bits agree";
        table.corner = "scene";
        table.columns = {{"", "size"}, {"", "steps"}};
        for (const char *way : kWays)
            table.columns.push_back({"bits, against stock’s", way});
        table.columns.push_back({"", "all"});
        for (const SceneNumbers &scene : m_numbers.scenes) {
            std::vector<HtmlTable::Cell> row = {
                {scene.name}, {std::to_string(scene.size)}, {std::to_string(scene.steps)}};
            auto add = [&row](const std::string &verdict) {
                row.push_back({verdict.empty() ? "–" : verdict, verdict.empty()          ? "none"
                                                                : verdict == "identical" ? "good"
                                                                                         : "bad"});
            };
            for (const char *way : kWays)
                add(scene.VariantOf(way));
            add(scene.verdict == "different" ? "DIFFERENT" : scene.verdict);
            table.rows.push_back(std::move(row));
        }
        Put(table, VerdictLegend());
    }

    static constexpr char kSlowerWord[] = " slower";

    /// What stands behind a ratio. One whose pairs of runs lie on both sides of 1 is no difference.
    static const char *Judged(const SceneNumbers &scene, const SceneColumn &column) {
        const std::string name = column.figure;
        const std::optional<double> least = scene["ratio.step_least"],
                                    greatest = scene["ratio.step_greatest"];
        if (column.group != std::string(kRatioGroup) || name == "ratio.step_least" ||
            name == "ratio.step_greatest")
            return "";
        if (name == "ratio.step" && least && greatest && *least <= 1.0 && *greatest >= 1.0)
            return " no difference";
        return *scene[column.figure] < kSlower ? kSlowerWord : "";
    }

    void Layout(const SceneTable &layout) {
        if (!Has(m_numbers.scenes, layout))
            return;
        HtmlTable table;
        table.caption = layout.title;
        table.corner = "scene";
        for (const SceneColumn &column : layout.columns)
            table.columns.push_back({column.group, column.name});
        for (const SceneNumbers &scene : m_numbers.scenes) {
            std::vector<HtmlTable::Cell> row = {{scene.name}};
            for (const SceneColumn &column : layout.columns) {
                const std::optional<double> figure = scene[column.figure];
                const char *judged = figure ? Judged(scene, column) : "";
                row.push_back({figure ? Fixed(figure, column.decimals) + judged : "–",
                               !figure                              ? "none"
                               : std::string(judged) == kSlowerWord ? "bad"
                                                                    : ""});
            }
            table.rows.push_back(std::move(row));
        }
        Put(table, layout.legend);
    }

    void Events() {
        if (m_numbers.runs.empty())
            return;
        m_out << "<section id=\"events\">\n<h2>Events of the kinetic structures</h2>\n";
        Figures(EventPictures(m_numbers), true);
        for (const size_t n : m_numbers.Vertices()) {
            const std::vector<Run> runs = m_numbers.RunsOf(n);
            // One ratio among several n is for the plots against n.
            if (m_numbers.Vertices().size() > 1 && runs.back().ratioIndex == runs.front().ratioIndex)
                continue;
            Counts(runs);
            GrowthTable(runs);
        }
        Qualities();
        m_out << "</section>\n";
    }

    /// A column for each motion; the cell of a motion and a structure is what `text` makes of it.
    template <typename CellOf>
    void Structures(const std::vector<Run> &runs, const std::string &caption, const std::string &legend,
                    const CellOf &cellOf, std::vector<HtmlTable::Cell> lastRow = {}) {
        HtmlTable table;
        table.caption = caption;
        table.corner = "structure";
        for (const std::string &motion : MotionsOf(runs))
            table.columns.push_back({"", motion});
        bool any = false;
        for (const bmr_kds_info *structure : StructuresOf(runs)) {
            std::vector<HtmlTable::Cell> row = {{structure->name}};
            for (const std::string &motion : MotionsOf(runs)) {
                row.push_back(cellOf(motion, structure));
                any = any || row.back().text != "–";
            }
            table.rows.push_back(std::move(row));
        }
        if (!lastRow.empty())
            table.rows.push_back(std::move(lastRow));
        if (any)
            Put(table, {legend});
    }

    void Counts(const std::vector<Run> &runs) {
        size_t last = 0;
        double ratio = 0.0;
        for (const Run &run : runs)
            if (run.ratioIndex >= last) {
                last = run.ratioIndex;
                ratio = run.wantedRatio;
            }
        std::vector<HtmlTable::Cell> optimum = {{"optimum, offline"}};
        for (const std::string &motion : MotionsOf(runs)) {
            const std::optional<double> mean = MeanOptimum(runs, motion, last);
            optimum.push_back(mean ? HtmlTable::Cell{Fixed(mean, 1)} : HtmlTable::Cell{"–", "none"});
        }
        std::ostringstream caption;
        caption << "Events, n = " << runs.front().n;
        if (ratio > 0.0)
            caption << ", D/sigma = " << ratio;
        Structures(
            runs, caption.str(),
            "means over the motions of a kind; optimum: the least number of separating lines, known "
            "afterwards",
            [&](const std::string &motion, const bmr_kds_info *structure) {
                const std::optional<double> mean = MeanOver(runs, motion, structure, last, Quantity::Events);
                return mean ? HtmlTable::Cell{Fixed(mean, 1)} : HtmlTable::Cell{"–", "none"};
            },
            optimum);
    }

    void GrowthTable(const std::vector<Run> &runs) {
        Structures(
            runs, "Growth of events with D/sigma, n = " + std::to_string(runs.front().n),
            "the exponent, or +events per doubling where the bound is logarithmic; < the paper's bound, "
            "NO where the fit refutes it, ? where its interval reaches the bound and more; rivals have no "
            "bound",
            [&runs](const std::string &motion, const bmr_kds_info *structure) {
                const std::optional<Growth> growth = GrowthOf(runs, motion, structure, Quantity::Events);
                if (!growth)
                    return HtmlTable::Cell{"–", "none"};
                return HtmlTable::Cell{TextOf(*growth),
                                       growth->verdict == BoundVerdict::Refuted ? "bad" : ""};
            });
    }

    void Qualities() {
        HtmlTable table;
        table.caption = "The four qualities of a kinetic structure, and its hysteresis";
        table.corner = "structure";
        table.columns = {{"compact", "conditions"},       {"compact", "bytes"},
                         {"responsive: touched", "mean"}, {"responsive: touched", "most"},
                         {"local", "replanned"},          {"efficient", "events/external"},
                         {"hysteresis", "least rho"}};
        const std::vector<Run> &runs = m_numbers.runs;
        for (const bmr_kds_info *structure : StructuresOf(runs)) {
            const QualitySummary qualities = QualitiesOver(runs, structure);
            table.rows.push_back({{structure->name},
                                  {Fixed(qualities.conditions, 0)},
                                  {Fixed(qualities.bytes, 0)},
                                  {Fixed(qualities.touched, 1)},
                                  {Fixed(qualities.touchedMost, 0)},
                                  {Fixed(qualities.replanned, 0)},
                                  {Fixed(qualities.efficiency, 1)},
                                  {std::isfinite(qualities.rho) ? Fixed(qualities.rho, 3) : "–"}});
        }
        Put(table, {"over all runs; rho: the least change from event to event over the distance"});
    }

    void Costs() {
        const std::vector<Picture> pictures = CostPictures(m_numbers);
        if (pictures.empty())
            return;
        m_out << "<section id=\"costs\">\n<h2>How cost grows</h2>\n";
        Figures(pictures, true);
        m_out << "</section>\n";
    }

    void Figures(const std::vector<Picture> &pictures, bool withNumbers) {
        m_out << "<div class=\"figures\">\n";
        for (const Picture &picture : pictures) {
            std::ostringstream svg;
            WriteSvg(svg, picture);
            m_out << "<figure" << (withNumbers ? "" : " class=\"wide\"") << ">\n"
                  << "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\""
                  << Escaped(picture.Title()) << "\">"
                  << EmbeddedSvg(svg.str(), "f" + std::to_string(++m_figures) + "-", picture.Description())
                  << "</div>\n"
                  << "<figcaption>" << Escaped(picture.caption) << "</figcaption>\n";
            if (withNumbers)
                NumbersOf(std::get<Plot>(picture.plot));
            m_out << "</figure>\n";
        }
        m_out << "</div>\n";
    }

    /// The points of a plot as a table that opens.
    void NumbersOf(const Plot &plot) {
        std::map<double, std::vector<std::optional<double>>> rows;
        for (size_t i = 0; i < plot.series.size(); ++i)
            for (const bmr_vec2 &point : plot.series[i].points) {
                std::vector<std::optional<double>> &row = rows[point.x];
                row.resize(plot.series.size());
                row[i] = point.y;
            }
        HtmlTable table;
        table.caption = plot.title + ": " + plot.yLabel;
        table.corner = plot.xLabel;
        for (const PlotSeries &series : plot.series)
            table.columns.push_back({"", series.name});
        for (const auto &[x, values] : rows) {
            std::vector<HtmlTable::Cell> row = {{Fixed(x, x == std::floor(x) ? 0 : 1)}};
            for (const std::optional<double> &value : values)
                row.push_back(value ? HtmlTable::Cell{Fixed(value, *value < 1e4 ? 1 : 0)}
                                    : HtmlTable::Cell{"–", "none"});
            table.rows.push_back(std::move(row));
        }
        m_out << "<details><summary>Numbers of this plot</summary>\n";
        Put(table, {});
        m_out << "</details>\n";
    }

    void Put(const HtmlTable &table, const std::vector<std::string> &legend) {
        m_out << "<div class=\"table\">\n";
        table.Write(m_out, "t" + std::to_string(++m_tables));
        for (const std::string &line : legend)
            m_out << "<p class=\"legend\">" << Escaped(line) << "</p>\n";
        m_out << "</div>\n";
    }

    static constexpr const char *kWays[] = {"register", "linked", "preloaded"};
    std::ostream &m_out;
    const Numbers &m_numbers;
    int m_tables = 0, m_figures = 0;
};

} // namespace

std::vector<Picture> AllPictures(const Numbers &numbers) {
    std::vector<Picture> all = ScenePictures(numbers);
    for (auto *more : {&EventPictures, &CostPictures})
        for (Picture &picture : (*more)(numbers))
            all.push_back(std::move(picture));
    return all;
}

void WritePage(std::ostream &out, const Numbers &numbers, const ReportPage &page) {
    Writer(out, numbers).Write(page);
}

} // namespace testbed
