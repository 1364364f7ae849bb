// SPDX-License-Identifier: MIT
#include "picture/parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace testbed {
namespace {

using shown::Pair;
using shown::Proof;

/// So many strokes across gaps may be opaque; more are made fainter, or they would hide the bodies.
constexpr double kOpaqueStrokes = 400.0, kFaintest = 0.15;

/// A proof in the world.
struct Shown {
    bmr_vec2 normal;           ///< from the owner to the other
    bmr_vec2 edge[2];          ///< of an edge's line
    bmr_vec2 onOwner, onOther; ///< the gap lies between these, along the normal
    bmr_vec2 nearOwner;        ///< the owner's own point that is nearest to onOther
    bmr_vec2 centre[2];        ///< of disks
    bool hasEdge = false, hasDisks = false;
};

bmr_vec2 NearestOnSegment(bmr_vec2 a, bmr_vec2 b, bmr_vec2 point) {
    const bmr_vec2 way = bmr_sub(b, a);
    const double length2 = bmr_dot(way, way);
    const double share =
        length2 > 0.0 ? std::clamp(bmr_dot(bmr_sub(point, a), way) / length2, 0.0, 1.0) : 0.0;
    return bmr_add(a, bmr_scale(share, way));
}

Shown ShowDisks(const WorldView &world, const Pair &pair, const Proof &proof) {
    Shown shown = {};
    shown.hasDisks = true;
    shown.centre[0] = world.ToWorld(pair.a, proof.centres[0]);
    shown.centre[1] = world.ToWorld(pair.b, proof.centres[1]);
    const bmr_vec2 way = bmr_sub(shown.centre[1], shown.centre[0]);
    shown.normal = bmr_scale(1.0 / std::sqrt(std::max(bmr_dot(way, way), 1e-30)), way);
    const auto along = [&shown](int side, double distance) {
        return bmr_add(shown.centre[side], bmr_scale(distance, shown.normal));
    };
    shown.nearOwner = shown.onOwner = along(0, static_cast<double>(proof.radii[0]));
    shown.onOther = along(1, -static_cast<double>(proof.radii[1]));
    return shown;
}

Shown Show(const WorldView &world, const Pair &pair, const Proof &proof) {
    if (proof.kind == "disks")
        return ShowDisks(world, pair, proof);
    const int owner = proof.owner == 0 ? pair.a : pair.b, other = proof.owner == 0 ? pair.b : pair.a;
    const auto own = static_cast<std::size_t>(proof.owner);
    Shown shown = {};
    shown.normal = world.Turned(owner, proof.normal);
    shown.hasEdge = proof.kind != "direction";
    if (shown.hasEdge) {
        for (std::size_t i = 0; i < 2; ++i)
            shown.edge[i] = world.ToWorld(owner, proof.edge[i]);
        shown.onOther = world.ToWorld(other, proof.opposite);
        shown.nearOwner = NearestOnSegment(shown.edge[0], shown.edge[1], shown.onOther);
    } else {
        shown.nearOwner = world.ToWorld(owner, proof.supports[own]);
        shown.onOther = world.ToWorld(other, proof.supports[1 - own]);
    }
    const double gap = bmr_dot(shown.normal, bmr_sub(shown.onOther, shown.nearOwner));
    shown.onOwner = bmr_sub(shown.onOther, bmr_scale(gap, shown.normal));
    return shown;
}

Colour ColourOf(const PictureOptions &options, const Proof &proof) {
    return options.layers.slack ? ColourOfSlack(static_cast<double>(proof.slack)) : style::kCertificate;
}

bmr_vec2 Middle(bmr_vec2 a, bmr_vec2 b) {
    return bmr_scale(0.5, bmr_add(a, b));
}

/// Where something is to be said of a pair that nothing proves apart: where it touches, or where it is
/// closest.
bmr_vec2 PlaceOf(const WorldView &world, const Pair &pair) {
    bmr_vec2 sum = bmr_vec2_make(0.0, 0.0);
    int count = 0;
    for (const shown::Contact &contact : world.Frame().touching) {
        const auto [first, second] = std::minmax(contact.bodies[0], contact.bodies[1]);
        if (first != pair.a || second != pair.b)
            continue;
        for (const shown::ContactPoint &point : contact.points) {
            sum = bmr_add(sum, ToVec2(point.at));
            ++count;
        }
    }
    if (count > 0)
        return bmr_scale(1.0 / count, sum);
    return Middle(ToVec2(pair.closest[0]), ToVec2(pair.closest[1]));
}

/// The owner's line, from end to end of what it is about and a little beyond.
void DrawLine(Canvas &canvas, const Shown &shown, double beyond, const Pen &pen) {
    const bmr_vec2 along = bmr_left(shown.normal);
    double low = 0.0, high = 0.0; // from the foot of the gap
    const auto reach = [&](bmr_vec2 point) {
        const double at = bmr_dot(along, bmr_sub(point, shown.onOwner));
        low = std::min(low, at);
        high = std::max(high, at);
    };
    reach(shown.nearOwner);
    for (int i = 0; i < 2 && shown.hasEdge; ++i)
        reach(shown.edge[i]);
    canvas.Segment(bmr_add(shown.onOwner, bmr_scale(low - beyond, along)),
                   bmr_add(shown.onOwner, bmr_scale(high + beyond, along)), pen);
}

void DrawRing(Canvas &canvas, bmr_vec2 at, double radius, const Colour &colour, double unit) {
    canvas.Circle(at, radius * unit / canvas.Scale(), {style::kBackground, 0.6},
                  {colour, 1.6 * unit, 1.0, {}});
    canvas.Dot(at, 1.8 * unit, colour);
}

/// The gap as a dimension: arrows at both ends where they fit.
void DrawGap(Canvas &canvas, const Shown &shown, const Colour &colour, double unit) {
    constexpr double kShortestForArrows = 22.0;
    const Pen pen = {colour, 1.6 * unit, 1.0, {}};
    const bmr_vec2 way = bmr_sub(shown.onOther, shown.onOwner);
    if (std::sqrt(bmr_dot(way, way)) * canvas.Scale() > kShortestForArrows * unit) {
        const bmr_vec2 middle = Middle(shown.onOwner, shown.onOther);
        canvas.Arrow(middle, shown.onOther, pen);
        canvas.Arrow(middle, shown.onOwner, pen);
    } else {
        canvas.Segment(shown.onOwner, shown.onOther, pen);
    }
}

} // namespace

