// SPDX-License-Identifier: MIT
// Many bodies at once: to begin with, and changed together.
#include <algorithm>
#include <cmath>

#include "../../kit/random.h"
#include "actor.h"

namespace actor {

namespace {

/// Numbers of its own from one byte or two: a crowd would read too many.
class Dice {
public:
    explicit Dice(uint32_t seed) : m_random{seed} {}
    int Below(int n) { return static_cast<int>(test_random_below(&m_random, static_cast<uint32_t>(n))); }
    bool OnceIn(int n) { return Below(n) == 0; }
    float Between(float low, float high) {
        return low + (high - low) * static_cast<float>(Below(4096)) / 4096.0f;
    }
    b2Vec2 Within(float reach) {
        const float x = Between(-reach, reach);
        const float y = Between(-reach, reach);
        return {x, y};
    }

private:
    test_random m_random;
};

b2PolygonShape Box(float x, float y, b2Vec2 middle = {0.0f, 0.0f}, float angle = 0.0f) {
    b2PolygonShape box;
    box.SetAsBox(x, y, middle, angle);
    return box;
}

b2Vec2 OnCircle(float radius, int i, int of) {
    return radius * b2Rot(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(of)).GetXAxis();
}

/// Around the origin. (A triangle of a wheel: its corners are the origin and two of a circle's.)
b2PolygonShape Triangle(b2Vec2 from, b2Vec2 to) {
    const b2Vec2 corners[3] = {{0.0f, 0.0f}, from, to};
    b2PolygonShape triangle;
    triangle.Set(corners, 3);
    return triangle;
}

} // namespace

/// All of them.
void Actor::MoveElsewhere() {
    static constexpr float kScales[] = {0.01f, 1.0f, 8.0f, 1000.0f};
    const float scale = kScales[Below(4)];
    const b2Vec2 by = Vector(scale);
    m_origin += by;
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        body->SetTransform(body->GetPosition() + by, body->GetAngle());
}

void Actor::WakeAll() {
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        body->SetAwake(true);
    Box2D().ClearForces();
}

/// Of all bodies.
void Actor::EmptyWorld() {
    DestroyGears();
    while (b2Body *body = Box2D().GetBodyList())
        Box2D().DestroyBody(body);
}

/// As many small bodies as there is room for, in rows: near enough for contacts, far enough for budgets.
void Actor::Crowd() {
    const int how = Byte();
    const float size = 0.1f + 0.01f * static_cast<float>(how % 16);
    const float pitch = 2.0f * size + 0.02f * static_cast<float>(how / 16);
    const b2Vec2 first = Place();
    b2PolygonShape box;
    box.SetAsBox(size, size);
    b2FixtureDef fixture;
    fixture.density = 1.0f;
    fixture.isSensor = how == 255;
    for (int i = 0; MayGrow(); ++i) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.bullet = i % 5 == 0;
        def.position = first + pitch * b2Vec2(static_cast<float>(i % 5), static_cast<float>(i / 5));
        m_world->Create(m_world->Create(def), fixture, box);
    }
}

