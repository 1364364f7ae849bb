// SPDX-License-Identifier: MIT
#include "outline_command.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "boomerang/outline.h"
#include "commands.h"
#include "drawing/canvas.h"
#include "drawing/plot.h"
#include "output_file.h"

namespace testbed {
namespace {

constexpr char kOutlineHelp[] =
    "The file has a point `x y` (or `x,y`) a line, and an empty line between rings: first "
    "the outer ring, then the holes. What is behind a # is a remark.\n\n"
    "Example: boomerang-testbed outline rock.txt -o rock.svg --tolerance 0.01";

/// Rings, and the line of the file that each point is on.
struct OutlineFile {
    std::vector<bmr_vec2> points;
    std::vector<uint32_t> counts;
    std::vector<int> lines;

    bmr_rings Rings() const { return {points.data(), counts.data(), static_cast<uint32_t>(counts.size())}; }
};

OutlineFile ReadOutline(const std::string &path) {
    std::ifstream in(path);
    if (!in)
        throw UsageError("cannot read " + path);
    OutlineFile file;
    bool inRing = false;
    std::string text;
    for (int line = 1; std::getline(in, text); ++line) {
        const bool remark = text.find('#') != std::string::npos;
        text = text.substr(0, text.find('#'));
        std::replace(text.begin(), text.end(), ',', ' ');
        std::istringstream words(text);
        bmr_vec2 point;
        std::string rest;
        if (!(words >> rest)) { // nothing but a remark ends no ring
            inRing = inRing && remark;
            continue;
        }
        words = std::istringstream(text);
        if (!(words >> point.x >> point.y) || words >> rest)
            throw UsageError(path + ":" + std::to_string(line) + ": not a point, which is two numbers");
        if (!inRing)
            file.counts.push_back(0);
        inRing = true;
        ++file.counts.back();
        file.points.push_back(point);
        file.lines.push_back(line);
    }
    if (file.points.empty())
        throw UsageError(path + " has no points (a point `x y` a line)");
    return file;
}

/// "the edge from line 3 to line 4"
std::string NameEdge(const OutlineFile &file, uint32_t edge) {
    uint32_t first = 0, ring = 0;
    while (edge >= first + file.counts[ring])
        first += file.counts[ring++];
    const uint32_t next = edge + 1 < first + file.counts[ring] ? edge + 1 : first;
    return "the edge from line " + std::to_string(file.lines[edge]) + " to line " +
           std::to_string(file.lines[next]);
}

std::string Explain(const std::string &path, const OutlineFile &file, bmr_error error,
                    const bmr_outline_fault &fault) {
    std::ostringstream text;
    text << path << ": " << bmr_error_describe(error);
    if (fault.error == BMR_OK)
        return text.str();
    text << " (";
    bool first = true;
    for (int i = 0; i < 2; ++i) {
        if (fault.edge[i] == BMR_OUTLINE_NONE || (i == 1 && fault.edge[1] == fault.edge[0]))
            continue;
        text << (first ? "" : " and ") << NameEdge(file, fault.edge[i]);
        first = false;
    }
    text << ", near " << fault.where.x << ' ' << fault.where.y << ')';
    return text.str();
}

struct DestroyPieces {
    void operator()(bmr_outline_pieces *pieces) const { bmr_outline_pieces_destroy(pieces, nullptr); }
};
using Pieces = std::unique_ptr<bmr_outline_pieces, DestroyPieces>;

Pieces Decompose(const OutlineCommand &command, const OutlineFile &file) {
    const bmr_rings rings = file.Rings();
    bmr_outline_def def = bmr_default_outline_def();
    def.tolerance = command.tolerance;
    bmr_outline_pieces *pieces = nullptr;
    bmr_outline_fault fault = {};
    const bmr_error error = bmr_outline_decompose(&rings, &def, nullptr, &pieces, &fault);
    if (error != BMR_OK)
        throw UsageError(Explain(command.file, file, error, fault));
    return Pieces(pieces);
}

std::vector<bmr_vec2> CornersOf(const bmr_outline_pieces &pieces, uint32_t piece) {
    std::vector<bmr_vec2> corners;
    for (uint32_t e = pieces.first[piece]; e < pieces.first[piece + 1]; ++e)
        corners.push_back(pieces.points[pieces.edges[e].point]);
    return corners;
}

/// The pieces filled, each in another colour than the one before; inner edges dashed; the outline on top.
void Draw(const std::string &path, const OutlineFile &file, const bmr_outline_pieces &pieces) {
    constexpr double kSide = 480.0, kMargin = 12.0;
    Rectangle world = {file.points[0].x, file.points[0].y, file.points[0].x, file.points[0].y};
    for (const bmr_vec2 &p : file.points)
        world = {std::min(world.left, p.x), std::min(world.bottom, p.y), std::max(world.right, p.x),
                 std::max(world.top, p.y)};
    const double scale = (kSide - 2.0 * kMargin) / std::max(world.Width(), world.Height());
    const double width = scale * world.Width() + 2.0 * kMargin,
                 height = scale * world.Height() + 2.0 * kMargin;
    const double room = 0.5 * kMargin / scale;
    Canvas canvas(path, width, height);
    canvas.SetPanel({0.5 * kMargin, 0.5 * kMargin, width - 0.5 * kMargin, height - 0.5 * kMargin},
                    {world.left - room, world.bottom - room, world.right + room, world.top + room});
    for (uint32_t p = 0; p < pieces.piece_count; ++p)
        canvas.Polygon(CornersOf(pieces, p), {ink::Series(p % 6), 0.25}, {ink::kGrey, 0.0, 0.0, {}});
    const Pen inner = {ink::kGrey, 0.8, 1.0, {3.0, 2.0}}, outer = {ink::kBlack, 1.4, 1.0, {}};
    for (const bool outline : {false, true})
        for (uint32_t p = 0; p < pieces.piece_count; ++p) {
            const std::vector<bmr_vec2> corners = CornersOf(pieces, p);
            for (std::size_t i = 0; i < corners.size(); ++i)
                if ((pieces.edges[pieces.first[p] + i].twin == BMR_OUTLINE_NONE) == outline)
                    canvas.Segment(corners[i], corners[(i + 1) % corners.size()], outline ? outer : inner);
        }
    canvas.Write();
}

nlohmann::json ToJson(const OutlineCommand &command, const OutlineFile &file,
                      const bmr_outline_pieces &pieces) {
    nlohmann::json json = {{"file", command.file},
                           {"points", file.points.size()},
                           {"rings", file.counts.size()},
                           {"tolerance", command.tolerance},
                           {"notches", pieces.notch_count},
                           {"holes", pieces.hole_count},
                           {"pieces", nlohmann::json::array()}};
    for (uint32_t p = 0; p < pieces.piece_count; ++p) {
        nlohmann::json corners = nlohmann::json::array(), inner = nlohmann::json::array();
        for (uint32_t e = pieces.first[p]; e < pieces.first[p + 1]; ++e) {
            const bmr_vec2 point = pieces.points[pieces.edges[e].point];
            corners.push_back({point.x, point.y});
            if (pieces.edges[e].twin != BMR_OUTLINE_NONE)
                inner.push_back(e - pieces.first[p]);
        }
        json["pieces"].push_back({{"points", corners}, {"inner", inner}});
    }
    return json;
}

} // namespace

CLI::App *AddOutline(CLI::App &app, OutlineCommand &command) {
    CLI::App *outline = app.add_subcommand("outline", "Cut an outline, which may be concave and have holes, "
                                                      "into convex pieces, and draw them");
    outline->add_option("file", command.file, "The outline's points")->required()->check(CLI::ExistingFile);
    outline->add_option("-o,--output", command.picture, "The picture: .svg, .png or .pdf");
    outline->add_option("--json", command.json, "Write the pieces into this file, as JSON");
    outline->add_option("--tolerance", command.tolerance, "How far the pieces may be from the outline")
        ->check(CLI::Range(0.0, 1e9))
        ->capture_default_str();
    outline->add_flag("--quiet", command.quiet, "Print nothing: the files alone");
    outline->footer(kOutlineHelp);
    return outline;
}

int Execute(const OutlineCommand &command) {
    if (!command.picture.empty() && !IsPicturePath(command.picture))
        throw UsageError("a picture ends in .svg, .png or .pdf, not so " + command.picture);
    if (command.quiet && command.picture.empty() && command.json.empty())
        throw UsageError("--quiet prints nothing: give -o or --json a file");
    OutputFile json(command.json);
    const OutlineFile file = ReadOutline(command.file);
    const Pieces pieces = Decompose(command, file);
    if (!command.quiet)
        std::cout << file.points.size() << " points in " << file.counts.size() << " rings, "
                  << pieces->notch_count << " notches: " << pieces->piece_count << " convex pieces\n";
    if (!command.picture.empty())
        Draw(command.picture, file, *pieces);
    if (json.IsWanted()) {
        json.Stream() << ToJson(command, file, *pieces).dump(2) << '\n';
        json.Close();
    }
    return kExitOk;
}

} // namespace testbed
