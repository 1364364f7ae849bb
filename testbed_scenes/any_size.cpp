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

Fixtures MakePolygons(const std::vector<Outline> &outlines) {
    std::vector<std::unique_ptr<b2Shape>> pieces;
    for (const Outline &outline : outlines) {
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(outline.data(), static_cast<int32>(outline.size()));
        pieces.push_back(std::move(shape));
    }
    return Fixtures(std::move(pieces));
}

Fixtures MakeOne(std::unique_ptr<b2Shape> shape) {
    std::vector<std::unique_ptr<b2Shape>> pieces;
    pieces.push_back(std::move(shape));
    return Fixtures(std::move(pieces));
}

} // namespace

const char *NameOf(BodyKind kind) {
    static constexpr const char *names[] = {"one", "many", "circle"};
    return names[static_cast<std::size_t>(kind)];
}

Fixtures AnySizePolygon(BodyKind kind, const Outline &outline) {
    return kind == BodyKind::One ? MakeOne(MakeOnePolygon(outline)) : MakePolygons(CutConvex(outline));
}

Fixtures AnySizePolygon(const PolygonChoice &choice, float radius, float phase) {
    if (choice.bodies == BodyKind::Circle)
        return MakeOne(std::make_unique<b2CircleShape>(MakeCircle(radius)));
    return AnySizePolygon(choice.bodies, RegularOutline(choice.vertices, radius, phase));
}

void Fixtures::AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const {
    for (const std::unique_ptr<b2Shape> &piece : m_pieces)
        stage.AddFixture(body, def, *piece);
}

Concave StarShaped(const Outline &outline) {
    Concave concave{outline, {}, {}};
    for (std::size_t i = 0; i < outline.size(); ++i)
        concave.triangles.push_back({b2Vec2(0.0f, 0.0f), outline[i], outline[(i + 1) % outline.size()]});
    return concave;
}

Fixtures OutlinedBody(BodyKind kind, const Concave &concave, float tolerance) {
    return kind == BodyKind::One ? Fixtures(MakeOutlinePieces(concave, tolerance))
                                 : MakePolygons(concave.triangles);
}

} // namespace testbed
