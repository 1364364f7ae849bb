// SPDX-License-Identifier: MIT
#include "any_size.h"

namespace testbed {
namespace {

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

AnySizePolygon::AnySizePolygon(BodyKind kind, const Outline &outline) : m_pieces(MakePieces(kind, outline)) {}

AnySizePolygon::AnySizePolygon(const PolygonChoice &choice, float radius, float phase) {
    if (choice.bodies == BodyKind::Circle)
        m_pieces.push_back(std::make_unique<b2CircleShape>(MakeCircle(radius)));
    else
        m_pieces = MakePieces(choice.bodies, RegularOutline(choice.vertices, radius, phase));
}

void AnySizePolygon::AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const {
    for (const std::unique_ptr<b2Shape> &piece : m_pieces)
        stage.AddFixture(body, def, *piece);
}

} // namespace testbed
