// SPDX-License-Identifier: MIT
// Bodies that are thrown about in rooms whose wall is an outline: how many leave through the wall, with the
// outline and with its pieces as polygons that know of no seams; and how many impacts Box2D found and dropped
// because the contact that it found had no points.
//
// usage: outline_throws outlines|pieces [THROWS] [SEED]
// Prints the counts for each kind of room, and a hash of every body's state at the end of every throw. Exit
// codes: 0, or 2 for wrong usage.
#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <box2d/box2d.h>

#include "boomerang/outline_shape.h"
#include "box2d_shapes.h"
#include "plain_pieces.h"
#include "small_world.h"

using namespace shapes;

namespace {

constexpr float kTurn = 6.2831853f, kInner = 4.0f;
constexpr int kBodies = 6, kSteps = 4, kThrowsOfARoom = 25;

using Points = std::vector<b2Vec2>;

[[noreturn]] void Die(const char *what) {
    std::fprintf(stderr, "outline_throws: %s\n", what);
    std::exit(2);
}

enum Kind { kRing, kThinRing, kGear, kInsideOut, kTees, kOtherTees, kAny, kKinds };
const char *const kNames[kKinds] = {"ring of 0.5 m",
                                    "ring of 0.1 m",
                                    "notches inside",
                                    "notches outside",
                                    "T seams outside",
                                    "T seams inside",
                                    "any"};

/// Around the origin, its radius by the direction.
Points Around(int count, float turned, float even, float odd) {
    Points points;
    for (int i = 0; i < count; ++i) {
        const float angle = turned + kTurn * static_cast<float>(i) / static_cast<float>(count);
        const float r = i % 2 == 0 ? even : odd;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    return points;
}

/// A wall around the origin: where one is beyond `outside` one is out.
struct Room {
    Points outside, inside;
    float free; ///< so far from the origin there is no wall
    bmr::OutlineShape outline;
};

Room MakeRoom(Engine &engine, Kind kind) {
    Room room;
    const float turned = UniformF(engine, 0.0, kTurn);
    const int n = 8 + 2 * Below(engine, 13), few = 3 + Below(engine, 3);
    const float wall = Below(engine, 2) == 0 ? 0.1f : UniformF(engine, 0.1, 0.5);
    switch (kind) {
    case kRing:
    case kThinRing: {
        const float thick = kind == kRing ? 0.5f : 0.1f;
        room.inside = Around(24, turned, kInner, kInner);
        room.outside = Around(24, turned, kInner + thick, kInner + thick);
        break;
    }
    case kGear:
        room.inside = Around(n, turned, kInner, UniformF(engine, 3.2, 3.9));
        room.outside = Around(n, turned, kInner + 2 * wall, kInner + 2 * wall);
        break;
    case kInsideOut:
        room.inside = Around(n, turned, kInner, kInner);
        room.outside = Around(n, turned, kInner + 0.2f + wall, kInner + UniformF(engine, 0.3, 0.9));
        break;
    case kTees:
        room.inside = Around(few, turned, kInner, kInner);
        room.outside = Around(2 * n, turned, kInner + 0.3f + wall, kInner + 0.2f);
        break;
    case kOtherTees:
        room.inside = Around(2 * n, turned, kInner, kInner - 0.2f);
        room.outside = Around(few, turned, 2.1f * kInner + wall, 2.1f * kInner + wall);
        break;
    default:
        for (int i = 0; i < n; ++i) {
            const float angle =
                turned + kTurn * (static_cast<float>(i) + UniformF(engine, 0.0, 0.8)) / static_cast<float>(n);
            const float r = UniformF(engine, 3.2, 4.2);
            room.inside.emplace_back(r * std::cos(angle), r * std::sin(angle));
            room.outside.push_back((1.0f + wall / r) * room.inside.back());
        }
    }
    room.free = kInner;
    for (size_t i = 0; i < room.inside.size(); ++i) {
        const b2Vec2 from = room.inside[i], along = room.inside[(i + 1) % room.inside.size()] - from;
        room.free = std::min(room.free, b2Cross(from, along) / along.Length());
    }
    const bmr::OutlineHole hole = {room.inside.data(), static_cast<int32>(room.inside.size())};
    if (const bmr_error error =
            room.outline.Set(room.outside.data(), static_cast<int32>(room.outside.size()), &hole, 1))
        Die(bmr_error_describe(error));
    return room;
}

void AddWhole(b2Body *body, const b2FixtureDef &def, const bmr::OutlineShape &outline, bool seams) {
    if (!seams)
        outlines::AddPlainPieces(body, def, outline);
    else if (const bmr_error error = outline.CreateFixtures(body, def))
        Die(bmr_error_describe(error));
}

void AddThrown(b2Body *body, const b2FixtureDef &def, Engine &engine, bool seams) {
    b2FixtureDef each = def;
    const float size = UniformF(engine, 0.05, 0.25);
    b2PolygonShape polygon;
    b2CircleShape circle;
    bmr::ConvexShape coin;
    const Points corner = {{0, 0},
                           {2 * size, 0},
                           {2 * size, 0.5f * size},
                           {0.5f * size, 0.5f * size},
                           {0.5f * size, 2 * size},
                           {0, 2 * size}};
    switch (Below(engine, 8)) {
    case 0:
        circle.m_radius = size;
        each.shape = &circle;
        break;
    case 1:
        if (coin.SetRegular(9 + Below(engine, 30), size) != BMR_OK)
            Die("no coin");
        each.shape = &coin;
        break;
    case 2: {
        bmr::OutlineShape outline;
        if (outline.Set(corner.data(), 6) != BMR_OK)
            Die("no corner");
        AddWhole(body, each, outline, seams);
        return;
    }
    case 3: {
        const b2Vec2 points[] = {{0, -size}, {0.3f * size, size}, {-0.3f * size, size}};
        polygon.Set(points, 3);
        each.shape = &polygon;
        break;
    }
    case 4:
        polygon.SetAsBox(2 * size, UniformF(engine, 0.02, 0.05));
        each.shape = &polygon;
        break;
    default:
        polygon.SetAsBox(size, UniformF(engine, 0.04, 0.25));
        each.shape = &polygon;
    }
    body->CreateFixture(&each);
}

bool IsIn(const Points &ring, b2Vec2 p) {
    bool in = false;
    for (size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        if ((ring[i].y > p.y) != (ring[j].y > p.y) &&
            p.x < (ring[j].x - ring[i].x) * (p.y - ring[i].y) / (ring[j].y - ring[i].y) + ring[i].x)
            in = !in;
    return in;
}

struct Counts {
    long throws = 0, lost = 0, stuck = 0, dropped = 0;

    void Print(const char *name) const {
        std::printf("%s: %ld throws, %ld lost, %ld in the wall, %ld dropped\n", name, throws, lost, stuck,
                    dropped);
    }
};

/// b2World::SolveTOI disables a contact that it drops an impact of, until the next step.
long CountDisabled(const b2World &world) {
    long count = 0;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        count += contact->IsEnabled() ? 0 : 1;
    return count;
}

/// How a room moves while things are thrown in it.
enum Motion { kStill, kTurned, kFree, kMotions };

/// A room in a world of its own, and what is thrown in it.
class Stage {
public:
    Stage(Engine *engine, Kind kind, bool seams) : m_engine(*engine), m_room(MakeRoom(m_engine, kind)) {
        constexpr float kDistances[] = {10.0f, 1000.0f, 8000.0f};
        m_motion = Below(m_engine, 3) == 0 ? static_cast<Motion>(1 + Below(m_engine, 2)) : kStill;
        const float distance = kDistances[Below(m_engine, 3)], towards = UniformF(m_engine, 0.0, kTurn);
        m_middle.Set(distance * std::cos(towards), distance * std::sin(towards));
        b2BodyDef def;
        def.type = m_motion == kStill    ? b2_staticBody
                   : m_motion == kTurned ? b2_kinematicBody
                                         : b2_dynamicBody;
        def.gravityScale = 0.0f;
        def.position = m_middle;
        m_wall = m_world.CreateBody(&def);
        b2FixtureDef fixture;
        fixture.density = 10.0f;
        fixture.restitution = Below(m_engine, 2) == 0 ? 0.0f : UniformF(m_engine, 0.0, 1.0);
        AddWhole(m_wall, fixture, m_room.outline, seams);
        def.type = b2_dynamicBody;
        def.bullet = m_motion == kFree || Below(m_engine, 4) == 0;
        def.gravityScale = 1.0f;
        fixture.density = 1.0f;
        fixture.friction = UniformF(m_engine, 0.0, 1.0);
        fixture.filter.groupIndex = -1;
        for (b2Body *&body : m_bodies) {
            body = m_world.CreateBody(&def);
            AddThrown(body, fixture, m_engine, seams);
        }
    }

    void Throw(Hash *hash, Counts *counts) {
        Begin();
        for (int i = 0; i < kSteps; ++i) {
            m_world.Step(1.0f / 60.0f, 8, 3);
            counts->dropped += CountDisabled(m_world);
        }
        for (const b2Body *body : m_bodies) {
            const b2Vec2 at = m_wall->GetLocalPoint(body->GetWorldCenter());
            ++counts->throws;
            counts->lost += !IsIn(m_room.outside, at);
            counts->stuck += IsIn(m_room.outside, at) && !IsIn(m_room.inside, at);
            const b2Vec2 p = body->GetPosition(), v = body->GetLinearVelocity();
            for (const float x : {p.x, p.y, body->GetAngle(), v.x, v.y, body->GetAngularVelocity()})
                hash->Add(x);
        }
    }

private:
    void Begin() {
        const float turned = UniformF(m_engine, -3.2, 3.2), spin = UniformF(m_engine, -6.0, 6.0);
        if (m_motion != kStill) {
            m_wall->SetTransform(m_middle, turned);
            m_wall->SetLinearVelocity(b2Vec2_zero);
            m_wall->SetAngularVelocity(spin);
        }
        for (b2Body *body : m_bodies) {
            const float angle = UniformF(m_engine, 0.0, kTurn),
                        r = UniformF(m_engine, 0.0, 0.68 * double{m_room.free}),
                        way = angle + UniformF(m_engine, -1.5, 1.5), speed = UniformF(m_engine, 20.0, 120.0);
            body->SetTransform(m_middle + r * b2Vec2(std::cos(angle), std::sin(angle)),
                               UniformF(m_engine, -3.2, 3.2));
            body->SetLinearVelocity(speed * b2Vec2(std::cos(way), std::sin(way)));
            body->SetAngularVelocity(Below(m_engine, 2) == 0 ? 0.0f : UniformF(m_engine, -100.0, 100.0));
            body->SetAwake(true);
        }
    }

    Engine &m_engine;
    Room m_room;
    Motion m_motion;
    b2Vec2 m_middle;
    b2World m_world{b2Vec2(0.0f, -10.0f)};
    b2Body *m_wall;
    b2Body *m_bodies[kBodies];
};

} // namespace

int main(int argc, char **argv) {
    if (argc < 2 || (std::strcmp(argv[1], "outlines") != 0 && std::strcmp(argv[1], "pieces") != 0))
        Die("usage: outline_throws outlines|pieces [THROWS] [SEED]");
    const bool seams = std::strcmp(argv[1], "outlines") == 0;
    const long throws = argc > 2 ? std::atol(argv[2]) : 10000;
    const uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    Hash hash;
    Counts counts[kKinds], all;
    for (uint64_t n = 0; all.throws < throws; ++n) {
        Engine engine(seed * 1000003u + n);
        Stage stage(&engine, static_cast<Kind>(n % kKinds), seams);
        for (int i = 0; i < kThrowsOfARoom; ++i)
            stage.Throw(&hash, &counts[n % kKinds]);
        all.throws += kBodies * kThrowsOfARoom;
    }
    for (int k = 0; k < kKinds; ++k) {
        counts[k].Print(kNames[k]);
        all.lost += counts[k].lost;
        all.stuck += counts[k].stuck;
        all.dropped += counts[k].dropped;
    }
    all.Print("all");
    std::printf("%016" PRIx64 "\n", hash.Value());
    return 0;
}