/// A box, a triangle, a wheel; turned, off its centre, asleep, shot: as `how` says of all.
void Actor::Throng() {
    const int how = Byte(), number = Byte();
    const float wide = 2.0f + Unsigned(0.06f);
    Dice dice(static_cast<uint32_t>(Byte()) * 256u + Byte());
    b2FixtureDef material;
    material.density = 1.0f;
    for (int i = 0; i < number && MayGrow(); ++i) {
        b2BodyDef def;
        def.type = dice.OnceIn(20) ? b2_kinematicBody : b2_dynamicBody;
        def.position = m_origin + dice.Within(wide);
        def.angle = dice.Between(0.0f, 3.0f);
        if ((how & 1) != 0 && dice.OnceIn(3))
            def.angle = dice.Between(0.5f, 1.0f) * (dice.OnceIn(2) ? 1e3f : dice.OnceIn(2) ? 1e5f : -3e6f);
        def.awake = (how & 2) == 0 || dice.OnceIn(30);
        def.bullet = (how & 4) != 0 && dice.OnceIn(3);
        def.allowSleep = !dice.OnceIn(8);
        b2Body *body = m_world->Create(def);
        material.isSensor = dice.OnceIn(12);
        if (dice.OnceIn(9)) {
            const int count = 3 + dice.Below(5);
            const float radius = dice.Between(0.2f, 0.6f);
            for (int k = 0; k < count; ++k)
                m_world->Create(body, material,
                                Triangle(OnCircle(radius, k, count), OnCircle(radius, k + 1, count)));
        } else {
            const float x = dice.Between(0.02f, 0.6f);
            b2PolygonShape shape = Box(x, dice.Between(0.02f, 0.3f));
            if (dice.OnceIn(3))
                shape.Set(shape.m_vertices, 3);
            m_world->Create(body, material, shape);
        }
        if ((how & 8) != 0 && def.type == b2_dynamicBody && dice.OnceIn(3)) {
            b2MassData mass;
            body->GetMassData(&mass);
            mass.center = dice.Within(dice.OnceIn(3) ? 20.0f : 0.3f);
            mass.I = mass.mass * (b2Dot(mass.center, mass.center) + 1.0f);
            body->SetMassData(&mass);
        }
        if (!def.awake)
            continue;
        body->SetLinearVelocity(dice.Within(def.bullet && dice.OnceIn(2) ? 90.0f : 2.0f));
        body->SetAngularVelocity(dice.Between(-1.0f, 1.0f));
    }
}

/// An arena out of which nothing stays, with a rough floor; or a floor; plates that rest or turn.
void Actor::BuildLevel() {
    const int how = Byte();
    Dice dice(Byte());
    const float x = how % 2 == 0 ? 7.0f : 14.0f, y = how % 2 == 0 ? 5.0f : 9.0f;
    b2BodyDef def;
    def.position = m_origin;
    b2Body *arena = m_world->Create(def);
    const b2FixtureDef solid;
    m_world->Create(arena, solid, Box(x + 0.6f, 0.3f, {0.0f, -y - 0.3f}));
    if (how / 2 % 2 == 0) {
        m_world->Create(arena, solid, Box(x + 0.6f, 0.3f, {0.0f, y + 0.3f}));
        m_world->Create(arena, solid, Box(0.3f, y, {-x - 0.3f, 0.0f}));
        m_world->Create(arena, solid, Box(0.3f, y, {x + 0.3f, 0.0f}));
        m_world->rescueBeyond = x + 2.0f;
        m_world->home = m_origin;
    }
    if (how / 4 % 2 == 0) {
        b2Vec2 floor[11];
        for (int i = 0; i <= 10; ++i)
            floor[i] = {x * (1.0f - 0.2f * static_cast<float>(i)), dice.Between(0.1f, 0.8f) - y};
        b2ChainShape chain;
        chain.CreateChain(floor, 11, floor[0] + b2Vec2(1.0f, 0.0f), floor[10] - b2Vec2(1.0f, 0.0f));
        m_world->Create(arena, solid, chain);
    }
    for (int i = how / 16 % 8; i > 0 && MayGrow(); --i) {
        def.type = dice.OnceIn(2) ? b2_kinematicBody : b2_staticBody;
        def.position = m_origin + dice.Within(0.8f * y);
        def.angle = dice.Between(0.0f, 3.0f);
        def.angularVelocity = dice.Between(-2.0f, 2.0f);
        def.linearVelocity = dice.Within(1.0f);
        m_world->Create(m_world->Create(def), solid,
                        Box(dice.Between(0.02f, 0.3f), dice.Between(0.5f, 4.0f)));
    }
}

