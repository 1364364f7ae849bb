// SPDX-License-Identifier: MIT
//
// boomerang-testbed render: has a worker record its world, and makes pictures of it.
#include "commands.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "drawing/surface.h"
#include "drawing/whole_file.h"
#include "picture/world_view.h"
#include "progress.h"
#include "recorded_run.h"

namespace testbed {
namespace {

namespace fs = std::filesystem;

/// Room around a periodic box, in parts of it: bodies reach over its sides.
constexpr double kAroundBox = 0.06;
constexpr char kRenderHelp[] =
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
    "With --focus on a body, every pair of it is numbered, drawn in full and explained in words beside the "
    "picture.\n\n"
    "Examples:\n"
    "  boomerang-testbed render planks --step 150 -o planks.png\n"
    "  boomerang-testbed render planks --step 150 --focus 12 -o why.svg\n"
    "  boomerang-testbed world gas --record gas.txt && boomerang-testbed render --recording gas.txt --step "
    "90 --all "
    "-o gas.png\n"
    "  boomerang-testbed render gears --frames 0:300:2 --all -o gears.png\n"
    "  ffmpeg -i gears-%04d.png gears.webm";

/// Numbers between commas; empty if the text is anything else.
std::vector<double> ReadNumbers(const std::string &text) {
    std::vector<double> numbers;
    std::istringstream stream(text);
    for (std::string word; std::getline(stream, word, ',');) {
        std::size_t used = 0;
        try {
            numbers.push_back(std::stod(word, &used));
        } catch (const std::exception &) {
            return {};
        }
        if (used != word.size() || !std::isfinite(numbers.back()))
            return {};
    }
    return !text.empty() && text.back() == ',' ? std::vector<double>() : numbers;
}

bool IsNumberOfABody(double number) {
    return number >= 0.0 && number <= 1e9 && number == std::floor(number);
}

void ReadFocus(const std::string &text, PictureOptions *options) {
    if (text.empty())
        return;
    const std::vector<double> numbers = ReadNumbers(text);
    if ((numbers.size() == 1 || numbers.size() == 2) &&
        std::all_of(numbers.begin(), numbers.end(), IsNumberOfABody)) {
        for (const double number : numbers)
            options->bodies.push_back(static_cast<int>(number));
        if (numbers.size() == 2 && numbers[0] == numbers[1])
            throw UsageError("--focus: two different bodies are wanted, not \"" + text + "\"");
        return;
    }
    if (numbers.size() == 4 && numbers[2] > 0.0 && numbers[3] > 0.0) {
        options->region = {numbers[0], numbers[1], numbers[0] + numbers[2], numbers[1] + numbers[3]};
        return;
    }
    throw UsageError("--focus: a body, two bodies A,B or a rectangle X,Y,WIDTH,HEIGHT is wanted, not \"" +
                     text + "\"");
}

Layers LayersOf(const RenderCommand &command) {
    const Layers &named = command.named;
    if (command.all)
        return {true, true, true, true, true, true, true, true, !command.recording.empty()};
    const bool any = named.certificates || named.slack || named.handedOver || named.contacts ||
                     named.events || named.hulls || named.envelopes || named.boxes || named.trails;
    return any || command.bare ? named : Layers();
}

void ReadRange(const RenderCommand &command, RecordRequest *request) {
    if (command.frames.empty()) {
        request->first = request->last = *command.step;
        return;
    }
    long long first = 0, last = 0, every = 1;
    char rest = 0;
    const int read = std::sscanf(command.frames.c_str(), "%lld:%lld:%lld%c", &first, &last, &every, &rest);
    const bool isWhole = read == 3 || (read == 2 && command.frames.back() != ':');
    constexpr long long kMost = 100000000;
    if (!isWhole || first < 0 || last < first || last > kMost || every < 1)
        throw UsageError("--frames: FIRST:LAST or FIRST:LAST:EVERY is wanted, with 0 <= FIRST <= LAST <= " +
                         std::to_string(kMost) + ", not \"" + command.frames + "\"");
    request->first = first;
    request->every = every;
    request->last = last - (last - first) % every; // nobody looks at what comes after the last picture
}

/// Before the work: the picture must have a place.
void CheckOutput(const std::string &output) {
    if (!IsPicturePath(output))
        throw UsageError("\"" + output + "\" should end in .svg, .png or .pdf");
    WholeFile::Check(output);
}

/// "picture.png", 7 of 120: "picture-0007.png".
std::string NumberedPath(const std::string &output, int64_t index) {
    const fs::path path(output);
    char number[32];
    std::snprintf(number, sizeof number, "-%04lld", static_cast<long long>(index));
    return (path.parent_path() / (path.stem().string() + number + path.extension().string())).string();
}

void CheckBodies(const PictureOptions &options, const recording::Frame &frame) {
    for (const int number : options.bodies) {
        int most = -1;
        bool isThere = false;
        for (const recording::Body &body : frame.bodies) {
            most = std::max(most, body.number);
            isThere = isThere || body.number == number;
        }
        if (!isThere)
            throw UsageError("--focus: there is no body " + std::to_string(number) + " after step " +
                             std::to_string(frame.step) + "; the largest number is " + std::to_string(most));
    }
}

/// The pictures of those frames that are wanted. They are drawn once all have come, for one legend explains
/// what any of them holds.
class Series {
public:
    Series(const RenderCommand &command, const PictureOptions &options, const RecordRequest &wanted)
        : m_command(command), m_options(options), m_wanted(wanted) {}

