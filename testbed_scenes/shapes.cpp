// SPDX-License-Identifier: MIT
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace testbed {
namespace {

b2Vec2 OnCircle(float radius, float angle) {
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

float NthAngle(int i, int count) {
    return 2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(count);
}

} // namespace

b2PolygonShape MakeBox(float halfWidth, float halfHeight, b2Vec2 center, float angle) {
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight, center, angle);
    return shape;
}

b2PolygonShape MakeRegular(int count, float radius, float phase) {
    const Vertices vertices = RegularVertices(count, radius, phase);
    b2PolygonShape shape;
    shape.Set(vertices.data(), static_cast<int32>(vertices.size()));
    return shape;
}

b2CircleShape MakeCircle(float radius, b2Vec2 center) {
    b2CircleShape shape;
    shape.m_radius = radius;
    shape.m_p = center;
    return shape;
}

b2EdgeShape MakeEdge(b2Vec2 from, b2Vec2 to) {
    b2EdgeShape shape;
    shape.SetTwoSided(from, to);
    return shape;
}

Vertices RegularVertices(int count, float radius, float phase) {
    Vertices vertices;
    for (int i = 0; i < count; ++i)
        vertices.push_back(OnCircle(radius, phase + NthAngle(i, count)));
    return vertices;
}

Vertices RoughVertices(Random &random, int count, float inner, float outer) {
    Vertices vertices;
    for (int i = 0; i < count; ++i)
        vertices.push_back(OnCircle(random.Uniform(inner, outer), NthAngle(i, count)));
    return vertices;
}

Vertices StarVertices(int count, float inner, float outer) {
    Vertices vertices;
    for (int i = 0; i < count; ++i) {
        float radius = i % 2 == 0 ? outer : inner;
        // Two neighbouring points of an odd star would both be at `outer`.
        if (count % 2 == 1 && i == count - 1)
            radius = 0.5f * (inner + outer);
        vertices.push_back(OnCircle(radius, NthAngle(i, count)));
    }
    return vertices;
}

b2Body *AddArena(Stage &stage, b2Vec2 center, float halfWidth, float halfHeight, float restitution) {
    constexpr float thickness = 1.0f; // half of it: thick enough that nothing is pushed through
    b2Body *arena = stage.AddBody(b2_staticBody, center);
    const b2FixtureDef def = Material(0.0f, 0.2f, restitution);
    const float x = halfWidth + thickness;
    const float y = halfHeight + thickness;
    stage.AddFixture(arena, def, MakeBox(halfWidth, thickness, {0.0f, -y}));
    stage.AddFixture(arena, def, MakeBox(halfWidth, thickness, {0.0f, y}));
    stage.AddFixture(arena, def, MakeBox(thickness, y + thickness, {-x, 0.0f}));
    stage.AddFixture(arena, def, MakeBox(thickness, y + thickness, {x, 0.0f}));
    return arena;
}

Vertices MakeHills(Random &random, b2Vec2 from, float width, const Swell &swell) {
    constexpr float wall = 20.0f, step = 1.0f;
    Vertices hills{{from.x, from.y + wall}};
    for (float x = 0.0f; x <= width; x += step) {
        const float y = swell.height * std::sin(swell.frequency * x);
        hills.push_back(from + b2Vec2(x, y + random.Uniform(-swell.roughness, swell.roughness)));
    }
    hills.push_back(from + b2Vec2(width, wall));
    return hills;
}

void AddEdges(Stage &stage, const Vertices &hills, float friction) {
    b2Body *ground = stage.AddBody(b2_staticBody, {0.0f, 0.0f});
    for (std::size_t i = 0; i + 1 < hills.size(); ++i)
        stage.AddFixture(ground, Material(0.0f, friction), MakeEdge(hills[i], hills[i + 1]));
}

void AddChain(Stage &stage, const Vertices &hills) {
    const Vertices reversed(hills.rbegin(), hills.rend());
    b2ChainShape chain;
    chain.CreateChain(reversed.data(), static_cast<int32>(reversed.size()), reversed.front() + b2Vec2(0, 1),
                      reversed.back() + b2Vec2(0, 1));
    stage.AddFixture(stage.AddBody(b2_staticBody, {0.0f, 0.0f}), chain, 0.0f);
}

namespace {

b2WheelJoint *AddWheel(Stage &stage, b2Body *car, b2Vec2 position, float torque) {
    b2Body *wheel = stage.AddBody(b2_dynamicBody, position);
    stage.AddFixture(wheel, Material(1.0f, 0.9f), MakeCircle(0.4f));
    b2WheelJointDef def;
    def.Initialize(car, wheel, position, {0.0f, 1.0f});
    def.maxMotorTorque = torque;
    def.enableMotor = torque > 0.0f;
    b2LinearStiffness(def.stiffness, def.damping, 4.0f, 0.7f, car, wheel);
    def.lowerTranslation = -0.25f;
    def.upperTranslation = 0.25f;
    def.enableLimit = true;
    return static_cast<b2WheelJoint *>(stage.AddJoint(def));
}

} // namespace

b2WheelJoint *AddCar(Stage &stage, b2Vec2 road) {
    const b2Vec2 corners[] = {b2Vec2(-1.5f, -0.5f), b2Vec2(1.5f, -0.5f),  b2Vec2(1.5f, 0.0f),
                              b2Vec2(0.0f, 0.9f),   b2Vec2(-1.15f, 0.9f), b2Vec2(-1.5f, 0.2f)};
    b2PolygonShape chassis;
    chassis.Set(corners, 6);
    b2Body *car = stage.AddBody(b2_dynamicBody, road + b2Vec2(0.0f, 1.0f));
    stage.AddFixture(car, chassis, 1.0f);
    b2WheelJoint *motor = AddWheel(stage, car, road + b2Vec2(-1.0f, 0.4f), 40.0f);
    AddWheel(stage, car, road + b2Vec2(1.0f, 0.4f), 0.0f);
    return motor;
}

Grid::Grid(int size, int columns, float spacing)
    : halfWidth(0.5f * spacing * static_cast<float>(columns)),
      halfHeight(0.5f * spacing * static_cast<float>((size + columns - 1) / columns)), m_columns(columns),
      m_spacing(spacing) {}

b2Vec2 Grid::Place(int index) const {
    const int column = index % m_columns, row = index / m_columns;
    return {m_spacing * (0.5f + static_cast<float>(column)) - halfWidth,
            m_spacing * (0.5f + static_cast<float>(row)) - halfHeight};
}

b2Vec2 InRows(int i, int columns, float spacing, float lowest) {
    const int column = i % columns, row = i / columns;
    return {spacing * (static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1)),
            lowest + spacing * static_cast<float>(row)};
}

