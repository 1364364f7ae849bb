// SPDX-License-Identifier: MIT
#include "outlined.h"

namespace testbed {
namespace {

std::vector<std::unique_ptr<b2Shape>> MakePieces(BodyKind kind, const Concave &concave, float tolerance) {
    if (kind == BodyKind::One)
        return MakeOutlinePieces(concave, tolerance);
    std::vector<std::unique_ptr<b2Shape>> pieces;
    for (const Outline &triangle : concave.triangles) {
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(triangle.data(), 3);
        pieces.push_back(std::move(shape));
    }
    return pieces;
}

} // namespace

Concave StarShaped(const Outline &outline) {
    Concave concave{outline, {}, {}};
    for (std::size_t i = 0; i < outline.size(); ++i)
        concave.triangles.push_back({b2Vec2(0.0f, 0.0f), outline[i], outline[(i + 1) % outline.size()]});
    return concave;
}

OutlinedBody::OutlinedBody(BodyKind kind, const Concave &concave, float tolerance)
    : m_pieces(MakePieces(kind, concave, tolerance)) {}

void OutlinedBody::AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const {
    for (const std::unique_ptr<b2Shape> &piece : m_pieces)
        stage.AddFixture(body, def, *piece);
}

} // namespace testbed
