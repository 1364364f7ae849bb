// SPDX-License-Identifier: MIT
#include "pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "commands.h"
#include "drawing/canvas.h"
#include "picture/world_view.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

/// Margin around a periodic box, in parts of it: bodies reach over its sides.
constexpr double kAroundBox = 0.06;

/// Before the work: the picture must have a place.
void CheckOutput(const std::string &output) {
    if (!IsPicturePath(output))
        throw UsageError("\"" + output + "\" should end in .svg, .png or .pdf");
    CheckWritable(output);
}

/// "picture.png", 7 of 120: "picture-0007.png".
std::string NumberedPath(const std::string &output, int64_t index) {
    const fs::path path(output);
    char number[32];
    std::snprintf(number, sizeof number, "-%04lld", static_cast<long long>(index));
    return (path.parent_path() / (path.stem().string() + number + path.extension().string())).string();
}

void CheckBody(const PictureOptions &options, const shown::Frame &frame) {
    if (!options.body)
        return;
    int most = -1;
    bool isThere = false;
    for (const shown::Body &body : frame.bodies) {
        most = std::max(most, body.number);
        isThere = isThere || body.number == options.body;
    }
    if (!isThere)
        throw UsageError("--focus: there is no body " + std::to_string(*options.body) + " after step " +
                         std::to_string(frame.step) + "; the largest number is " + std::to_string(most));
}

Layers LayersOf(const PictureRequest &request, PictureSource source) {
    const Layers &named = request.named;
    const bool world = source == PictureSource::World;
    if (request.all)
        return {true, true, true, true, true, true, world, world};
    if (!world && (named.disks || named.trails))
        throw UsageError("--disks and --trails: of a kinetic world alone");
    const bool any = named.certificates || named.slack || named.handedOver || named.contacts ||
                     named.events || named.boxes || named.disks || named.trails;
    return any || request.bare ? named : Layers();
}

} // namespace

const char kLayersHelp[] =
    "With no layer named: certificates, slack, handed-over, contacts and events. With some named: those "
    "alone.\n\n"
    "Layers:\n"
    "  certificates  what proves a pair apart: the thick edge of one body and the vertex of the other that "
    "is "
    "nearest to its line;\n"
    "                or a direction (dashed); or two disks (dotted)\n"
    "  slack         how far apart that proves them, as colour\n"
    "  handed-over   diamonds: pairs that needed a manifold in this step\n"
    "  events        rings: pairs whose certificate began, failed or was replaced in this step\n\n"
    "With --focus on a body, the proofs of its nearest pairs are drawn in full, with how far apart they are.";

void AddPictureOptions(CLI::App &app, PictureRequest &request, CLI::Option *output) {
    std::vector<CLI::Option *> options;
    const auto add = [&options](CLI::Option *option) {
        options.push_back(option);
        return option;
    };
    CLI::Option *step =
        add(app.add_option("--step", request.step, "The step to draw; the first is 0")->check(Whole(0)));
    CLI::Option *frames =
        add(app.add_option("--frames", request.frames,
                           "FIRST:LAST:EVERY instead: a series; picture.png becomes picture-0000.png, ...")
                ->excludes(step));
    step->excludes(frames);
    add(app.add_option("--focus", request.focus,
                       "BODY: it and its pairs; or X,Y,WIDTH,HEIGHT, a rectangle of the "
                       "world from its lower left corner")
            ->check([](const std::string &text) {
                return text.empty() ? std::string("a body or a rectangle is wanted") : std::string();
            }));
    add(app.add_option("--width", request.width, "Width in pixels (points in an SVG or PDF)")
            ->check(Whole(200, 10000))
            ->capture_default_str());
    Layers &named = request.named;
    const auto layer = [&](const char *name, bool &flag, const std::string &what) {
        add(app.add_flag(name, flag, "Layer: " + what));
    };
    layer("--certificates", named.certificates, "what proves pairs apart");
    layer("--slack", named.slack, "how far apart, as colour");
    layer("--handed-over", named.handedOver, "pairs that needed a manifold");
    layer("--contacts", named.contacts, "contact points and normals");
    layer("--events", named.events, "what happened to certificates in the step");
    layer("--aabbs", named.boxes, "boxes of the broad phase; of a kinetic world, the cells of its bodies");
    layer("--disks", named.disks, "disks of bodies (of a kinetic world)");
    layer("--trails", named.trails, "where bodies were before (of a kinetic world)");
    CLI::Option *all = add(app.add_flag("--all", request.all, "Every layer"));
    add(app.add_flag("--bare", request.bare, "No layer: the bodies alone")->excludes(all));
    for (CLI::Option *option : options)
        if (output != nullptr)
            option->needs(output);
}

