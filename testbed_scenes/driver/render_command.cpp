// SPDX-License-Identifier: MIT
#include "commands.h"

#include <iostream>
#include <memory>

#include "pictures.h"
#include "terminal.h"

namespace testbed {
namespace {

struct RenderCommand {
    std::string scene;
    bool plugin = true;
    bool quiet = false;
    PictureRequest pictures;
    WorkerOptions worker;
};

/// The plugin's structures that pictures show.
const std::vector<std::string> kShownStructures = {"lazy-compass", "lazy-dudley", "free-direction"};

constexpr char kExamples[] = "Examples:\n"
                             "  boomerang-testbed render planks --step 150 -o planks.png\n"
                             "  boomerang-testbed render planks --step 150 --focus 12 -o why.svg\n"
                             "  boomerang-testbed render gears --frames 0:300:2 --all -o gears.png\n"
                             "  ffmpeg -i gears-%04d.png gears.webm";

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

int Execute(const RenderCommand &command, const Workers &workers) {
    PictureSeries series(command.pictures, PictureSource::Scene);
    Progress progress(1, command.quiet);
    AddScene(command, FindScene(workers.List(), command.scene), workers, &series, &progress);
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
    CLI::App *render =
        app.add_subcommand("render", "Draw a scene after a step, with what proves its bodies apart");
    render->add_option("scene", command.scene, "A name that `list` shows")->required();
    render->add_option("-o,--output", command.pictures.output, "The picture: .svg, .png or .pdf")->required();
    AddPictureOptions(*render, command.pictures, nullptr);
    render->add_flag("--quiet", command.quiet, "No progress, and no word of what was written");
    render->footer(std::string(kLayersHelp) + "\n\n" + kExamples);
    render
        ->add_option_function<std::string>(
            "--plugin", [&command](const std::string &value) { command.plugin = value == "on"; },
            "With the plugin, or stock Box2D (default: on)")
        ->check(CLI::IsMember({"on", "off"}));
    AddStructureOption(*render, command.worker, kShownStructures);
    AddSceneOptions(*render, command.worker);
    render->callback([kept, &program] { program.status = Execute(*kept, Workers(program.directory)); });
}

} // namespace testbed
