// SPDX-License-Identifier: MIT
#include "scene_tables.h"

namespace testbed {

const SceneTable &TestTable() {
    static const SceneTable table = {
        "Separation tests, calls per step",
        {
            {"", "bodies", "bodies", 0},
            {"", "contacts", "contacts", 0},
            {"polygon tests", "stock", "stock.polygon_tests_per_step", 1},
            {"polygon tests", "plugin", "plugin.polygon_tests_per_step", 1},
            {"of them apart", "stock", "stock.polygon_tests_apart_per_step", 1},
            {"of them apart", "saved %", "saved.polygon_tests_apart_percent", 1},
            {"TOI calls", "stock", "stock.toi_calls_per_step", 1},
            {"TOI calls", "plugin", "plugin.toi_calls_per_step", 1},
            {"b2Distance", "stock", "stock.distance_calls_per_step", 1},
            {"b2Distance", "plugin", "plugin.distance_calls_per_step", 1},
        },
        {
            "contacts: pairs whose fat boxes overlap, mean per step; polygon tests: b2CollidePolygons; "
            "apart: "
            "no point found",
            "TOI calls: b2TimeOfImpact; saved: of the tests that found stock's pairs apart, those that a "
            "certificate answered",
        }};
    return table;
}

const SceneTable &BudgetTable() {
    static const SceneTable table = {
        "How kinetic the world is: pairs and who was looked at, per step",
        {
            {"budgets of motion", "pairs", "ledger.pairs_per_step", 1},
            {"budgets of motion", "renewed", "ledger.renewals_per_step", 1},
            {"budgets of motion", "looks", "ledger.looks_per_step", 1},
            {"budgets of motion", "% looks", "ledger.looks_percent", 1},
            {"of certificates", "events", "events.all_per_step", 2},
            {"of certificates", "% events", "events.all_percent", 2},
        },
        {
            "pairs: contacts of bodies that are awake; renewed: by their own line, whose shapes and contact "
            "nobody "
            "read",
            "looks: whose contact or shapes were read; of all others nothing but a deadline was",
            "events: certificates made, replaced and given up, the hulls' among them; %: of the pairs",
        }};
    return table;
}

const SceneTable &EventTable() {
    static const SceneTable table = {
        "What the plugin did instead, per step",
        {
            {"certificate checks", "edge", "checks.edge_per_step", 1},
            {"certificate checks", "search", "plugin.edge_searches_per_step", 1},
            {"certificate checks", "kinetic", "checks.kinetic_per_step", 1},
            {"events", "start", "events.start_per_step", 2},
            {"events", "stab", "events.stab_per_step", 2},
            {"events", "push", "events.push_per_step", 2},
            {"events", "roll", "events.roll_per_step", 2},
            {"events", "coarsen", "events.coarsen_per_step", 2},
            {"events", "contact", "events.contact_per_step", 2},
            {"events", "leave", "events.leave_per_step", 2},
            {"answers", "apart", "plugin.proved_apart_per_step", 1},
            {"answers", "reused", "plugin.verdicts_reused_per_step", 1},
            {"answers", "hand-over", "events.hand_over_per_step", 1},
        },
        {
            "edge: one remembered edge asked again; search: all edges, when it failed; kinetic: a body "
            "pair's "
            "certificate asked again",
            "start, stab, push, roll, coarsen: the life of a certificate; contact: its end, the exact test "
            "is asked; leave: a new one",
            "apart: proved, without Box2D; reused: of those, by what was found at the same poses before; "
            "hand-over: the exact test",
        }};
    return table;
}

const SceneTable &VerifyTable() {
    static const SceneTable table = {"Every answer of the plugin beside Box2D's, in one process",
                                     {
                                         {"answers", "compared", "verify.compared", 0},
                                         {"answers", "different", "verify.differences", 0},
                                     },
                                     {}};
    return table;
}

SceneTable TimeTable(int repeat, bool accelerated) {
    SceneTable table = {
        "Time per step",
        {
            {"narrow phase, us", "stock", "stock.narrow_phase_us_per_step", 1},
            {"narrow phase, us", "linked", "plugin.narrow_phase_us_per_step", 1},
            {"narrow phase, us", "ratio", "ratio.narrow_phase", 2},
            {"whole step, us", "stock", "stock.step_us_per_step", 1, true},
            {"whole step, us", "linked", "plugin.step_us_per_step", 1, true},
            {kRatioGroup, "linked", "ratio.step", 2, true},
            {kRatioGroup, "from", "ratio.step_least", 2, true},
            {kRatioGroup, "to", "ratio.step_greatest", 2, true},
        },
        {"time: median of " + std::to_string(repeat) +
             " runs; ratio: stock / plugin, the median over pairs of runs; above 1 the plugin is faster",
         "from, to: the least and the greatest of the pairs, linked: a difference within them is noise"}};
    if (accelerated) {
        table.columns.push_back({kRatioGroup, "accelerated", "ratio_accelerated.step", 2, true});
        table.legend.emplace_back(
            "accelerated: Box2D compiled with the plugin, against stock's shared library");
    }
    return table;
}

const std::vector<std::string> &VerdictLegend() {
    static const std::vector<std::string> legend = {
        "linked: a program that was linked with the plugin; preloaded: stock's program, plugin in LD_PRELOAD",
        "accelerated: Box2D compiled with the plugin, where this was built with Box2D's sources",
        "bits: every body, contact, impulse and listener event of every step, hashed and compared",
        "question: a call of b2CollidePolygons, b2TimeOfImpact or b2Distance; event: of a certificate",
        "any-...: stock Box2D does not have these polygons; its place has the plugin told to be off "
        "(BOOMERANG=off)"};
    return legend;
}

} // namespace testbed