b2BodyDef Drifting(Random &random, b2Vec2 place, float slowest, float fastest, float spin) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = place;
    def.angle = random.Uniform(-b2_pi, b2_pi);
    def.linearVelocity = random.Direction(slowest, fastest);
    def.angularVelocity = random.Uniform(-spin, spin);
    return def;
}

b2FixtureDef Material(float density, float friction, float restitution) {
    b2FixtureDef def;
    def.density = density;
    def.friction = friction;
    def.restitution = restitution;
    return def;
}

namespace {

/// A convex polygon in pieces of at most 8 vertices, all of which share its first vertex.
std::vector<Vertices> CutConvex(const Vertices &vertices) {
    constexpr int added = b2_maxPolygonVertices - 1; // a piece is the first vertex and a run of these
    std::vector<Vertices> pieces;
    const int count = static_cast<int>(vertices.size());
    for (int first = 1; first < count - 1; first += added - 1) {
        const int last = std::min(first + added - 1, count - 1);
        Vertices piece{vertices.front()};
        piece.insert(piece.end(), vertices.begin() + first, vertices.begin() + last + 1);
        pieces.push_back(std::move(piece));
    }
    return pieces;
}

Fixtures MakePolygons(const std::vector<Vertices> &polygons) {
    std::vector<std::unique_ptr<b2Shape>> pieces;
    for (const Vertices &vertices : polygons) {
        auto shape = std::make_unique<b2PolygonShape>();
        shape->Set(vertices.data(), static_cast<int32>(vertices.size()));
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

Fixtures AnySizePolygon(BodyKind kind, const Vertices &vertices) {
    return kind == BodyKind::One ? MakeOne(MakeOnePolygon(vertices)) : MakePolygons(CutConvex(vertices));
}

Fixtures AnySizePolygon(const PolygonChoice &choice, float radius, float phase) {
    if (choice.bodies == BodyKind::Circle)
        return MakeOne(std::make_unique<b2CircleShape>(MakeCircle(radius)));
    return AnySizePolygon(choice.bodies, RegularVertices(choice.vertices, radius, phase));
}

void Fixtures::AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const {
    for (const std::unique_ptr<b2Shape> &piece : m_pieces)
        stage.AddFixture(body, def, *piece);
}

Concave StarShaped(const Vertices &ring) {
    Concave concave{ring, {}, {}};
    for (std::size_t i = 0; i < ring.size(); ++i)
        concave.triangles.push_back({b2Vec2(0.0f, 0.0f), ring[i], ring[(i + 1) % ring.size()]});
    return concave;
}

Fixtures OutlinedBody(BodyKind kind, const Concave &concave, float tolerance) {
    return kind == BodyKind::One ? Fixtures(MakeOutlinePieces(concave, tolerance))
                                 : MakePolygons(concave.triangles);
}

} // namespace testbed
