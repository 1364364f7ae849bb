// SPDX-License-Identifier: MIT
//
// boomerang-testbed draw: has a worker print the outline of its world, and makes a picture of it.
#include <iostream>
#include <sstream>

#include "commands.h"
#include "drawing/surface.h"
#include "picture.h"
#include "progress.h"

namespace testbed {
namespace {

std::vector<Point> ReadPoints(std::istringstream &words) {
    std::vector<Point> points;
    Point point;
    while (words >> point.x >> point.y)
        points.push_back(point);
    return points;
}

bool ReadShape(const std::string &kind, std::istringstream &words, Outline &outline) {
    Outline::Shape shape;
    if (!(words >> shape.body >> shape.state))
        return false;
    if (kind == "circle") {
        shape.kind = Outline::Kind::Circle;
        shape.points.resize(1);
        if (!(words >> shape.points[0].x >> shape.points[0].y >> shape.radius >> shape.angle))
            return false;
    } else {
        shape.kind = kind == "polygon" ? Outline::Kind::Polygon : Outline::Kind::Chain;
        shape.points = ReadPoints(words);
        if (shape.points.size() < 2)
            return false;
    }
    outline.shapes.push_back(std::move(shape));
    return true;
}

bool ReadLine(std::istringstream &words, Outline &outline) {
    std::string head, kind;
    if (!(words >> head >> kind) || head != "outline")
        return false;
    if (kind == "polygon" || kind == "circle" || kind == "chain")
        return ReadShape(kind, words, outline);
    Outline::Pair pair;
    if (kind == "pair") {
        int bodyA = 0, bodyB = 0;
        if (!(words >> bodyA >> bodyB >> pair.a.x >> pair.a.y >> pair.b.x >> pair.b.y >> pair.slack))
            return false;
        outline.pairs.push_back(pair);
        return true;
    }
    if (kind == "joint") {
        if (!(words >> pair.a.x >> pair.a.y >> pair.b.x >> pair.b.y))
            return false;
        outline.joints.push_back(pair);
        return true;
    }
    if (kind == "point" && words >> pair.a.x >> pair.a.y) {
        outline.contacts.push_back(pair.a);
        return true;
    }
    return false;
}

} // namespace

void ParseOutlineLine(const std::string &line, Outline &outline) {
    std::istringstream words(line);
    if (!ReadLine(words, outline))
        throw WorkerError("printed an outline that cannot be read: \"" + line + "\"");
}

int Execute(const DrawCommand &command, const Workers &workers) {
    if (!IsPicturePath(command.output))
        throw UsageError("\"" + command.output + "\" should end in .svg, .png or .pdf");
    const SceneInfo scene = FindScene(workers.List(), command.scene);
    WorkerRequest request;
    request.side = command.plugin ? Side::Plugin : Side::Stock;
    request.scene = scene.name;
    request.steps = command.step + 1;
    request.extra = {"--outline", std::to_string(command.step)};

    Outline outline;
    const auto process = workers.Start(request, command.worker, [&outline](const std::string &line) {
        if (!IsStepLine(line) && !IsSummaryLine(line))
            ParseOutlineLine(line, outline);
    });
    Progress progress(1, false);
    progress.Show(scene.name, 0.0);
    RunAll({process.get()}, [&progress] { progress.Tick(); });
    progress.Clear();
    if (!process->Succeeded())
        throw WorkerError(process->Describe());
    if (outline.shapes.empty())
        throw WorkerError(process->CommandLine() + ": there is nothing to draw at that step");
    DrawPicture(outline, scene.name + ", step " + std::to_string(command.step), command.output,
                command.width);
    return kExitOk;
}

} // namespace testbed
