// SPDX-License-Identifier: MIT
#include "changes.h"

#include <cmath>

namespace surprises {

namespace {

using Around = Surroundings;

b2PolygonShape *PolygonOf(b2Fixture *fixture) {
    return fixture->GetType() == b2Shape::e_polygon ? static_cast<b2PolygonShape *>(fixture->GetShape())
                                                    : nullptr;
}

/// Moves and resizes a shape in place, as games do that know what they do: fat boxes stay as they are.
void Edit(b2Body *body, float scale, b2Vec2 by) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        if (b2PolygonShape *polygon = PolygonOf(f)) {
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
        } else {
            auto *chain = static_cast<b2ChainShape *>(f->GetShape());
            for (int32 i = 0; i < chain->m_count; ++i)
                chain->m_vertices[i] = scale * chain->m_vertices[i] + by;
        }
    }
}

void Grow(b2Body *body) {
    Edit(body, 1.4f, {0.0f, 0.0f});
}

/// A polygon made anew in the same object, by Box2D's own functions.
void SetAnew(b2Body *body, int corners) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        b2PolygonShape *polygon = PolygonOf(f);
        if (polygon == nullptr)
            continue;
        const b2Vec2 middle = polygon->m_centroid;
        float reach = 0.12f;
        for (int32 i = 0; i < polygon->m_count; ++i)
            reach = b2Max(reach, 0.12f + std::fabs(polygon->m_vertices[i].x - middle.x));
        if (corners == 0) {
            polygon->SetAsBox(reach, 0.3f, middle, 0.0f);
            continue;
        }
        b2Vec2 points[b2_maxPolygonVertices];
        for (int i = 0; i < corners; ++i)
            points[i] =
                middle +
                reach * b2Rot(2.0f * b2_pi * static_cast<float>(i) / static_cast<float>(corners)).GetXAxis();
        polygon->Set(points, corners);
    }
}

/// No normal points to the side any more, so that no side of the two separates them.
void TurnNormals(b2Body *body) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        if (b2PolygonShape *polygon = PolygonOf(f))
            for (int32 i = 0; i < polygon->m_count; ++i)
                polygon->m_normals[i].Set(0.0f, i % 2 == 0 ? -1.0f : 1.0f);
}

void SetRadius(b2Body *body, float radius) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        f->GetShape()->m_radius = radius;
}

/// A sensor that touches has no points: Box2D asserts some where it turns solid after its update.
void SetSensor(const Around &w, b2Body *body, bool sensor) {
    for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        if (edge->contact->IsTouching() && !sensor && !w.updatesFollow)
            return;
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        f->SetSensor(sensor);
}

void SetMask(b2Body *body, uint16 mask) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        b2Filter filter = f->GetFilterData();
        filter.maskBits = mask;
        f->SetFilterData(filter);
    }
}

