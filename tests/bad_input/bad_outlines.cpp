// SPDX-License-Identifier: MIT
// Outlines that are none, and bad arguments of what is asked of them.
#include <cstdint>
#include <string>
#include <vector>

#include "arguments.h"
#include "boomerang/outline.h"
#include "points.h"

using namespace bad_input;

namespace {

/// All three questions about one outline must refuse it the same way, and write nothing but the fault.
std::string AskedOf(const std::vector<double> &xy, const std::vector<uint32_t> &counts,
                    double tolerance = 0.0) {
    const auto *points = reinterpret_cast<const bmr_vec2 *>(xy.data());
    const bmr_rings rings = {points, counts.data(), static_cast<uint32_t>(counts.size())};
    const bmr_outline_def def = {tolerance};
    std::vector<uint32_t> kept(xy.size() / 2 + 1, 77), left(counts.size() + 1, 77);
    bmr_outline_pieces *pieces = nullptr;
    bmr_outline_fault faults[3] = {};
    const bmr_error error = bmr_outline_decompose(&rings, &def, nullptr, &pieces, &faults[0]);
    const bmr_error again =
        bmr_outline_simplify(&rings, tolerance, nullptr, kept.data(), left.data(), &faults[1]);
    const bmr_error checked = bmr_outline_check(&rings, nullptr, &faults[2]);
    if (error == BMR_OK || again != error || (tolerance == 0.0 && checked != error))
        return Said(error) + ", " + Said(again) + " and " + Said(checked);
    if (pieces != nullptr || kept[0] != 77 || left[0] != 77 || faults[0].edge[1] != faults[1].edge[1])
        return Said(error) + ", and something is written";
    if (faults[0].error == BMR_OK)
        return Said(error);
    const auto name = [](uint32_t edge) { return edge == BMR_OUTLINE_NONE ? "none" : std::to_string(edge); };
    return Said(error) + ", edges " + name(faults[0].edge[0]) + " and " + name(faults[0].edge[1]);
}

std::vector<double> Joined(std::vector<double> a, const std::vector<double> &b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

std::vector<Argument> Outlines() {
    static const std::vector<double> square = {0, 0, 4, 0, 4, 4, 0, 4};
    return {
        {"an outline without rings", [] { return AskedOf(square, {}); }},
        {"an outline, a ring without points",
         [] {
             return AskedOf(square, {4, 0});
         }},
        {"an outline, a ring of two points",
         [] {
             return AskedOf(Joined(square, {1, 1, 2, 2}), {4, 2});
         }},
        {"an outline of 65,536 points", [] { return AskedOf(Circle(65536, 1.0), {65536}); }},
        {"an outline of 2^32 - 1 points, and two more",
         [] {
             return AskedOf(square, {UINT32_MAX, 2});
         }},
        {"an outline, a coordinate of NaN",
         [] {
             return AskedOf({0, 0, 4, 0, 4, kNone}, {3});
         }},
        {"an outline, a coordinate of infinity",
         [] {
             return AskedOf({0, 0, kInfinite, 0, 4, 4}, {3});
         }},
        {"an outline, a tolerance of NaN", [] { return AskedOf(square, {4}, kNone); }},
        {"an outline, a tolerance of infinity", [] { return AskedOf(square, {4}, kInfinite); }},
        {"an outline, a tolerance below 0", [] { return AskedOf(square, {4}, -1.0); }},
        {"an outline, its last point is its first",
         [] {
             return AskedOf(Joined(square, {0, 0}), {5});
         }},
        {"an outline like an 8",
         [] {
             return AskedOf({0, 0, 4, 4, 4, 0, 0, 4}, {4});
         }},
        {"an outline like an 8, through one point twice",
         [] {
             return AskedOf({0, 0, 2, 2, 4, 4, 4, 0, 2, 2, 0, 4}, {6});
         }},
        {"an outline with a spike",
         [] {
             return AskedOf({0, 0, 4, 0, 6, 0, 4, 0, 4, 4}, {5});
         }},
        {"an outline of points on one line",
         [] {
             return AskedOf({0, 0, 1, 1, 2, 2}, {3});
         }},
        {"an outline, a hole that crosses it",
         [] {
             return AskedOf(Joined(square, {1, 1, 6, 2, 1, 3}), {4, 3});
         }},
        {"an outline, a hole along one of its edges",
         [] {
             return AskedOf(Joined(square, {1, 0, 2, 0, 2, 2}), {4, 3});
         }},
        {"an outline, a hole beside it",
         [] {
             return AskedOf(Joined(square, {6, 1, 7, 1, 7, 2}), {4, 3});
         }},
        {"an outline, a hole in a hole",
         [] {
             return AskedOf(Joined(square, {1, 1, 3, 1, 3, 3, 1, 3, 1.5, 1.5, 2, 1.5, 2, 2}), {4, 4, 3});
         }},
        {"an outline in its own hole",
         [] {
             return AskedOf(Joined({1, 1, 2, 1, 2, 2}, square), {3, 4});
         }},
        {"`bmr_outline_decompose`: no place for the result",
         [] {
             const bmr_rings rings = {reinterpret_cast<const bmr_vec2 *>(square.data()), nullptr, 1};
             return Said(bmr_outline_decompose(&rings, nullptr, nullptr, nullptr, nullptr));
         }},
        {"`bmr_outline_check`: no points, no counts",
         [] {
             const bmr_rings rings = {nullptr, nullptr, 1};
             return Said(bmr_outline_check(&rings, nullptr, nullptr));
         }},
        {"`bmr_outline_mass`: a square with a hole as large",
         [] {
             const std::vector<double> xy = Joined(square, square);
             const uint32_t counts[] = {4, 4};
             const bmr_rings rings = {reinterpret_cast<const bmr_vec2 *>(xy.data()), counts, 2};
             bmr_mass mass;
             return Said(bmr_outline_mass(&rings, &mass));
         }},
        {"`bmr_outline_pieces_destroy`: `NULL`",
         [] {
             bmr_outline_pieces_destroy(nullptr, nullptr);
             return std::string("nothing happens");
         }},
        {"`bmr_outline_pieces_audit`: `NULL`", [] { return Said(bmr_outline_pieces_audit(nullptr)); }},
    };
}

} // namespace

int main(int argc, char **argv) {
    return Main(argc, argv, {ArgumentTable("outlines", Outlines())});
}
