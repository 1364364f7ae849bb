// SPDX-License-Identifier: MIT
// Fixtures, and shapes that are changed in place.
#include <cmath>

#include "actor.h"
#include "plugin.h"

namespace actor {

/// Some are refused by Box2D's assertions; the script ends there.
void Actor::MakePolygon(b2PolygonShape *shape) {
    const int kind = Below(8);
    const float width = Size();
    b2Vec2 points[b2_maxPolygonVertices];
    switch (kind) {
    case 0:
    case 1:
        shape->SetAsBox(width, width);
        break;
    case 2: {
        const float height = Size();
        shape->SetAsBox(width, height);
        break;
    }
    case 3: {
        const float height = Size();
        const b2Vec2 center = Vector(0.01f * width);
        const float angle = Angle();
        shape->SetAsBox(width, height, center, angle);
        break;
    }
    case 4: { // any points around the origin
        const int count = 3 + Below(6);
        for (int i = 0; i < count; ++i)
            points[i] = Vector(width / 64.0f);
        shape->Set(points, count);
        break;
    }
    default: {
        const int count = 3 + Below(6);
        const float flatness = kind == 7 ? Unsigned(1.0f / 255.0f) + 0.02f : 1.0f;
        const float turn = kind == 5 ? 0.0f : Unsigned(0.01f);
        for (int i = 0; i < count; ++i) {
            const float angle = turn + 2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(count);
            points[i] = {width * std::cos(angle), flatness * width * std::sin(angle)};
        }
        shape->Set(points, count);
    }
    }
}

void Actor::MakeChain(b2Body *body, const b2FixtureDef &def, bool loop) {
    constexpr int kMost = 8;
    b2Vec2 points[kMost];
    const int count = 3 + Below(kMost - 2);
    const float width = Size();
    for (int i = 0; i < count; ++i) {
        const float along = static_cast<float>(i) / static_cast<float>(count);
        const float height = Signed(width / 256.0f);
        points[i] = loop ? b2Vec2((width + height) * std::cos(2.0f * b2_pi * along),
                                  (width + height) * std::sin(2.0f * b2_pi * along))
                         : b2Vec2(width * (3.0f - 6.0f * along), height);
    }
    b2ChainShape chain;
    if (loop)
        chain.CreateLoop(points, count);
    else
        chain.CreateChain(points, count, points[0] + b2Vec2(1.0f, 0.0f),
                          points[count - 1] - b2Vec2(1.0f, 0.0f));
    m_world->Create(body, def, chain);
}

void Actor::AddFixture(b2Body *body) {
    static constexpr float kDensities[] = {1.0f, 1.0f, 0.01f, 0.0f, 100.0f, 3.0f, 1e4f, 0.5f};
    int count = 0;
    for (b2Fixture *fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
        ++count;
    if (count >= m_mostFixtures)
        return;
    const int kind = Below(16);
    const int material = Byte();
    b2FixtureDef def;
    def.density = kDensities[material % 8];
    def.friction = 0.2f * static_cast<float>(material / 8 % 4);
    def.restitution = material / 32 % 2 == 0 ? 0.0f : 0.8f;
    def.isSensor = material / 64 == 3;
    switch (kind) {
    case 0: {
        b2CircleShape circle;
        circle.m_radius = Size();
        circle.m_p = Vector(0.01f);
        m_world->Create(body, def, circle);
        break;
    }
    case 1: {
        b2EdgeShape edge;
        const float width = Size();
        const b2Vec2 from = Vector(0.01f * width), to = b2Vec2(2.0f * width, 0.0f) - from;
        if (material % 3 == 0)
            edge.SetOneSided(from - b2Vec2(1.0f, 0.5f), from, to, to + b2Vec2(1.0f, -0.5f));
        else
            edge.SetTwoSided(from, to);
        m_world->Create(body, def, edge);
        break;
    }
    case 2:
        MakeChain(body, def, false);
        break;
    case 3:
        MakeChain(body, def, true);
        break;
    case 4:
    case 5:
    case 6:
    case 7:
        if (m_anySize) {
            AnySize size;
            size.kind = Below(4);
            size.vertices = 3 + Byte();
            // What spins and is as large as a town takes milliseconds for each time of impact.
            constexpr float kLargest = 10.0f;
            size.width = b2Min(Size(), kLargest);
            size.height =
                size.kind == 0 || size.kind == 3 ? Unsigned(1.0f / 255.0f) : b2Min(Size(), kLargest);
            def.userData.pointer = m_world->NextFixture();
            CreateAnySize(body, def, size);
            break;
        }
        [[fallthrough]];
    default: {
        b2PolygonShape polygon;
        MakePolygon(&polygon);
        if (material / 16 % 4 == 3) // the skins of a body's polygons need not be equal
            polygon.m_radius *= material % 2 == 0 ? 20.0f : 0.5f;
        m_world->Create(body, def, polygon);
    }
    }
}

void Actor::ResizeInPlace() {
    b2Fixture *fixture = SomeFixture();
    b2PolygonShape *polygon = fixture != nullptr ? PlainPolygon(*fixture) : nullptr;
    if (polygon == nullptr)
        return;
    const int how = Byte();
    MakePolygon(polygon);
    if (how / 2 % 2 == 0 && fixture->GetBody()->GetType() == b2_dynamicBody)
        fixture->GetBody()->ResetMassData();
}

/// Some of its vertices go towards vertices of its body, so that they stay within the body's hull while the
/// normals stay as they were.
void Actor::PullVerticesInPlace(b2PolygonShape *polygon, b2Body *body) {
    const int which = Byte();
    for (int i = 0; i < polygon->m_count; ++i) {
        if ((which >> i & 1) == 0)
            continue;
        const b2PolygonShape *other = PlainPolygon(*SomeFixtureOf(body));
        const b2Vec2 target = other != nullptr && other->m_count > 0
                                  ? other->m_vertices[Below(other->m_count)]
                                  : polygon->m_centroid;
        polygon->m_vertices[i] += Unsigned(1.0f / 255.0f) * (target - polygon->m_vertices[i]);
    }
}

/// Larger by some units in the last place, or shifted by as much; or some vertices alone moved, so that
/// normals are those of other sides.
void Actor::NudgeShapeInPlace() {
    b2Fixture *fixture = SomeFixture();
    b2PolygonShape *polygon = fixture != nullptr ? PlainPolygon(*fixture) : nullptr;
    if (polygon == nullptr)
        return;
    const int how = Byte();
    if (how >= 0xf0) {
        const float far = Below(2) == 0 ? 1e-7f : 1e-3f;
        polygon->m_vertices[how % polygon->m_count] += Vector(far);
        return;
    }
    if (how >= 0xe0) {
        PullVerticesInPlace(polygon, fixture->GetBody());
        return;
    }
    const float scale = 1.0f + (how % 4 == 0 ? 0.01f : 1.2e-7f) * static_cast<float>(how / 16);
    const b2Vec2 shift = how % 4 == 1 ? Vector(1e-6f) : b2Vec2(0.0f, 0.0f);
    for (int i = 0; i < polygon->m_count; ++i)
        polygon->m_vertices[i] = scale * polygon->m_vertices[i] + shift;
    polygon->m_centroid = scale * polygon->m_centroid + shift;
}

void Actor::ChangeRadiusInPlace() {
    static constexpr float kRadii[] = {b2_polygonRadius, 0.0f, 0.5f * b2_polygonRadius,
                                       4.0f * b2_polygonRadius, 0.3f};
    static constexpr float kNegative[] = {-b2_polygonRadius, -0.0f, -1e-6f, -0.5f * b2_polygonRadius, -0.1f};
    constexpr int kFirstNegative = 250;
    b2Fixture *fixture = SomeFixture();
    const int byte = Byte(), which = byte % 5;
    if (fixture != nullptr && fixture->GetType() != b2Shape::e_circle) {
        fixture->GetShape()->m_radius = byte < kFirstNegative ? kRadii[which] : kNegative[which];
    }
}

void Actor::ChangeRoundInPlace() {
    b2Fixture *fixture = SomeFixture();
    const float size = Size();
    const b2Vec2 shift = Vector(0.01f);
    if (fixture == nullptr)
        return;
    if (fixture->GetType() == b2Shape::e_circle) {
        b2CircleShape *circle = static_cast<b2CircleShape *>(fixture->GetShape());
        circle->m_radius = size;
        circle->m_p = shift;
    } else if (fixture->GetType() == b2Shape::e_edge) {
        static_cast<b2EdgeShape *>(fixture->GetShape())->m_vertex1 += shift;
    }
}

/// In scripts of any size, for stock has none.
void Actor::AddOutline() {
    b2Body *body = SomeBody();
    const int material = Byte();
    const float width = Size();
    const float depth = Unsigned(1.0f / 255.0f) * width;
    if (body == nullptr || !m_anySize)
        return;
    b2FixtureDef def;
    def.density = 1.0f;
    def.isSensor = material % 8 == 0;
    def.userData.pointer = m_world->NextFixture();
    CreateOutline(body, def, b2Min(width, 10.0f), depth);
}

void EditAll(b2Body *body, float scale, b2Vec2 by) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        if (b2PolygonShape *polygon = PlainPolygon(*f)) {
            for (int32 i = 0; i < polygon->m_count; ++i)
                polygon->m_vertices[i] =
                    polygon->m_centroid + scale * (polygon->m_vertices[i] - polygon->m_centroid) + by;
            polygon->m_centroid += by;
        } else if (f->GetType() == b2Shape::e_circle) {
            auto *circle = static_cast<b2CircleShape *>(f->GetShape());
            circle->m_radius *= scale;
            circle->m_p += by;
        } else if (f->GetType() == b2Shape::e_edge) {
            auto *edge = static_cast<b2EdgeShape *>(f->GetShape());
            for (b2Vec2 *corner : {&edge->m_vertex0, &edge->m_vertex1, &edge->m_vertex2, &edge->m_vertex3})
                *corner = scale * *corner + by;
        } else if (f->GetType() == b2Shape::e_chain) {
            auto *chain = static_cast<b2ChainShape *>(f->GetShape());
            for (int32 i = 0; i < chain->m_count; ++i)
                chain->m_vertices[i] = scale * chain->m_vertices[i] + by;
        }
    }
}

/// All shapes of a body.
void Actor::EditAllInPlace() {
    static constexpr float kScales[] = {1.0f, 1.4f, 0.5f, 1.0f, 1.25f, 1.0f};
    const b2Vec2 shifts[] = {{0.15f, 0.0f},  {0.0f, 0.0f}, {0.0f, 0.0f},
                             {-0.15f, 0.0f}, {0.0f, 0.0f}, {0.0f, 30.0f}};
    b2Body *body = SomeBody();
    const int how = Byte();
    if (body == nullptr)
        return;
    EditAll(body, kScales[how % 6], shifts[how % 6]);
}

} // namespace actor