    void Add(const recording::Head &head, const recording::Frame &frame) {
        m_gathered.Add(frame);
        m_head = head;
        m_last = frame.step;
        if (m_options.layers.trails)
            AddTrails(frame);
        if (frame.step < m_wanted.first || frame.step > m_wanted.last ||
            (frame.step - m_wanted.first) % m_wanted.every != 0)
            return;
        CheckBodies(m_options, frame);
        // A series holds still, or follows its bodies with a frame of one size.
        const std::optional<Rectangle> box = PeriodicBoxOf(head);
        const bool whole = box && m_options.bodies.empty() && !m_options.region;
        const Rectangle region = whole ? Widened(*box, kAroundBox) : RegionOf(frame, m_gathered, m_options);
        if (!m_shape)
            m_shape = region;
        PictureOptions these = m_options;
        const double x =
            m_options.bodies.empty() ? m_shape->left : 0.5 * (region.left + region.right - m_shape->Width());
        const double y = m_options.bodies.empty() ? m_shape->bottom
                                                  : 0.5 * (region.bottom + region.top - m_shape->Height());
        these.region = {x, y, x + m_shape->Width(), y + m_shape->Height()};
        if (IsNumbered())
            AddContents(head, frame, m_gathered, these, &m_contents);
        m_pictures.push_back({frame, these});
    }
    void Draw() {
        for (size_t i = 0; i < m_pictures.size(); ++i) {
            if (IsNumbered())
                m_pictures[i].options.series = m_contents;
            DrawPicture(m_head, m_pictures[i].frame, m_gathered, m_pictures[i].options,
                        IsNumbered() ? NumberedPath(m_command.output, static_cast<int64_t>(i))
                                     : m_command.output);
        }
    }
    /// What was written, in a line.
    std::string Said() const {
        const int64_t count = static_cast<int64_t>(m_pictures.size());
        const bool many = count > 1;
        std::string text = IsNumbered() ? NumberedPath(m_command.output, 0) : m_command.output;
        if (many)
            text += " to " + NumberedPath(m_command.output, count - 1);
        text += many ? ": " + std::to_string(count) + " pictures of " : ": ";
        return text + m_head.scene + (many ? ", steps " : ", step ") + std::to_string(m_wanted.first) +
               (many ? " to " + std::to_string(m_wanted.last) : "");
    }
    /// Where the frames came from a file, which may have fewer than are wanted.
    void CheckDone() const {
        if (m_wanted.last > m_last)
            throw UsageError("the last frame of " + m_wanted.scene + " is " + std::to_string(m_last) +
                             ", not " + std::to_string(m_wanted.last));
    }

private:
    struct Picture {
        recording::Frame frame;
        PictureOptions options;
    };

    bool IsNumbered() const { return !m_command.frames.empty(); }
    void AddTrails(const recording::Frame &frame) {
        constexpr size_t kPlaces = 60;
        for (const recording::Body &body : frame.bodies) {
            std::deque<bmr_vec2> &places = m_options.trails[body.number];
            places.push_back(bmr_vec2_make(static_cast<double>(body.pose.position.x),
                                           static_cast<double>(body.pose.position.y)));
            if (places.size() > kPlaces)
                places.pop_front();
        }
    }

