// SPDX-License-Identifier: MIT
#include <map>
#include <mutex>
#include <stdexcept>

#include <boomerang/box2d.h>

#include "any_size.h"
#include "debug/statistics.h"
#include "program.h"

namespace threads {

const std::vector<Chosen> &ScenesOfThePlugin() {
    // Two of each: their polygons are the same, and shared.
    static const std::vector<Chosen> scenes = {{"any-gas", 12, 64},           {"any-gas", 12, 64},
                                               {"any-bag", 20, 24},           {"any-bag", 20, 24},
                                               {"any-bullets", 8, 20},        {"any-bullets", 8, 20},
                                               {"any-wheels", 4, 9},          {"any-wheels", 4, 9},
                                               {"asteroids-outline", 12, 24}, {"asteroids-outline", 12, 24}};
    return scenes;
}

bool Install(bool counting) {
    bmr::Options options;
    options.statistics = counting;
    return bmr::Install(options);
}

bool IsInstalled() {
    return bmr::IsInstalled();
}

bool StatisticsReader::Read() {
    const bmr::Counted s = bmr::internal::ReadCounts();
    const bool forward = s.steps >= steps && s.evaluations >= evaluations && s.differences == 0;
    steps = s.steps;
    evaluations = s.evaluations;
    return forward;
}

} // namespace threads

namespace testbed {

namespace {

/// The shape of an outline, made once for all worlds and threads.
bmr::ConvexShape SharedShape(const Outline &outline) {
    std::vector<float> key;
    for (const b2Vec2 &corner : outline)
        key.insert(key.end(), {corner.x, corner.y});
    static std::mutex mutex;
    static std::map<std::vector<float>, bmr::ConvexShape> shapes;
    const std::lock_guard<std::mutex> lock(mutex);
    const auto found = shapes.find(key);
    if (found != shapes.end())
        return found->second;
    bmr::ConvexShape &shape = shapes[key];
    if (shape.Set(outline.data(), static_cast<int32>(outline.size())) != BMR_OK)
        throw std::runtime_error("no polygon of this outline");
    return shape;
}

} // namespace

std::unique_ptr<b2Shape> MakeOnePolygon(const Outline &outline) {
    return std::make_unique<bmr::ConvexShape>(SharedShape(outline));
}

Outline VerticesOf(const b2PolygonShape &polygon) {
    const bmr::ConvexShape *shape = bmr::ConvexShape::From(&polygon);
    if (shape == nullptr)
        return Outline(polygon.m_vertices, polygon.m_vertices + polygon.m_count);
    return Outline(shape->GetVertices(), shape->GetVertices() + shape->GetVertexCount());
}

std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &concave, float tolerance) {
    bmr::OutlineShape outline;
    if (outline.Set(concave.ring.data(), static_cast<int32>(concave.ring.size()), nullptr, 0, tolerance) !=
        BMR_OK)
        throw std::runtime_error("no outline of these points");
    std::vector<std::unique_ptr<b2Shape>> pieces;
    for (int32 i = 0; i < outline.GetPieceCount(); ++i)
        pieces.push_back(std::make_unique<bmr::ConvexShape>(outline.GetPiece(i)));
    return pieces;
}

std::vector<int> InnerEdgesOf(const b2Fixture &) {
    return {};
}

} // namespace testbed
