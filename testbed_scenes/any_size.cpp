// SPDX-License-Identifier: MIT
#include "any_size.h"

#include <algorithm>

namespace testbed {
namespace {

/// A convex outline in pieces of at most 8 vertices, all of which share its first vertex.
std::vector<Outline> CutConvex(const Outline &outline) {
    constexpr int added = b2_maxPolygonVertices - 1; // a piece is the first vertex and a run of these
    std::vector<Outline> pieces;
    const int count = static_cast<int>(outline.size());
    for (int first = 1; first < count - 1; first += added - 1) {
        const int last = std::min(first + added - 1, count - 1);
        Outline piece{outline.front()};
        piece.insert(piece.end(), outline.begin() + first, outline.begin() + last + 1);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

std::vector<std::unique_ptr<b2Shape>> MakePieces(BodyKind kind, const Outline &outline) {
    std::vector<std::unique_ptr<b2Shape>> pieces;
    if (kind == BodyKind::One) {
        pieces.push_back(MakeOnePolygon(outline));
        return pieces;
    }
    for (const Outline &piece : CutConvex(outline)) {
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(piece.data(), static_cast<int32>(piece.size()));
        pieces.push_back(std::move(shape));
    }
    return pieces;
}

} // namespace

const char *NameOf(BodyKind kind) {
    switch (kind) {
    case BodyKind::One:
        return "one";
    case BodyKind::Many:
        return "many";
    case BodyKind::Circle:
        break;
    }
    return "circle";
}

AnySizePolygon::AnySizePolygon(BodyKind kind, const Outline &outline) {
    m_pieces = MakePieces(kind, outline);
}

AnySizePolygon::AnySizePolygon(const PolygonChoice &choice, float radius, float phase) {
    if (choice.bodies == BodyKind::Circle)
        m_pieces.push_back(std::make_unique<b2CircleShape>(MakeCircle(radius)));
    else
        m_pieces = MakePieces(choice.bodies, RegularOutline(choice.vertices, radius, phase));
}

void ManyFixtures::AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const {
    for (const std::unique_ptr<b2Shape> &piece : m_pieces)
        stage.AddFixture(body, def, *piece);
}

Concave StarShaped(const Outline &outline) {
    Concave concave{outline, {}, {}};
    for (std::size_t i = 0; i < outline.size(); ++i)
        concave.triangles.push_back({b2Vec2(0.0f, 0.0f), outline[i], outline[(i + 1) % outline.size()]});
    return concave;
}

OutlinedBody::OutlinedBody(BodyKind kind, const Concave &concave, float tolerance) {
    if (kind == BodyKind::One) {
        m_pieces = MakeOutlinePieces(concave, tolerance);
        return;
    }
    for (const Outline &triangle : concave.triangles) {
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(triangle.data(), 3);
        m_pieces.push_back(std::move(shape));
    }
}

} // namespace testbed
