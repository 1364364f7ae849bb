// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "command_line/nearest.h"
#include "commands.h"
#include "theory/figure.h"

namespace testbed {
namespace {

const FigureInfo &FindFigure(const std::string &name) {
    const std::vector<FigureInfo> &figures = AllFigures();
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&name](const FigureInfo &figure) { return name == figure.name; });
    if (found != figures.end())
        return *found;
    std::vector<std::string> names;
    for (const FigureInfo &figure : figures)
        names.emplace_back(figure.name);
    throw UsageError("there is no figure \"" + name + "\"" + command_line::NearestClause(name, names) +
                     " (--list shows all)");
}

void ListFigures() {
    constexpr size_t kNameWidth = 22, kSectionWidth = 18;
    for (const FigureInfo &figure : AllFigures()) {
        std::string line = figure.name;
        line.resize(std::max(kNameWidth, line.size() + 1), ' ');
        line += figure.section;
        line.resize(std::max(kNameWidth + kSectionWidth, line.size() + 1), ' ');
        std::cout << line << figure.title << '\n';
    }
}

void Draw(const FigureInfo &figure, const std::string &path) {
    Canvas canvas(path, figure.width, figure.height);
    figure.draw(canvas);
    canvas.Write();
    std::cout << path << '\n';
}

} // namespace

int Execute(const FiguresCommand &command) {
    std::vector<const FigureInfo *> wanted;
    for (const std::string &name : command.names)
        wanted.push_back(&FindFigure(name));
    if (command.list) {
        ListFigures();
        return kExitOk;
    }
    if (wanted.empty())
        for (const FigureInfo &figure : AllFigures())
            wanted.push_back(&figure);
    std::error_code error;
    std::filesystem::create_directories(command.directory, error);
    if (error)
        throw std::runtime_error("cannot make the directory " + command.directory + ": " + error.message());
    for (const FigureInfo *figure : wanted)
        for (const char *format : {"svg", "png"})
            if (command.format == format || command.format == "both")
                Draw(*figure,
                     (std::filesystem::path(command.directory) / figure->name).string() + "." + format);
    return kExitOk;
}

} // namespace testbed