void Refilter(b2Body *body) {
    for (b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
        f->Refilter();
}

void DisableContacts(b2Body *body) {
    for (b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next)
        edge->contact->SetEnabled(false);
}

void Spin(b2Body *body, const Pair &pair) {
    body->SetAngularVelocity(pair.kind == kTurner ? -0.15f : 25.0f);
}

/// Out of the way and back, or a bit to the side: to where the two overlap, or not.
void Teleport(b2Body *body, b2Vec2 by, float angle = 0.0f) {
    body->SetTransform(body->GetPosition() + by, body->GetAngle() + angle);
}

const b2Vec2 kRight = {0.15f, 0.0f}, kLeft = {-0.15f, 0.0f};
constexpr b2BodyType kTypes[3] = {b2_staticBody, b2_kinematicBody, b2_dynamicBody};

b2Body *Replace(Around &w, Pair &pair, bool left, b2Vec2 by) {
    b2Body *&body = left ? pair.a : pair.b;
    const b2Vec2 from = body->GetPosition();
    const b2Vec2 at = (from.IsValid() ? from : w.crowd.Home(pair, left)) + by;
    w.watching.refused.erase(body);
    w.world.DestroyBody(body);
    return body = w.crowd.Make(pair.kind, left, at);
}

void WakeBoth(Around &, Pair &p) {
    p.a->SetAwake(true);
    p.b->SetAwake(true);
}

void Join(Around &w, Pair &p) {
    b2DistanceJointDef def;
    def.Initialize(p.a, p.b, p.a->GetPosition(), p.b->GetPosition());
    w.world.CreateJoint(&def);
}

void Part(Around &w, Pair &p) {
    while (p.a->GetJointList() != nullptr)
        w.world.DestroyJoint(p.a->GetJointList()->joint);
    Refilter(p.a);
}

void ReplaceFixtures(Around &, Pair &p, float scale, float by) {
    b2Fixture *old = p.a->GetFixtureList();
    b2PolygonShape *polygon = PolygonOf(old);
    b2PolygonShape like;
    like.SetAsBox(scale * 0.25f, 0.25f, {by, p.kind == kTurner ? 40.0f : 0.0f}, 0.0f);
    if (polygon != nullptr && p.kind == kBullet)
        like.SetAsBox(scale * 0.05f, 0.05f, {by, 0.0f}, 0.0f);
    const bool sensor = old->IsSensor();
    p.a->DestroyFixture(old);
    AddFixture(p.a, like, sensor);
}

// What a callback may do, too.
#define MAY true
#define MAY_NOT false
const std::vector<Change> kChanges = {
    {"nothing", MAY, kNothing, [](Around &, Pair &) {}, nullptr, nullptr},
    {"velocity", MAY, kNothing, [](Around &, Pair &p) { p.a->SetLinearVelocity({6.0f, 0.0f}); }, nullptr, nullptr},
    {"fast", MAY, kNothing, [](Around &, Pair &p) { p.a->SetLinearVelocity({120.0f, 0.0f}); }, nullptr, nullptr},
    {"bullet", MAY, kNothing,
     [](Around &, Pair &p) {
         p.a->SetBullet(true);
         p.a->SetLinearVelocity({120.0f, 0.0f});
     },
     nullptr, nullptr},
    {"impulse", MAY, kNothing,
     [](Around &, Pair &p) { p.a->ApplyLinearImpulseToCenter({6.0f * p.a->GetMass(), 0.0f}, true); }, nullptr, nullptr},
    {"force", MAY, kNothing,
     [](Around &, Pair &p) { p.a->ApplyForceToCenter({400.0f * p.a->GetMass(), 0.0f}, true); }, nullptr, nullptr},
    {"spin", MAY, kNothing, [](Around &, Pair &p) { Spin(p.a, p); }, nullptr, nullptr},
    {"torque", MAY, kNothing,
     [](Around &, Pair &p) { p.a->ApplyAngularImpulse((p.kind == kTurner ? -0.15f : 25.0f) * p.a->GetInertia(), true); },
     nullptr, nullptr},
    {"gravity", MAY, kNothing,
     [](Around &, Pair &p) {
         p.a->SetGravityScale(40.0f);
         p.a->SetAwake(true);
     },
     nullptr, nullptr},
    {"wake", MAY, kOverlap, [](Around &, Pair &p) { p.a->SetAwake(true); }, nullptr, nullptr},
    {"wake-for-good", MAY, kOverlap, [](Around &, Pair &p) { p.a->SetSleepingAllowed(false); }, nullptr, nullptr},
    {"wake-all", MAY, kOverlap, nullptr, [](Around &w) { w.world.SetAllowSleeping(!w.world.GetAllowSleeping()); }, nullptr},
    {"sleep", MAY, kPush, [](Around &, Pair &p) { p.a->SetAwake(false); }, nullptr, WakeBoth},
    {"free-to-turn", MAY, kNothing,
     [](Around &, Pair &p) {
         p.a->SetFixedRotation(true);
         p.a->SetFixedRotation(false);
         Spin(p.a, p);
     },
     nullptr, nullptr},
    {"other-centre", MAY, kNothing,
     [](Around &, Pair &p) {
         for (b2Fixture *f = p.a->GetFixtureList(); f != nullptr; f = f->GetNext())
             f->SetDensity(f == p.a->GetFixtureList() ? 50.0f : 1.0f);
         p.a->ResetMassData();
         p.a->SetAngularVelocity(25.0f);
     },
     nullptr, nullptr},
    {"sensor-on", MAY, kShot, [](Around &w, Pair &p) { SetSensor(w, p.a, true); }, nullptr,
     [](Around &w, Pair &p) { SetSensor(w, p.a, false); }},
    {"sensor-off", MAY, kShot, [](Around &w, Pair &p) { SetSensor(w, p.a, false); }, nullptr, nullptr},
    {"sensor-off-at-rest", MAY, kInside, [](Around &w, Pair &p) { SetSensor(w, p.a, false); }, nullptr,
     [](Around &w, Pair &p) { SetSensor(w, p.b, true); }},
    {"sensor-and-back", MAY, kShot,
     [](Around &w, Pair &p) {
         for (const bool sensor : {true, false, p.kind == kBoxes})
             SetSensor(w, p.b, sensor);
     },
     nullptr, nullptr},
    {"mask-none", MAY, kNothing, [](Around &, Pair &p) { SetMask(p.a, 0); }, nullptr,
     [](Around &, Pair &p) { SetMask(p.a, 0xffff); }},
    {"mask-none-shot", MAY, kShot, [](Around &, Pair &p) { SetMask(p.b, 0); }, nullptr,
     [](Around &, Pair &p) { SetMask(p.b, 0xffff); }},
    {"refilter", MAY, kNothing, [](Around &, Pair &p) { Refilter(p.b); }, nullptr, nullptr},
    {"filter-changes-its-mind", MAY, kNothing,
     [](Around &w, Pair &p) {
         w.watching.refused.insert(p.a);
         Refilter(p.a);
     },
     nullptr,
     [](Around &w, Pair &p) {
         w.watching.refused.erase(p.a);
         Refilter(p.a);
     }},
    {"contact-off", MAY, kNothing, [](Around &, Pair &p) { DisableContacts(p.a); }, nullptr, nullptr},
    {"contact-off-shot", MAY, kShot, [](Around &, Pair &p) { DisableContacts(p.a); }, nullptr, nullptr},
    {"contact-off-unheard", MAY, kNothing, [](Around &, Pair &p) { DisableContacts(p.a); },
     [](Around &w) {
         const bool heard = w.world.GetContactManager().m_contactListener == &w.watching;
         w.world.SetContactListener(heard ? nullptr : &w.watching);
         w.world.SetContactFilter(heard ? nullptr : &w.watching);
     },
     nullptr},
    {"bullet-on", MAY, kShotAsIs, [](Around &, Pair &p) { p.a->SetBullet(true); }, nullptr, nullptr},
    {"bullet-off", MAY, kShot, [](Around &, Pair &p) { p.a->SetBullet(false); }, nullptr, nullptr},
    {"grow", MAY, kNothing, [](Around &, Pair &p) { Grow(p.a); }, nullptr, WakeBoth},
    {"grow-right", MAY, kNothing, [](Around &, Pair &p) { Grow(p.b); }, nullptr, WakeBoth},
    {"grow-back", MAY, kNothing, [](Around &, Pair &p) { Grow(p.b); }, nullptr,
     [](Around &, Pair &p) { Edit(p.b, 0.5f, {0.0f, 0.0f}); }},
    {"shift", MAY, kNothing, [](Around &, Pair &p) { Edit(p.a, 1.0f, kRight); }, nullptr, WakeBoth},
    {"shift-right", MAY, kNothing, [](Around &, Pair &p) { Edit(p.b, 1.0f, kLeft); }, nullptr, WakeBoth},
    {"shift-away-shot", MAY, kShot, [](Around &, Pair &p) { Edit(p.a, 1.0f, {0.0f, 30.0f}); }, nullptr, nullptr},
    {"set", MAY, kNothing, [](Around &, Pair &p) { SetAnew(p.a, p.kind == kWheels ? 8 : 4); }, nullptr, WakeBoth},
    {"set-right", MAY, kNothing, [](Around &, Pair &p) { SetAnew(p.b, 6); }, nullptr, WakeBoth},
    {"set-as-box", MAY, kNothing, [](Around &, Pair &p) { SetAnew(p.a, 0); }, nullptr, WakeBoth},
    {"set-as-box-right", MAY, kNothing, [](Around &, Pair &p) { SetAnew(p.b, 0); }, nullptr, WakeBoth},
    {"normals", MAY, kNothing,
     [](Around &, Pair &p) {
         TurnNormals(p.a);
         TurnNormals(p.b);
     },
     nullptr, WakeBoth},
    {"radius", MAY, kNothing, [](Around &, Pair &p) { SetRadius(p.a, 0.4f); }, nullptr, WakeBoth},
    {"radius-right", MAY, kNothing, [](Around &, Pair &p) { SetRadius(p.b, 0.2f); }, nullptr, WakeBoth},
    {"sub-stepping", MAY, kShot, nullptr, [](Around &w) { w.world.SetSubStepping(!w.world.GetSubStepping()); }, nullptr},
    {"continuous", MAY, kShot, nullptr,
     [](Around &w) { w.world.SetContinuousPhysics(!w.world.GetContinuousPhysics()); }, nullptr},
    {"warm-starting", MAY, kPush, nullptr, [](Around &w) { w.world.SetWarmStarting(!w.world.GetWarmStarting()); }, nullptr},
    {"world-gravity", MAY, kNothing, nullptr,
     [](Around &w) {
         for (Pair &p : w.crowd.pairs)
             if (p.a != nullptr && p.copy == kVictim)
                 p.a->SetGravityScale(1.0f);
         w.world.SetGravity({400.0f, 0.0f});
     },
     nullptr},

    {"no-time", MAY_NOT, kShot, nullptr, [](Around &w) { w.timeStep = w.timeStep > 0.0f ? 0.0f : 1.0f / 60.0f; },
     nullptr},
    {"origin-a-little", MAY_NOT, kNothing, nullptr, [](Around &w) { w.world.ShiftOrigin({0.3f, -0.7f}); }, nullptr},
    {"origin-far", MAY_NOT, kNothing, nullptr, [](Around &w) { w.world.ShiftOrigin({65536.3f, 131072.7f}); }, nullptr},
    {"origin-there-and-back", MAY_NOT, kNothing, nullptr,
     [](Around &w) {
         w.world.ShiftOrigin({-1048576.3f, 0.0f});
         w.world.ShiftOrigin({1048576.3f, 0.0f});
     },
     nullptr},
    {"teleport-near", MAY_NOT, kNothing, [](Around &, Pair &p) { Teleport(p.a, kRight); }, nullptr, WakeBoth},
    {"teleport-near-right", MAY_NOT, kNothing, [](Around &, Pair &p) { Teleport(p.b, kLeft); }, nullptr, WakeBoth},
    {"teleport-far", MAY_NOT, kNothing, [](Around &, Pair &p) { Teleport(p.a, {0.0f, 500.0f}); }, nullptr, WakeBoth},
    {"teleport-far-right", MAY_NOT, kNothing, [](Around &, Pair &p) { Teleport(p.b, {700.0f, 3.0f}); }, nullptr, WakeBoth},
    {"teleport-out-and-near", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         Teleport(p.b, {0.0f, 900.0f});
         Teleport(p.b, {-0.15f, -900.0f});
     },
     nullptr, WakeBoth},
    {"teleport-both", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         Teleport(p.a, {100.0f, 300.0f});
         Teleport(p.b, {100.0f - 0.1f, 300.0f});
     },
     nullptr, WakeBoth},
    {"teleport-turned", MAY_NOT, kNothing,
     [](Around &, Pair &p) { Teleport(p.a, {0.0f, 0.0f}, p.kind == kTurner ? -0.005f : 0.785f); }, nullptr, WakeBoth},
    {"nowhere", MAY_NOT, kNothing,
     [](Around &w, Pair &p) {
         w.world.SetContinuousPhysics(false); // its search for impacts asserts where numbers are none
         p.a->SetTransform({std::nanf(""), 0.0f}, 0.0f);
     },
     nullptr, [](Around &w, Pair &p) { p.a->SetTransform(w.crowd.Home(p, true) + kRight, 0.0f); }},
    {"infinitely-far", MAY_NOT, kNothing,
     [](Around &w, Pair &p) {
         w.world.SetContinuousPhysics(false);
         p.a->SetTransform({p.a->GetPosition().x, INFINITY}, 0.5f);
     },
     nullptr, [](Around &w, Pair &p) { p.a->SetTransform(w.crowd.Home(p, true) + kRight, 0.0f); }},
    {"joint", MAY_NOT, kNothing, Join, nullptr, Part},
    {"joint-shot", MAY_NOT, kShot, Join, nullptr, Part},
    {"fixture-more", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         b2PolygonShape more;
         more.SetAsBox(0.2f, 0.1f, {0.25f, p.kind == kTurner ? 40.0f : 0.0f}, 0.0f);
         AddFixture(p.a, more);
     },
     nullptr, WakeBoth},
    {"fixture-gone", MAY_NOT, kNothing, [](Around &, Pair &p) { p.b->DestroyFixture(p.b->GetFixtureList()); }, nullptr,
     nullptr},
    {"fixture-alike", MAY_NOT, kNothing, [](Around &w, Pair &p) { ReplaceFixtures(w, p, 1.0f, 0.0f); }, nullptr, nullptr},
    {"fixture-nearer", MAY_NOT, kNothing, [](Around &w, Pair &p) { ReplaceFixtures(w, p, 1.0f, 0.15f); }, nullptr, nullptr},
    {"fixture-larger", MAY_NOT, kNothing, [](Around &w, Pair &p) { ReplaceFixtures(w, p, 2.5f, 0.0f); }, nullptr, WakeBoth},
    {"body-gone", MAY_NOT, kNothing,
     [](Around &w, Pair &p) {
         w.watching.refused.erase(p.b);
         w.world.DestroyBody(p.b);
         p.b = nullptr;
     },
     nullptr, nullptr},
    {"body-alike", MAY_NOT, kNothing, [](Around &w, Pair &p) { Replace(w, p, true, {0.0f, 0.0f}); }, nullptr, nullptr},
    {"body-nearer", MAY_NOT, kNothing, [](Around &w, Pair &p) { Replace(w, p, true, kRight); }, nullptr, nullptr},
    {"body-nearer-right", MAY_NOT, kNothing, [](Around &w, Pair &p) { Replace(w, p, false, kLeft); }, nullptr, nullptr},
    {"type", MAY_NOT, kNothing,
     [](Around &, Pair &p) { p.b->SetType(kTypes[(p.b->GetType() + 1 + p.kind % 2) % 3]); }, nullptr,
     [](Around &, Pair &p) { p.a->SetLinearVelocity({6.0f, 0.0f}); }},
    {"type-of-left", MAY_NOT, kShot, [](Around &, Pair &p) { p.a->SetType(kTypes[p.kind % 2]); }, nullptr,
     [](Around &, Pair &p) { p.a->SetType(b2_dynamicBody); }},
    {"type-and-back", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         const b2BodyType was = p.b->GetType();
         p.b->SetType(was == b2_staticBody ? b2_dynamicBody : b2_staticBody);
         p.b->SetType(was);
         Teleport(p.a, kRight);
     },
     nullptr, nullptr},
    {"body-off", MAY_NOT, kNothing, [](Around &, Pair &p) { p.b->SetEnabled(!p.b->IsEnabled()); }, nullptr,
     [](Around &, Pair &p) { p.b->SetEnabled(true); }},
    {"body-off-and-near", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         p.a->SetEnabled(false);
         Teleport(p.a, kRight);
         p.a->SetEnabled(true);
     },
     nullptr, nullptr},
    {"mass-data", MAY_NOT, kNothing,
     [](Around &, Pair &p) {
         const b2MassData about = {1.0f, {0.0f, -30.0f}, 1000.0f};
         p.a->SetMassData(&about);
         p.a->SetAngularVelocity(-0.2f);
     },
     nullptr, nullptr},
};

} // namespace

const std::vector<Change> &AllChanges() {
    return kChanges;
}

void Prepare(Surroundings &around, Pair &pair, Before before) {
    if (before == kOverlap && (pair.kind == kAsleep || pair.kind == kAsleepStatic))
        pair.a->SetTransform(around.crowd.Home(pair, true) + kRight, 0.0f);
    if (before == kPush)
        pair.a->SetLinearVelocity({6.0f, 0.0f});
    if (before == kShot)
        pair.a->SetBullet(true);
    if (before == kShot || before == kShotAsIs)
        pair.a->SetLinearVelocity({120.0f, 0.0f});
}

} // namespace surprises
