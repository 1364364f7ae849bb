// SPDX-License-Identifier: MIT
#include "manual_command.h"

#include <iostream>

#include <CLI/CLI.hpp>

#include "boomerang/families.h"
#include "commands.h"
#include "manual/completion.h"
#include "manual/man_page.h"
#include "output_file.h"
#include "theory/experiment.h"
#include "theory/figure.h"

namespace testbed {
namespace {

KnownWords WordsOf(const Workers &workers) {
    KnownWords words;
    for (const SceneInfo &scene : workers.List())
        words["scene"].push_back(scene.name);
    words["scenes"] = words["scene"];
    for (const FigureInfo &figure : AllFigures())
        words["names"].emplace_back(figure.name);
    for (int i = 0; i < BMR_FAMILY_COUNT; ++i)
        words["motions"].emplace_back(bmr_family_name(static_cast<bmr_family>(i)));
    words["structures"] = {"all", "points", "translation", "rigid", "rivals"};
    for (size_t i = 0; i < bmr_kds_count(); ++i)
        words["structures"].emplace_back(bmr_kds_at(i)->name);
    return words;
}

void WriteMan(std::ostream &out, const CLI::App &app) {
    ManPage page;
    page.version = "boomerang " BOOMERANG_VERSION;
    page.brief = "compare Box2D with and without the Boomerang plugin";
    page.sections = {
        {"EXIT STATUS",
         {"0\tdone, and nothing differs", "1\ta difference was found", "2\tthe request makes no sense",
          "3\ta worker failed, or the output could not be written"}},
        {"ENVIRONMENT",
         {"NO_COLOR\tif not empty, no colours on a terminal; elsewhere there are none anyway",
          "TERM\tdumb: neither colours nor a progress bar"}},
        {"EXAMPLES",
         {"boomerang-testbed compare needles pyramid\tBox2D with the plugin against stock Box2D, in two "
          "scenes",
          "boomerang-testbed compare --json all.json\tall scenes, every figure into a file",
          "boomerang-testbed events orbit --ratios 8:2048\tthe paper's structures along one motion"}},
        {"NOTES",
         {"Scenes run in processes of their own, boomerang-scene and boomerang-scene-plugin, which lie "
          "beside "
          "the program unless --workers says otherwise: a process that has seen the plugin is no "
          "reference."}}};
    WriteManPage(out, Describe(app, {}), page);
}

} // namespace

void AddManual(CLI::App &app, ManualCommand &command) {
    CLI::App *completion =
        app.add_subcommand("completion", "Write a script that completes this command line in a shell");
    completion->add_option("shell", command.shell, "The shell")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    CLI::App *man = app.add_subcommand("man", "Write the manual page, for man -l");
    for (CLI::App *each : {completion, man})
        each->add_option("-o,--output", command.output, "A file (default: standard output)");
}

bool WantsManual(const CLI::App &app) {
    return app.got_subcommand("man") || app.got_subcommand("completion");
}

int Execute(const ManualCommand &command, const CLI::App &app, const std::string &workersDirectory) {
    OutputFile file(command.output);
    std::ostream &out = file.IsWanted() ? file.Stream() : std::cout;
    if (command.shell.empty()) {
        WriteMan(out, app);
    } else {
        const CommandDescription program = Describe(app, WordsOf(Workers(workersDirectory)));
        if (command.shell == "bash")
            WriteBashCompletion(out, program);
        else if (command.shell == "zsh")
            WriteZshCompletion(out, program);
        else
            WriteFishCompletion(out, program);
    }
    if (file.IsWanted())
        file.Close();
    return kExitOk;
}

} // namespace testbed