/// A body of many fixtures: a fan around a rough or a round outline, which may have more vertices than a hull
/// keeps; a plank of boxes; an eye, which is a sensor with solid parts; a loop of edges that turns.
void Actor::CreateCompound() {
    const int how = Byte();
    const b2Vec2 place = Place();
    Dice dice(static_cast<uint32_t>(Byte()) * 256u + Byte());
    if (!MayGrow())
        return;
    b2BodyDef def;
    def.type = how % 8 == 7 ? b2_kinematicBody : b2_dynamicBody;
    def.position = place;
    def.angle = dice.Between(-3.0f, 3.0f);
    def.bullet = how / 64 == 0;
    def.linearVelocity = dice.Within(how / 64 == 1 ? 60.0f : 3.0f);
    def.angularVelocity = dice.Between(-3.0f, 3.0f);
    b2Body *body = m_world->Create(def);
    b2FixtureDef material;
    material.density = dice.OnceIn(12) ? 0.0f : 1.0f;
    material.restitution = dice.OnceIn(3) ? 0.6f : 0.0f;
    switch (how / 8 % 4) {
    case 0: {
        const int size = dice.Below(30); // few have very many
        const int count = 5 + dice.Below(size == 0  ? m_mostFixtures - 5
                                         : size < 6 ? std::min(m_mostFixtures - 5, 35)
                                                    : 6);
        const float least = dice.OnceIn(2) ? 0.9f : 0.3f;
        b2Vec2 first(0.0f, 0.0f), before(0.0f, 0.0f);
        for (int i = 0; i <= count; ++i) {
            const b2Vec2 corner = i == count ? first : OnCircle(0.9f * dice.Between(least, 1.0f), i, count);
            if (i == 0)
                first = corner;
            else if (b2Cross(before, corner) > 0.01f)
                m_world->Create(body, material, Triangle(before, corner));
            before = corner;
        }
        break;
    }
    case 1:
        for (int i = dice.Below(4); i >= 0; --i)
            m_world->Create(body, material, Box(0.4f, 0.06f, {0.8f * static_cast<float>(i) - 0.8f, 0.0f}));
        break;
    case 2: {
        b2FixtureDef eye = material;
        eye.isSensor = true;
        m_world->Create(body, eye, Box(1.2f, 0.9f));
        m_world->Create(body, material, Box(0.2f, 0.3f, dice.Within(0.8f), 0.5f));
        b2CircleShape circle;
        circle.m_radius = dice.Between(0.1f, 0.4f);
        circle.m_p = dice.Within(0.5f);
        m_world->Create(body, material, circle);
        break;
    }
    default: {
        b2Vec2 corners[8];
        for (int i = 0; i < 8; ++i)
            corners[i] = OnCircle(dice.Between(0.5f, 1.5f), i, 8);
        b2ChainShape loop;
        loop.CreateLoop(corners, 8);
        material.isSensor = dice.OnceIn(3);
        m_world->Create(body, material, loop);
    }
    }
}

/// Pairs whose fat boxes overlap although they stay apart, of every kind: boxes; one static, kinematic, a
/// circle, an edge, a chain, a needle, a sensor, a bullet before a plate, a wheel; one that turns about a
/// point 40 m away; next to no room between them; one that drifts by a tenth of a millimetre a step.
void Actor::CreatePairs() {
    const int how = Byte(), first = Byte();
    constexpr int kKinds = 14;
    constexpr float kSide = 0.25f;
    for (int i = 0; i < 2 + how % 32 && MayGrow(); ++i) {
        const int kind = (first + i) % kKinds;
        const float room = kind == 12 ? 0.0203f + 0.0004f * static_cast<float>(i % 4) : 0.06f;
        const b2Vec2 at =
            m_origin + b2Vec2(4.0f * static_cast<float>(i % 6), 4.0f * static_cast<float>(i / 6));
        b2BodyDef def;
        def.allowSleep = how / 32 % 2 != 0;
        def.gravityScale = 0.0f;
        def.position = at;
        def.type = kind == 1 || kind == 4 || kind == 5 ? b2_staticBody
                   : kind == 2                         ? b2_kinematicBody
                                                       : b2_dynamicBody;
        b2Body *right = m_world->Create(def);
        def.type = b2_dynamicBody;
        const float half = kind == 6 ? 0.02f : kind == 8 ? 0.05f : kSide;
        def.position = at - b2Vec2(kSide + room + half, kind == 11 ? 40.0f : 0.0f);
        def.bullet = kind == 8;
        if (kind == 13)
            def.linearVelocity = {0.006f, 0.0f};
        b2Body *left = m_world->Create(def);
        b2FixtureDef material;
        material.density = 1.0f;
        if (kind == 4) {
            b2EdgeShape edge;
            edge.SetTwoSided({-kSide, -1.0f}, {-kSide, 1.0f});
            m_world->Create(right, material, edge);
        } else if (kind == 5) {
            const b2Vec2 points[3] = {{-kSide, 1.0f}, {-kSide, 0.0f}, {-kSide, -1.0f}};
            b2ChainShape chain;
            chain.CreateChain(points, 3, {-kSide, 2.0f}, {-kSide, -2.0f});
            m_world->Create(right, material, chain);
        } else if (kind == 9) {
            for (int k = 0; k < 6; ++k)
                m_world->Create(right, material, Triangle(OnCircle(kSide, k, 6), OnCircle(kSide, k + 1, 6)));
        } else {
            m_world->Create(right, material, Box(kSide, kind == 6 ? 1.2f : 0.5f));
        }
        material.isSensor = kind == 7 || kind == 10;
        if (kind == 3) {
            b2CircleShape circle;
            circle.m_radius = kSide;
            m_world->Create(left, material, circle);
        } else {
            m_world->Create(left, material,
                            Box(half, kind == 6 ? 1.2f : half, {0.0f, kind == 11 ? 40.0f : 0.0f}));
        }
        if (kind == 10) // in the other one
            left->SetTransform(at, 0.0f);
        if (kind == 11) {
            const b2MassData about = {1.0f, {0.0f, 0.0f}, 2000.0f};
            left->SetMassData(&about);
        }
    }
}