    const RenderCommand &m_command;
    PictureOptions m_options;
    const RecordRequest &m_wanted;
    recording::Gathered m_gathered;
    std::optional<Rectangle> m_shape;
    recording::Head m_head;
    std::vector<Picture> m_pictures;
    Contents m_contents; ///< of all pictures
    int64_t m_last = -1;
};

} // namespace

CLI::App *AddRender(CLI::App &app, RenderCommand &command) {
    CLI::App *render =
        app.add_subcommand("render", "Draw a scene after a step, with what proves its bodies apart");
    CLI::Option *scene = render->add_option("scene", command.scene, "A name that `list` shows");
    render->add_option("--recording", command.recording, "Instead of a scene: what `world --record` wrote")
        ->check(CLI::ExistingFile)
        ->excludes(scene);
    CLI::Option *step = render->add_option("--step", command.step, "The step to draw; the first is 0")
                            ->check(CLI::Range(0, 100000000));
    CLI::Option *frames = render
                              ->add_option("--frames", command.frames,
                                           "FIRST:LAST:EVERY instead: a series; picture.png becomes "
                                           "picture-0000.png, ...")
                              ->excludes(step);
    step->excludes(frames);
    render->add_option("-o,--output", command.output, "The picture: .svg, .png or .pdf")->required();
    render
        ->add_option("--focus", command.focus,
                     "BODY: it and its pairs; A,B: two bodies; or X,Y,WIDTH,HEIGHT, a rectangle of the "
                     "world from its lower left corner")
        ->check([](const std::string &text) {
            return text.empty() ? std::string("a body, two bodies A,B or a rectangle is wanted")
                                : std::string();
        });
    render->add_option("--width", command.width, "Width in pixels (points in an SVG or PDF)")
        ->check(CLI::Range(200, 10000))
        ->capture_default_str();
    Layers &named = command.named;
    render->add_flag("--certificates", named.certificates, "Layer: what proves pairs apart");
    render->add_flag("--slack", named.slack, "Layer: how far apart, as colour");
    render->add_flag("--handed-over", named.handedOver, "Layer: pairs that needed a manifold");
    render->add_flag("--contacts", named.contacts, "Layer: contact points and normals");
    render->add_flag("--events", named.events, "Layer: what happened to certificates in the step");
    render->add_flag("--hulls", named.hulls, "Layer: hulls of bodies; of a kinetic world, their disks");
    render->add_flag("--envelopes", named.envelopes, "Layer: envelopes at the level of the proof");
    render->add_flag("--aabbs", named.boxes,
                     "Layer: boxes of the broad phase; of a kinetic world, the cells of its bodies");
    render->add_flag("--trails", named.trails,
                     "Layer: where bodies were in the frames before (with --recording)");
    CLI::Option *all = render->add_flag("--all", command.all, "Every layer");
    render->add_flag("--bare", command.bare, "No layer: the bodies alone")->excludes(all);
    render->add_flag("--quiet", command.quiet, "No progress, and no word of what was written");
    render->footer(kRenderHelp);
    return render;
}

int Execute(const RenderCommand &command, const Workers &workers) {
    if (!command.step && command.frames.empty())
        throw UsageError("which step? --step N, or --frames FIRST:LAST:EVERY for a series");
    PictureOptions options;
    ReadFocus(command.focus, &options);
    options.layers = LayersOf(command);
    options.width = command.width;
    // Beside the list of reasons, the world must still be seen.
    constexpr int kLeastWithBodies = 600;
    if (!options.bodies.empty() && options.width < kLeastWithBodies)
        throw UsageError("--width: with --focus on a body at least " + std::to_string(kLeastWithBodies));
    CheckOutput(command.output);
    RecordRequest request;
    ReadRange(command, &request);
    if (!command.recording.empty())
        request.scene = command.recording;
    else if (command.scene.empty())
        throw UsageError("a scene is wanted, or --recording FILE");
    else
        request.scene = FindScene(workers.List(), command.scene).name;
    if (options.layers.trails && command.recording.empty())
        throw UsageError("--trails: with --recording alone");

    Progress progress(1, command.quiet);
    progress.Show(request.scene, 0.0);
    Series series(command, options, request);
    const auto onFrame = [&](const recording::Head &head, const recording::Frame &frame) {
        series.Add(head, frame);
        progress.Show(request.scene, static_cast<double>(frame.step) /
                                         static_cast<double>(std::max<int64_t>(request.last, 1)));
    };
    if (!command.recording.empty()) {
        ReadRecorded(command.recording, onFrame);
        series.CheckDone();
    } else {
        request.side = command.plugin ? Side::Plugin : StockFor(FindScene(workers.List(), command.scene));
        request.boxes = options.layers.boxes;
        request.worker = command.worker;
        RunRecorded(workers, request, onFrame, [&progress] { progress.Tick(); });
    }
    series.Draw();
    progress.Clear();
    if (!command.quiet)
        std::cout << series.Said() << '\n';
    return kExitOk;
}

} // namespace testbed