PictureSeries::PictureSeries(const PictureRequest &request, PictureSource source) : m_request(request) {
    if (!request.step && request.frames.empty())
        throw UsageError("which step? --step N, or --frames FIRST:LAST:EVERY for a series");
    ReadFocus();
    m_options.layers = LayersOf(request, source);
    m_options.width = request.width;
    CheckOutput(request.output);
    ReadRange();
}

void PictureSeries::ReadFocus() {
    const std::string &text = m_request.focus;
    if (text.empty())
        return;
    const std::string wanted = "a body or a rectangle X,Y,WIDTH,HEIGHT is wanted";
    const std::vector<double> numbers = NumbersIn(text, ',', -1e9, 1e9, "--focus", "number; " + wanted);
    const size_t count = numbers.size();
    if (count == 4 && numbers[2] > 0.0 && numbers[3] > 0.0) {
        m_options.region = {numbers[0], numbers[1], numbers[0] + numbers[2], numbers[1] + numbers[3]};
        return;
    }
    if (count != 1 || numbers[0] < 0.0 || numbers[0] != std::floor(numbers[0]))
        throw UsageError("--focus: " + wanted + ", not \"" + text + "\"");
    m_options.body = static_cast<int>(numbers[0]);
}

void PictureSeries::ReadRange() {
    if (m_request.frames.empty()) {
        m_first = m_last = *m_request.step;
        return;
    }
    constexpr double kMost = 100000000;
    const std::string wanted =
        "FIRST:LAST or FIRST:LAST:EVERY is wanted, with 0 <= FIRST <= LAST <= 100000000";
    std::vector<double> numbers =
        NumbersIn(m_request.frames, ':', 0.0, kMost, "--frames", "whole number; " + wanted, true);
    if (numbers.size() == 2)
        numbers.push_back(1.0);
    if (numbers.size() != 3 || numbers[1] < numbers[0] || numbers[2] < 1.0)
        throw UsageError("--frames: " + wanted + ", not \"" + m_request.frames + "\"");
    m_first = static_cast<int64_t>(numbers[0]);
    m_last = static_cast<int64_t>(numbers[1]);
    m_every = static_cast<int64_t>(numbers[2]);
    m_last -= (m_last - m_first) % m_every; // steps after the last picture are left out
}

void PictureSeries::CheckLast(const std::string &name, int64_t last) const {
    if (m_last > last)
        throw UsageError(std::string(IsNumbered() ? "--frames" : "--step") + ": the last step of " + name +
                         " is " + std::to_string(last) + ", not " + std::to_string(m_last));
}

void PictureSeries::Add(const shown::Frame &frame) {
    if (m_options.layers.trails)
        AddTrails(frame);
    if (frame.step < m_first || frame.step > m_last || (frame.step - m_first) % m_every != 0)
        return;
    CheckBody(m_options, frame);
    // A series holds still, or follows its body with a frame of one size.
    const std::optional<Rectangle> box = PeriodicBoxOf(frame);
    const bool whole = box && !m_options.body && !m_options.region;
    const Rectangle region = whole ? Widened(*box, kAroundBox) : RegionOf(frame, m_options);
    if (!m_shape)
        m_shape = region;
    PictureOptions these = m_options;
    const double x = m_options.body ? 0.5 * (region.left + region.right - m_shape->Width()) : m_shape->left;
    const double y =
        m_options.body ? 0.5 * (region.bottom + region.top - m_shape->Height()) : m_shape->bottom;
    these.region = {x, y, x + m_shape->Width(), y + m_shape->Height()};
    if (IsNumbered())
        AddContents(frame, these, &m_contents);
    m_pictures.push_back({frame, these});
}

void PictureSeries::AddTrails(const shown::Frame &frame) {
    constexpr size_t kPlaces = 60;
    for (const shown::Body &body : frame.bodies) {
        std::deque<bmr_vec2> &places = m_options.trails[body.number];
        places.push_back(ToVec2(body.pose.position));
        if (places.size() > kPlaces)
            places.pop_front();
    }
}

std::string PictureSeries::PathOf(size_t index) const {
    return IsNumbered() ? NumberedPath(m_request.output, static_cast<int64_t>(index)) : m_request.output;
}

void PictureSeries::Draw() {
    for (size_t i = 0; i < m_pictures.size(); ++i) {
        if (IsNumbered())
            m_pictures[i].options.series = m_contents;
        DrawPicture(m_pictures[i].frame, m_pictures[i].options, PathOf(i));
    }
}

std::string PictureSeries::Said() const {
    const size_t count = m_pictures.size();
    const bool many = count > 1;
    std::string text = PathOf(0);
    if (many)
        text += " to " + PathOf(count - 1);
    text += many ? ": " + std::to_string(count) + " pictures of " : ": ";
    return text + m_pictures.front().frame.scene + (many ? ", steps " : ", step ") + std::to_string(m_first) +
           (many ? " to " + std::to_string(m_last) : "");
}

} // namespace testbed