/// Balls, each between two walls that it never leaves: they bounce to and fro, and in every few steps
/// contacts begin, end, are solved; where walls are static, by impacts.
void Actor::CreateDrums() {
    const int how = Byte();
    for (int i = 0; i < 1 + how % 4 && MayGrow(); ++i) {
        const b2Vec2 middle =
            m_origin + b2Vec2(-4.0f - static_cast<float>(how / 4 % 8), 3.0f * static_cast<float>(i));
        b2BodyDef def;
        def.allowSleep = false;
        def.gravityScale = 0.0f;
        b2FixtureDef material;
        for (const float side : {-1.0f, 1.0f}) {
            def.type = (how + i) % 2 == 0 ? b2_staticBody : b2_dynamicBody;
            def.position = middle + b2Vec2(0.3f * side, 0.0f);
            material.density = 1.0e6f;
            m_world->Create(m_world->Create(def), material, Box(0.1f, 0.4f));
        }
        def.type = b2_dynamicBody;
        def.position = middle + b2Vec2(0.03f * static_cast<float>(i % 3 - 1), 0.0f);
        def.fixedRotation = true;
        def.linearVelocity = {i % 2 == 0 ? 4.0f : -4.0f, 0.0f};
        material.density = 1.0f;
        material.restitution = 1.0f;
        m_world->Create(m_world->Create(def), material, Box(0.1f, 0.1f));
    }
}

/// All bodies that move, at nearly the same speed: out, and in again.
void Actor::Drive() {
    const float scale = Below(4) == 0 ? 0.5f : 0.02f;
    const b2Vec2 velocity = Vector(scale);
    Dice dice(Byte());
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody)
            body->SetLinearVelocity(velocity + dice.Within(0.5f));
}

void Actor::RestSome() {
    const int how = Byte();
    int i = 0;
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        if (i++ % (2 + how % 8) != how / 8 % 4)
            body->SetAwake(how / 32 == 7);
}

/// Many of them are carried away, each elsewhere: as many contacts end at once.
void Actor::Scatter() {
    const int how = Byte();
    const float far = 4.0f + Unsigned(0.1f);
    Dice dice(Byte());
    for (b2Body *body = Box2D().GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody && dice.Below(8) <= how % 8)
            body->SetTransform(m_origin + dice.Within(far), body->GetAngle());
}

/// All bodies go, some steps are had, none among them, and others come.
void Actor::FillAgain() {
    EmptyWorld();
    for (int steps = m_origin.x == 0.0f ? 1 : 0; steps > 0; --steps)
        m_world->Step(m_timeStep, m_velocityIterations, m_positionIterations);
    Throng();
}

} // namespace actor