const Proof *WeakestProof(const Pair &pair) {
    const Proof *weakest = nullptr;
    for (const Proof &proof : pair.proofs) {
        if (proof.kind == "none")
            return nullptr;
        if (weakest == nullptr || proof.slack < weakest->slack)
            weakest = &proof;
    }
    return weakest;
}

bool IsInFocus(const PictureOptions &options, const Pair &pair) {
    return !options.body || options.body == pair.a || options.body == pair.b;
}

std::vector<Explained> Explain(const WorldView &world, const PictureOptions &options,
                               const Rectangle &region) {
    constexpr std::size_t kMost = 9;
    std::vector<Explained> explained;
    for (const Pair &pair : world.Frame().pairs) {
        if (!options.body || !IsInFocus(options, pair) || pair.touching > 0)
            continue;
        const Proof *proof = WeakestProof(pair);
        if (proof == nullptr)
            continue;
        const Shown shown = Show(world, pair, *proof);
        const bmr_vec2 place = Middle(shown.nearOwner, shown.onOther);
        if (place.x > region.left && place.x < region.right && place.y > region.bottom &&
            place.y < region.top)
            explained.push_back({&pair, proof, Middle(shown.onOwner, shown.onOther)});
    }
    std::stable_sort(explained.begin(), explained.end(),
                     [](const Explained &a, const Explained &b) { return a.proof->slack < b.proof->slack; });
    explained.resize(std::min(explained.size(), kMost));
    return explained;
}

void DrawDisks(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit) {
    const Pen pen = {style::kDisk, 1.1 * unit, 0.85, {6.0 * unit, 3.0 * unit}};
    std::set<int> bodies;
    for (const Pair &pair : world.Frame().pairs)
        if (IsInFocus(options, pair))
            bodies.insert({pair.a, pair.b});
    for (const int body : bodies)
        canvas.Circle(ToVec2(world.PoseOf(body).position), static_cast<double>(world.FindBody(body)->disk),
                      {}, pen);
}

