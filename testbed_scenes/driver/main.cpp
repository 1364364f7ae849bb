// SPDX-License-Identifier: MIT
//
// boomerang-testbed: runs scenes on stock Box2D and on Box2D with the plugin, in processes of their own, and
// compares them. This file is its command line; commands.h says where its commands are.
#include <iostream>

#include "commands.h"

namespace testbed {
namespace {

constexpr char kExitCodes[] =
    "Exit codes: 0 done, nothing differs; 1 a difference was found; 2 the request makes no "
    "sense; 3 a worker failed, or the output could not be "
    "written.";

int Answer(int argc, char **argv) {
    CLI::App app("Scenes on stock Box2D and on Box2D with the Boomerang plugin, compared.",
                 "boomerang-testbed");
    Program program;
    app.require_subcommand(1);
    app.set_version_flag("--version", "boomerang-testbed " BOOMERANG_VERSION);
    app.add_option("--workers", program.directory,
                   "Directory of boomerang-scene and boomerang-scene-plugin (default: this program's own)")
        ->check(CLI::ExistingDirectory);
    for (const auto add : {AddList, AddCompare, AddRender, AddFigures, AddEvents, AddWorld})
        add(app, program);
    for (CLI::App *subcommand : app.get_subcommands({})) {
        const std::string own = subcommand->get_footer();
        subcommand->footer(own.empty() ? kExitCodes : own + "\n\n" + kExitCodes);
        subcommand->fallthrough(); // so that --workers may stand behind the command as well
    }

    app.footer(kExitCodes); // not before: commands would inherit it, and have it twice

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        if (error.get_exit_code() == 0)
            return app.exit(error); // help, or the version
        throw UsageError(ExplainUsage(app, error));
    }
    return program.status;
}

} // namespace
} // namespace testbed

int main(int argc, char **argv) {
    try {
        const int status = testbed::Answer(argc, argv);
        // What nobody could read was not done.
        if (!std::cout.flush())
            throw std::runtime_error("the output could not be written");
        return status;
    } catch (const std::invalid_argument &error) { // an option, a file, a world that cannot be
        std::cerr << "boomerang-testbed: " << error.what() << '\n';
        return testbed::kExitUsage;
    } catch (const std::exception &error) {
        std::cout.flush();
        std::cerr << "boomerang-testbed: " << error.what() << '\n';
        return testbed::kExitWorker;
    }
}
