// SPDX-License-Identifier: MIT
//
// The command line of `boomerang-testbed world`: what may be chosen, and what makes no sense.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <CLI/CLI.hpp>

#include "boomerang/families.h"
#include "command_line/nearest.h"
#include "command_line/usage.h"
#include "commands.h"

namespace testbed {
namespace {

constexpr char kNotes[] =
    "Lengths are in radii of the smallest body's disk. Polygons have the density 1, "
    "and their origins at their "
    "centres of mass.\nThe answer is elastic, stick, pass (through each other), or a "
    "number: the restitution, "
    "from 0 to 1.\n--zeno: what becomes of infinitely many contacts in finite time: an "
    "error that says so, or slow "
    "ones are answered elastically.\n--picture: the run after a step, or a series (a step "
    "is 1 / --rate of a unit of time).\n\nExample:\n"
    "  boomerang-testbed world gas --picture gas.png --frames 0:600:10 --all\n\n";

/// A number of at least `least` (or above it) and at most `most`; CLI11's own range lets NaN pass.
double Checked(const char *option, double value, double least, double most, bool above = false) {
    if (value >= least && value <= most && !(above && value == least))
        return value;
    char text[160];
    std::snprintf(text, sizeof text, "%s: a number %s %g to %g is wanted, not %g", option,
                  above ? "above" : "from", least, most, value);
    throw UsageError(text);
}

/// "12" or "8:64".
void ReadVertices(const std::string &text, WorldChoice *choice) {
    unsigned long fewest = 0, most = 0;
    char rest = 0;
    const int read = std::sscanf(text.c_str(), "%lu:%lu%c", &fewest, &most, &rest);
    if (read == 1 && text.find(':') == std::string::npos)
        most = fewest;
    else if (read != 2)
        fewest = 0;
    if (fewest < 3 || most < fewest || most > 65535 || text[0] == '-')
        throw UsageError("--vertices: N or FEWEST:MOST is wanted, from 3 to 65535, not \"" + text + "\"");
    choice->fewestVertices = fewest;
    choice->mostVertices = most;
}

void ReadAnswer(const std::string &text, WorldChoice *choice) {
    if (text == "elastic")
        choice->response = {BMR_RESPONSE_IMPULSE, 1.0};
    else if (text == "stick")
        choice->response = {BMR_RESPONSE_STICK, 0.0};
    else if (text == "pass")
        choice->response = {BMR_RESPONSE_PASS, 0.0};
    else {
        char *end = nullptr;
        const double restitution = std::strtod(text.c_str(), &end);
        if (end == text.c_str() || *end != '\0')
            throw UsageError("--answer: elastic, stick, pass or a restitution is wanted, not \"" + text +
                             "\"" + command_line::NearestClause(text, {"elastic", "stick", "pass"}));
        choice->response = {BMR_RESPONSE_IMPULSE, Checked("--answer", restitution, 0.0, 1.0)};
    }
}

void ReadStructure(const std::string &name, WorldChoice *choice) {
    const bmr_kds_info *info = nullptr;
    if (bmr_kds_find(name.c_str(), &info) != BMR_OK) {
        std::vector<std::string> names;
        for (size_t i = 0; i < bmr_kds_count(); ++i)
            if (bmr_kds_at(i)->domain == BMR_KDS_RIGID)
                names.emplace_back(bmr_kds_at(i)->name);
        FailUnknown("structure", name, names, "`events --list` shows all");
    }
    if (info->domain != BMR_KDS_RIGID)
        throw UsageError("--structure: " + name + " is for points or for bodies that do not turn");
    choice->structure = name;
}

const WorldScene &SceneNamed(const std::string &name) {
    std::vector<std::string> names;
    for (const WorldScene &scene : WorldScenes()) {
        if (scene.choice.scene == name)
            return scene;
        names.push_back(scene.choice.scene);
    }
    FailUnknown("world", name, names);
}

std::vector<std::string> ShapeNames() {
    std::vector<std::string> names = {"mixed"};
    for (int outline = 0; outline < BMR_OUTLINE_COUNT; ++outline)
        names.emplace_back(bmr_outline_name(static_cast<bmr_outline>(outline)));
    return names;
}

} // namespace

CLI::App *AddWorld(CLI::App &app, WorldCommand &command) {
    CLI::App *world = app.add_subcommand(
        "world", "Run a kinetic world of many polygons, event by event: what happened, and what it cost");
    world->add_option("scene", command.scene, "A world that --list shows")->capture_default_str();
    world
        ->add_option("--bodies", command.bodies, "How many (default: the scene's own, as of all that follow)")
        ->check(CLI::Range(2, 10000000));
    world->add_option("--shape", command.shape, "Outline of the polygons; mixed: all in turn")
        ->check(CLI::IsMember(ShapeNames()));
    world->add_option("--vertices", command.vertices, "N, or FEWEST:MOST, from which each body draws");
    world->add_option("--sizes", command.sizes,
                      "Radius of the largest over that of the smallest, from 1 to 1000 (beyond, a contact's "
                      "margin, 1e-6 of the smallest, is too little for proofs about the largest)");
    world->add_option("--density", command.density, "The polygons' area over the box's");
    world->add_option(
        "--speed", command.speed,
        "On average, of the largest; smaller ones have the same energy (bullet: a hundredth of its own)");
    world->add_option("--seconds", command.seconds, "Units of time to simulate");
    world
        ->add_option("--boundary", command.boundary,
                     "walls, periodic (what leaves on one side comes in on the other) or open")
        ->check(CLI::IsMember({"walls", "periodic", "open"}));
    world->add_option("--answer", command.answer, "To contacts: elastic, stick, pass, or a restitution");
    world->add_option("--zeno", command.zeno, "error or elastic")->check(CLI::IsMember({"error", "elastic"}));
    world->add_option("--zeno-speed", command.zenoSpeed, "Of --zeno elastic: slower than this is slow");
    world->add_option("--structure", command.structure, "Of near pairs; `events --list` shows all");
    world->add_option("--seed", command.seed, "Of all that is drawn")
        ->check(command_line::CheckSeed)
        ->capture_default_str();
    world->add_flag("--all-pairs", command.allPairs,
                    "No cells: every two bodies are watched, for comparison");
    world->add_flag("--check", command.check,
                    "At the end, look for overlaps of any two bodies by brute force");
    world->add_flag("--audit", command.audit, "Prove every certificate again, four times in the run");
    CLI::Option *growth = world->add_option(
        "--growth", command.growth,
        "Instead of one run: these numbers of bodies N1,N2,.. at the same density, as a table");
    growth->check(CLI::Validator(
        [](const std::string &text) {
            return text.empty() ? std::string("N1,N2,.. is wanted") : std::string();
        },
        "N1,N2,.."));
    CLI::Option *picture = world->add_option("--picture", command.pictures.output,
                                             "Draw the run into this file: .svg, .png or .pdf");
    world->add_option("--rate", command.rate, "Steps of --picture in a unit of time")
        ->needs(picture)
        ->capture_default_str();
    AddPictureOptions(*world, command.pictures, picture);
    growth->excludes(picture);
    world->add_flag("--quiet", command.quiet, "No tables");
    world->add_flag("--list", command.list, "Show the scenes, and run nothing");
    world->footer(std::string(kNotes) + kLayersHelp);
    return world;
}

WorldChoice ChoiceFor(const WorldCommand &command) {
    WorldChoice choice = SceneNamed(command.scene).choice;
    constexpr double kMost = 1e6;
    // A contact's margin is 1e-6 of the smallest radius: of larger ones it would be too little for proofs.
    constexpr double kMostSizes = 1e3;
    choice.bodies = command.bodies.value_or(choice.bodies);
    choice.shape = command.shape.value_or(choice.shape);
    if (command.vertices)
        ReadVertices(*command.vertices, &choice);
    choice.sizes = Checked("--sizes", command.sizes.value_or(choice.sizes), 1.0, kMostSizes);
    choice.density = Checked("--density", command.density.value_or(choice.density), 0.0, 1.0, true);
    choice.speed = Checked("--speed", command.speed.value_or(choice.speed), 0.0, kMost);
    choice.seconds = Checked("--seconds", command.seconds.value_or(choice.seconds), 0.0, kMost, true);
    if (command.boundary)
        choice.boundary = *command.boundary == "open"    ? BMR_OPEN
                          : *command.boundary == "walls" ? BMR_WALLED
                                                         : BMR_PERIODIC;
    if (command.answer)
        ReadAnswer(*command.answer, &choice);
    if (command.zeno)
        choice.zeno = *command.zeno == "error" ? BMR_ZENO_ERROR : BMR_ZENO_ELASTIC;
    choice.zenoSpeed =
        Checked("--zeno-speed", command.zenoSpeed.value_or(choice.zenoSpeed), 0.0, kMost, true);
    if (command.zenoSpeed && choice.zeno == BMR_ZENO_ERROR)
        throw UsageError("--zeno-speed: there is none without --zeno elastic");
    if (command.structure)
        ReadStructure(*command.structure, &choice);
    choice.seed = command.seed;
    choice.allPairs = command.allPairs;
    return choice;
}

} // namespace testbed