void DrawProofs(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit) {
    std::vector<std::pair<const Proof *, const Pair *>> proofs;
    for (const Pair &pair : world.Frame().pairs)
        for (const Proof &proof : pair.proofs)
            if (proof.kind != "none" && IsInFocus(options, pair) && (!options.body || pair.touching > 0))
                proofs.emplace_back(&proof, &pair);
    // The closest pairs are looked for most: on top.
    std::stable_sort(proofs.begin(), proofs.end(),
                     [](const auto &a, const auto &b) { return a.first->slack > b.first->slack; });
    const double opacity =
        std::clamp(kOpaqueStrokes / (1.0 + static_cast<double>(proofs.size())), kFaintest, 0.9);
    for (const auto &[proof, pair] : proofs) {
        const Shown shown = Show(world, *pair, *proof);
        const Colour colour = ColourOf(options, *proof);
        std::vector<double> dash;
        if (shown.hasDisks)
            dash = {1.0 * unit, 3.0 * unit};
        else if (!shown.hasEdge)
            dash = {5.0 * unit, 3.0 * unit};
        canvas.Segment(shown.nearOwner, shown.onOther, {colour, 1.1 * unit, opacity, dash});
        if (shown.hasEdge && options.layers.certificates)
            canvas.Segment(shown.edge[0], shown.edge[1], {colour, 2.2 * unit, opacity, {}});
        canvas.Circle(shown.onOther, 1.5 * unit / canvas.Scale(), {colour, opacity}, {colour, 0.0, 1.0, {}});
    }
}

void DrawExplained(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit,
                   const Explained &explained) {
    const Proof &proof = *explained.proof;
    const Shown shown = Show(world, *explained.pair, proof);
    const Colour colour = ColourOf(options, proof);
    const double beyond = 30.0 * unit / canvas.Scale();
    if (shown.hasDisks) {
        for (std::size_t i = 0; i < 2; ++i)
            canvas.Circle(shown.centre[i], static_cast<double>(proof.radii[i]), {},
                          {colour, 1.8 * unit, 1.0, {1.0 * unit, 3.5 * unit}});
    } else {
        const std::vector<double> dash = {6.0 * unit, 4.0 * unit};
        DrawLine(canvas, shown, beyond,
                 {colour, 1.3 * unit, 1.0, shown.hasEdge ? std::vector<double>() : dash});
        const bmr_vec2 half = bmr_scale(beyond, bmr_left(shown.normal));
        canvas.Segment(bmr_sub(shown.onOther, half), bmr_add(shown.onOther, half),
                       {colour, 1.0 * unit, 0.8, dash});
        if (shown.hasEdge)
            canvas.Segment(shown.edge[0], shown.edge[1], {colour, 4.5 * unit, 1.0, {}});
        else
            DrawRing(canvas, shown.nearOwner, 4.5, colour, unit);
        DrawRing(canvas, shown.onOther, 4.5, colour, unit);
    }
    DrawGap(canvas, shown, colour, unit);
}

void DrawHandedOver(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit) {
    // In a crowd they are smaller, or they would hide what they are about.
    constexpr std::size_t kCrowd = 60;
    const bool crowd = world.Frame().touching.size() > kCrowd && !options.body;
    const double half = (crowd ? 3.2 : 4.5) * unit / canvas.Scale();
    const Pen pen = {style::kHandedOver, (crowd ? 1.0 : 1.4) * unit, 1.0, {}};
    for (const Pair &pair : world.Frame().pairs) {
        if (pair.handed_over == 0 || pair.contacts == 0 || !IsInFocus(options, pair))
            continue;
        if (pair.touching == 0)
            canvas.Segment(ToVec2(pair.closest[0]), ToVec2(pair.closest[1]),
                           {style::kHandedOver, 1.2 * unit, 0.9, {3.0 * unit, 2.5 * unit}});
        const bmr_vec2 at = PlaceOf(world, pair);
        canvas.Polygon({bmr_vec2_make(at.x - half, at.y), bmr_vec2_make(at.x, at.y - half),
                        bmr_vec2_make(at.x + half, at.y), bmr_vec2_make(at.x, at.y + half)},
                       {}, pen);
    }
}

void DrawEvents(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit) {
    std::set<std::pair<int, int>> happened;
    for (const shown::Event &event : world.Frame().events)
        happened.insert(std::minmax(event.a, event.b));
    for (const Pair &pair : world.Frame().pairs)
        if (happened.count(std::minmax(pair.a, pair.b)) != 0 && IsInFocus(options, pair))
            canvas.Circle(PlaceOf(world, pair), 7.0 * unit / canvas.Scale(), {},
                          {style::kEvent, 1.6 * unit, 1.0, {}});
}

std::map<std::string, std::size_t> EventsInFocus(const WorldView &world, const PictureOptions &options) {
    std::map<std::string, std::size_t> kinds;
    for (const shown::Event &event : world.Frame().events) {
        shown::Pair pair;
        pair.a = event.a;
        pair.b = event.b;
        if (IsInFocus(options, pair))
            kinds[event.kind] += 1;
    }
    return kinds;
}

} // namespace testbed
