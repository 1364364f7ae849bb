// SPDX-License-Identifier: MIT
#include "tell/modesty.h"

#include <algorithm>
#include <functional>

#include <box2d/b2_body.h>
#include <box2d/b2_chain_shape.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "start/settings.h"
#include "tell/verify.h"

namespace bmr {

namespace {

class Digest {
public:
    void Add(const void *from, size_t bytes) {
        for (const auto *byte = static_cast<const unsigned char *>(from); bytes-- > 0; ++byte)
            m_value = (m_value ^ *byte) * 0x100000001b3u;
    }
    template <typename T> void Add(const T &value) { Add(&value, sizeof value); }
    uint64_t Value() const { return m_value; }

private:
    uint64_t m_value = 0xcbf29ce484222325u;
};

uint64_t DigestOf(const b2Shape &shape) {
    Digest digest;
    digest.Add(shape.m_radius);
    if (shape.GetType() == b2Shape::e_polygon) {
        const auto &polygon = static_cast<const b2PolygonShape &>(shape);
        digest.Add(polygon.m_vertices);
        digest.Add(polygon.m_normals);
        digest.Add(polygon.m_count);
    } else if (shape.GetType() == b2Shape::e_circle) {
        digest.Add(static_cast<const b2CircleShape &>(shape).m_p);
    } else if (shape.GetType() == b2Shape::e_edge) {
        const auto &edge = static_cast<const b2EdgeShape &>(shape);
        for (const b2Vec2 &v : {edge.m_vertex0, edge.m_vertex1, edge.m_vertex2, edge.m_vertex3})
            digest.Add(v);
        digest.Add(edge.m_oneSided);
    } else if (shape.GetType() == b2Shape::e_chain) {
        const auto &chain = static_cast<const b2ChainShape &>(shape);
        digest.Add(chain.m_vertices, sizeof(b2Vec2) * static_cast<size_t>(chain.m_count));
    }
    return digest.Value();
}

// What else of a fixture and its body, in the lowest bits beside the digest of its shape.
constexpr uint64_t kSensor = 1, kBullet = 2, kAwake = 4, kAllFlags = 7;

uint64_t StateOf(const b2Fixture &fixture) {
    const b2Body &body = *fixture.GetBody();
    return (DigestOf(*fixture.GetShape()) & ~kAllFlags) | (fixture.IsSensor() ? kSensor : 0) |
           (body.IsBullet() ? kBullet : 0) | (body.IsAwake() ? kAwake : 0);
}

/// Until `what` says no.
template <typename What> void ForAllFixtures(const b2World &world, What what) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            if (!what(*f))
                return;
}

} // namespace

ModestyCheck::ModestyCheck(const b2World *world, bool inCollide)
    : m_world(Verifying() && GetSettings().options.modestListeners ? world : nullptr),
      m_inCollide(inCollide) {
    if (m_world != nullptr)
        Remember();
}

ModestyCheck::~ModestyCheck() {
    if (m_world == nullptr)
        return;
    CountVerified();
    CompareFixtures();
    if (m_inCollide)
        CompareContacts();
}

void ModestyCheck::Remember() {
    ForAllFixtures(*m_world, [this](const b2Fixture &fixture) {
        m_fixtures.push_back(StateOf(fixture));
        return true;
    });
    for (const b2Contact *c = m_world->GetContactList(); c != nullptr; c = c->GetNext())
        if (c->IsTouching() || !c->IsEnabled())
            m_excused.push_back(c);
    std::sort(m_excused.begin(), m_excused.end(), std::less<>());
}

void ModestyCheck::CompareFixtures() const {
    size_t i = 0, count = 0;
    ForAllFixtures(*m_world, [&count](const b2Fixture &) { return ++count > 0; });
    if (count != m_fixtures.size())
        return;
    ForAllFixtures(*m_world, [this, &i](const b2Fixture &fixture) {
        const uint64_t before = m_fixtures[i++], now = StateOf(fixture), changed = before ^ now;
        const char *what = (changed & ~kAllFlags) != 0                       ? "a shape"
                           : (changed & kSensor) != 0                        ? "who is a sensor"
                           : (changed & kBullet) != 0                        ? "who is a bullet"
                           : m_inCollide && (changed & kAwake & before) != 0 ? "who is awake"
                                                                             : nullptr;
        if (what != nullptr)
            ReportDifference("modest listeners", &fixture, nullptr, "a listener or a filter changed %s",
                             what);
        return what == nullptr;
    });
}

/// A contact that is disabled, and that no call was about.
void ModestyCheck::CompareContacts() const {
    for (const b2Contact *c = m_world->GetContactList(); c != nullptr; c = c->GetNext()) {
        const b2Body *const a = c->GetFixtureA()->GetBody(), *const b = c->GetFixtureB()->GetBody();
        const bool active = (a->IsAwake() && a->GetType() != b2_staticBody) ||
                            (b->IsAwake() && b->GetType() != b2_staticBody);
        if (c->IsEnabled() || c->IsTouching() || !active ||
            std::binary_search(m_excused.begin(), m_excused.end(), c, std::less<>()))
            continue;
        ReportDifference("modest listeners", c->GetFixtureA(), c->GetFixtureB(),
                         "a listener or a filter disabled another contact than its own");
        return;
    }
}

} // namespace bmr
