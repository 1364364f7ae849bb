// SPDX-License-Identifier: MIT
#include "commands.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "pictures.h"
#include "terminal.h"
#include "theory/course.h"

namespace testbed {
namespace {

struct RenderCommand {
    std::string scene;
    std::vector<std::string>
        polygons;        ///< or files of two polygons of one's own, A's and B's (one: both alike),
    std::string motion;  ///< and of their motion,
    int64_t steps = 300; ///< which takes so many steps
    bool plugin = true;
    bool quiet = false;
    PictureRequest pictures;
    WorkerOptions worker;
};

/// The plugin's structures that pictures show.
const std::vector<std::string> kShownStructures = {"lazy-compass", "lazy-dudley", "free-direction"};

constexpr char kExamples[] =
    "Examples:\n"
    "  boomerang-testbed render planks --step 150 -o planks.png\n"
    "  boomerang-testbed render planks --step 150 --focus 12 -o why.svg\n"
    "  boomerang-testbed render gears --frames 0:300:2 --all -o gears.png\n"
    "  ffmpeg -i gears-%04d.png gears.webm\n"
    "  boomerang-testbed render --polygon A.txt --polygon B.txt --motion M.txt --frames 0:300:10 --all -o "
    "pair.png";

/// The polygon of a file. Throws UsageError where the picture would show another than was meant: the hull of
/// points that are not in convex position, or less than a triangle.
std::shared_ptr<const Body> ReadBody(const std::string &path) {
    const std::vector<bmr_vec2> points = ReadPolygonFile(path);
    auto body = std::make_shared<const Body>(points);
    const std::vector<bmr_vec2> corners = body->Vertices();
    if (corners.size() < 3)
        throw UsageError(path + ": a polygon has three corners or more that are not on one line");
    const double tolerance = 1e-9 * bmr_polygon_diameter(body->Polygon());
    for (const bmr_vec2 &point : points) {
        double depth = HUGE_VAL; // behind the nearest edge
        for (size_t i = 0; i < corners.size(); ++i) {
            const bmr_vec2 edge = bmr_sub(corners[(i + 1) % corners.size()], corners[i]);
            depth = std::min(depth, bmr_cross(edge, bmr_sub(point, corners[i])) / std::hypot(edge.x, edge.y));
        }
        if (!(depth <= tolerance))
            throw UsageError(path + ": the polygon is not convex: (" + General(point.x) + ", " +
                             General(point.y) + ") lies inside of the others");
    }
    return body;
}

/// Two polygons of one's own on their motion.
void AddPair(const RenderCommand &command, PictureSeries *series, Progress *progress) {
    const std::string &name = command.worker.structure;
    const bmr_kds_info *structure = nullptr;
    if (bmr_kds_find(name.empty() ? "lazy-compass" : name.c_str(), &structure) != BMR_OK)
        throw UsageError("--structure: " + name +
                         " is the plugin's; of two polygons of one's own it is one of the paper's "
                         "(events --list shows all)");
    const auto a = ReadBody(command.polygons.front()), b = ReadBody(command.polygons.back());
    const Course course(a, b, ReadMotionFile(command.motion));
    if (!Takes(*structure, course))
        throw UsageError(std::string("--structure: ") + structure->name +
                         " does not take two polygons that turn");
    const std::string scene = std::filesystem::path(command.motion).filename().string();
    VisitFrames(course, *structure, command.steps, [&](shown::Frame frame) {
        frame.scene = scene;
        series->Add(frame);
        progress->Show(scene, static_cast<double>(frame.step) / static_cast<double>(command.steps));
    });
}

/// Runs a worker, whose frames are those that the series wants.
void AddScene(const RenderCommand &command, const SceneInfo &scene, const Workers &workers,
              PictureSeries *series, Progress *progress) {
    WorkerRequest request;
    request.side = command.plugin ? Side::Plugin : StockFor(scene);
    request.scene = scene.name;
    request.steps = series->Last() + 1;
    request.mode = "hash";
    request.extra = {"--frames", std::to_string(series->First()) + ":" + std::to_string(series->Last()) +
                                     ":" + std::to_string(series->Every())};
    const int64_t wanted = (series->Last() - series->First()) / series->Every() + 1;
    int64_t frames = 0;
    progress->Show(scene.name);
    workers.Run(request, command.worker, [&](const std::string &line) {
        ++frames;
        series->Add(shown::ParseFrame(line));
        progress->Show(scene.name, static_cast<double>(frames) / static_cast<double>(wanted));
    });
    if (frames != wanted)
        throw WorkerError(scene.name + ": ended after " + std::to_string(frames) + " frames");
}

/// Throws UsageError unless the command says what to draw, once.
void CheckSource(const RenderCommand &command) {
    const bool pair = !command.polygons.empty() || !command.motion.empty();
    if (!pair) {
        if (command.scene.empty())
            throw UsageError("a scene is wanted, or --polygon A --polygon B --motion M");
        return;
    }
    if (command.polygons.empty() || command.polygons.size() > 2 || command.motion.empty())
        throw UsageError("--polygon A --polygon B --motion M: two polygons of one's own need them all (one "
                         "--polygon: both alike)");
    if (!command.scene.empty())
        throw UsageError("a scene, or --polygon and --motion: one of the two");
    if (command.worker.size || command.worker.seed)
        throw UsageError("--size and --seed are a scene's");
}

int Execute(const RenderCommand &command, const std::string &workersDirectory) {
    CheckSource(command);
    const bool pair = !command.polygons.empty();
    PictureSeries series(command.pictures, pair ? PictureSource::Pair : PictureSource::Scene);
    Progress progress(1, command.quiet);
    if (pair) {
        series.CheckLast("the motion", command.steps);
        AddPair(command, &series, &progress);
    } else {
        const std::string &structure = command.worker.structure;
        if (!structure.empty() &&
            std::count(kShownStructures.begin(), kShownStructures.end(), structure) == 0)
            throw UsageError("--structure: " + structure +
                             " is for --polygon and --motion; of a scene it is lazy-compass, lazy-dudley or "
                             "free-direction");
        const Workers workers(workersDirectory);
        AddScene(command, FindScene(workers.List(), command.scene), workers, &series, &progress);
    }
    series.Draw();
    progress.Clear();
    if (!command.quiet)
        std::cout << series.Said() << '\n';
    return kExitOk;
}

} // namespace

void AddRender(CLI::App &app, Program &program) {
    const auto kept = std::make_shared<RenderCommand>();
    RenderCommand &command = *kept;
    CLI::App *render = app.add_subcommand(
        "render", "Draw a scene, or two polygons of one's own, after a step, with what proves them apart");
    render->add_option("scene", command.scene, "A name that `list` shows");
    CLI::Option *polygon = render->add_option("--polygon", command.polygons,
                                              "Instead of a scene: a polygon of one's own, as for `events`; "
                                              "twice: A's and B's");
    polygon->check(CLI::ExistingFile)->allow_extra_args(false);
    render
        ->add_option("--motion", command.motion,
                     "Their motion, in the statements that `events --help` explains")
        ->check(CLI::ExistingFile);
    render
        ->add_option("--steps", command.steps,
                     "Into how many steps the motion's time is divided: the last picture is --step N")
        ->check(Whole(1, 1000000))
        ->needs(polygon)
        ->capture_default_str();
    render->add_option("-o,--output", command.pictures.output, "The picture: .svg, .png or .pdf")->required();
    AddPictureOptions(*render, command.pictures, nullptr);
    render->add_flag("--quiet", command.quiet, "No progress, and no word of what was written");
    render->footer(std::string(kLayersHelp) + "\n\n" + kExamples);
    AddPluginSwitch(*render, command.plugin);
    std::vector<std::string> structures =
        kShownStructures; // and of two polygons of one's own those of the paper
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        if (std::find(structures.begin(), structures.end(), bmr_kds_at(i)->name) == structures.end())
            structures.emplace_back(bmr_kds_at(i)->name);
    AddStructureOption(*render, command.worker, structures);
    AddSceneOptions(*render, command.worker);
    render->callback([kept, &program] { program.status = Execute(*kept, program.directory); });
}

} // namespace testbed
