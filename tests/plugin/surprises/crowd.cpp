// SPDX-License-Identifier: MIT
#include "crowd.h"

namespace surprises {

namespace {

/// When the pairs that are to be asleep fall asleep: after a while in which they were looked at.
constexpr int kStepOfSleep = 10;

constexpr float kSide = 0.25f, kRoom = 0.06f;

b2PolygonShape Box(float x, float y, b2Vec2 middle = {0.0f, 0.0f}) {
    b2PolygonShape box;
    box.SetAsBox(x, y, middle, 0.0f);
    return box;
}

b2PolygonShape Round(int corners) {
    b2Vec2 points[b2_maxPolygonVertices];
    for (int i = 0; i < corners; ++i)
        points[i] =
            kSide * b2Rot(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(corners)).GetXAxis();
    b2PolygonShape round;
    round.Set(points, corners);
    return round;
}

void AddWheel(b2Body *body) {
    for (int i = 0; i < 6; ++i) {
        const float from = b2_pi / 3.0f * static_cast<float>(i);
        const b2Vec2 corners[3] = {
            {0.0f, 0.0f}, kSide * b2Rot(from).GetXAxis(), kSide * b2Rot(from + b2_pi / 3.0f).GetXAxis()};
        b2PolygonShape piece;
        piece.Set(corners, 3);
        AddFixture(body, piece);
    }
}

/// How far a body's middle is from the middle between the two.
float Away(int kind, int copy, bool left) {
    switch (kind) {
    case kNeedles:
        return 0.02f + 0.5f * kRoom;
    case kFullSensor:
        return 0.1f;
    case kBullet:
        return (left ? 0.05f : 0.02f) + 0.5f * kRoom;
    case kBrink: // two polygons' skins are 0.02 m thick
        return kSide + 0.5f * (0.0203f + 0.0004f * static_cast<float>(copy));
    default:
        return kSide + 0.5f * kRoom;
    }
}

void AddLeft(b2Body *body, int kind) {
    switch (kind) {
    case kOctagon:
        AddFixture(body, Round(8));
        break;
    case kNeedles:
        AddFixture(body, Box(0.02f, 1.2f));
        break;
    case kCircle: {
        b2CircleShape circle;
        circle.m_radius = kSide;
        AddFixture(body, circle);
        break;
    }
    case kWheels:
        AddWheel(body);
        break;
    case kBullet:
        AddFixture(body, Box(0.05f, 0.05f));
        body->SetBullet(true);
        break;
    case kTurner: {
        AddFixture(body, Box(kSide, kSide, {0.0f, 40.0f}));
        const b2MassData about = {1.0f, {0.0f, 0.0f}, 2000.0f};
        body->SetMassData(&about);
        break;
    }
    default:
        AddFixture(body, Box(kSide, kSide), kind == kSensor || kind == kFullSensor);
    }
}

void AddRight(b2Body *body, int kind) {
    switch (kind) {
    case kOctagon: {
        const b2Vec2 corners[3] = {{-kSide, -kSide}, {kSide, 0.0f}, {-kSide, kSide}};
        b2PolygonShape triangle;
        triangle.Set(corners, 3);
        AddFixture(body, triangle);
        break;
    }
    case kNeedles:
        AddFixture(body, Box(0.02f, 1.2f));
        break;
    case kEdge: {
        b2EdgeShape edge;
        edge.SetTwoSided({-kSide, -1.0f}, {-kSide, 1.0f});
        AddFixture(body, edge);
        break;
    }
    case kChain: { // its side is the left one
        const b2Vec2 points[3] = {{-kSide, 1.0f}, {-kSide, 0.0f}, {-kSide, -1.0f}};
        b2ChainShape chain;
        chain.CreateChain(points, 3, {-kSide, 2.0f}, {-kSide, -2.0f});
        AddFixture(body, chain);
        break;
    }
    case kWheels:
        AddWheel(body);
        break;
    case kBullet:
        AddFixture(body, Box(0.02f, 0.5f));
        break;
    default:
        AddFixture(body, Box(kSide, kSide));
    }
}

b2BodyType TypeOf(int kind, bool left) {
    if (left)
        return b2_dynamicBody;
    if (kind == kKinematicBox)
        return b2_kinematicBody;
    return kind == kStaticBox || kind == kEdge || kind == kChain || kind == kAsleepStatic ? b2_staticBody
                                                                                          : b2_dynamicBody;
}

} // namespace

b2Fixture *AddFixture(b2Body *body, const b2Shape &shape, bool sensor, float density) {
    uintptr_t number = 1;
    for (const b2Body *other = body->GetWorld()->GetBodyList(); other != nullptr; other = other->GetNext())
        for (const b2Fixture *f = other->GetFixtureList(); f != nullptr; f = f->GetNext())
            number = b2Max(number, const_cast<b2Fixture *>(f)->GetUserData().pointer + 1);
    b2FixtureDef def;
    def.shape = &shape;
    def.density = density;
    def.isSensor = sensor;
    def.friction = 0.0f;
    def.userData.pointer = number;
    return body->CreateFixture(&def);
}

Crowd::Crowd(b2World *world, b2Vec2 at) : m_world(world), m_at(at) {
    // New contacts go to the head of Box2D's list: what is to be behind all others comes first.
    AddDrums(kLastDrum, -4.0f);
    m_world->Step(1.0f / 60.0f, 4, 2);
    for (int copy = 0; copy < kCopies; ++copy)
        for (int kind = 0; kind < kKinds; ++kind) {
            Pair pair = {nullptr, nullptr, kind, copy};
            pair.b = Make(kind, false, Home(pair, false));
            pair.a = Make(kind, true, Home(pair, true));
            pairs.push_back(pair);
        }
    m_world->Step(1.0f / 60.0f, 4, 2);
    AddDrums(kImpactDrum, -8.0f);
    AddDrums(kFirstDrum, -12.0f);
    m_commuter = Body(b2_dynamicBody, m_at + b2Vec2(-16.0f, 0.5f), kCommuter);
    AddFixture(m_commuter, Box(0.2f, 0.2f));
    for (const float x : {-16.0f, -18.0f})
        AddFixture(Body(b2_staticBody, m_at + b2Vec2(x, 0.0f), kCommuter), Box(0.2f, 0.2f));
    m_world->Step(1.0f / 60.0f, 4, 2);
}

b2Body *Crowd::Body(b2BodyType type, b2Vec2 at, Drum drum) {
    b2BodyDef def;
    def.type = type;
    def.position = at;
    def.allowSleep = false;
    def.gravityScale = 0.0f;
    def.userData.pointer = drum;
    return m_world->CreateBody(&def);
}

/// Two balls, each between two walls that it never leaves: also the fat boxes overlap all the time.
void Crowd::AddDrums(Drum drum, float column) {
    for (int i = 0; i < 2; ++i) {
        const b2Vec2 middle = m_at + b2Vec2(column, 3.0f * static_cast<float>(i));
        // Box2D looks for impacts on what is static; walls that are only heavy it meets at a step's start.
        const bool still = drum == kImpactDrum;
        for (const float side : {-1.0f, 1.0f})
            AddFixture(Body(still ? b2_staticBody : b2_dynamicBody, middle + b2Vec2(0.3f * side, 0.0f), drum),
                       Box(0.1f, 0.4f), false, 1.0e6f);
        b2Body *ball = Body(b2_dynamicBody, middle + b2Vec2(0.03f * static_cast<float>(i - 1), 0.0f), drum);
        ball->SetFixedRotation(true);
        AddFixture(ball, Box(0.1f, 0.1f))->SetRestitution(1.0f);
        ball->SetLinearVelocity({i == 1 ? -4.0f : 4.0f, 0.0f});
        m_balls.push_back(ball);
    }
}

b2Vec2 Crowd::Home(const Pair &pair, bool left) const {
    const float away = Away(pair.kind, pair.copy, left);
    return m_at +
           b2Vec2(4.0f * static_cast<float>(pair.kind) + (left ? -away : away),
                  4.0f * static_cast<float>(pair.copy) - (left && pair.kind == kTurner ? 40.0f : 0.0f));
}

b2Body *Crowd::Make(int kind, bool left, b2Vec2 at) {
    b2Body *body = Body(TypeOf(kind, left), at);
    if (left)
        AddLeft(body, kind);
    else
        AddRight(body, kind);
    if (left && kind == kDrifting)
        body->SetLinearVelocity({0.006f, 0.0f});
    return body;
}

void Crowd::Tick(int step) {
    for (b2Body *ball : m_balls)
        ball->GetFixtureList()->Refilter();
    m_commuter->SetTransform(m_at + b2Vec2(step % 2 == 0 ? -16.0f : -18.0f, 0.5f), 0.0f);
    if (step != kStepOfSleep)
        return;
    for (const Pair &pair : pairs)
        if (pair.kind == kAsleep || pair.kind == kAsleepStatic)
            for (b2Body *body : {pair.a, pair.b})
                if (body != nullptr && body->GetType() != b2_staticBody) {
                    body->SetSleepingAllowed(true);
                    body->SetAwake(false);
                }
}

} // namespace surprises
