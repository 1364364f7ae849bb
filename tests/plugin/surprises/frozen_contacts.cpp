// SPDX-License-Identifier: MIT
// A plugin that is wrong: what was apart in nine steps running is not looked at in the next twenty, whatever
// happens to it, neither at a step's start nor for impacts; and nothing of it is filtered again. Preloaded by
// test_surprises.sh, which expects it to be noticed. BMR_FROZEN=heeding lets it look where a body of the two
// moved: the motion is heeded and nothing else.
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>
#include <dlfcn.h>

namespace {

struct Known {
    int apart = 0, left = 0;
    b2Transform a, b;
};
using Key = std::pair<const void *, const void *>;
thread_local std::map<Key, Known> known;        // by the two shapes
thread_local std::map<Key, bool> notForImpacts; // by the two proxies' vertices

const void *CornersOf(const b2Shape *shape) {
    switch (shape->GetType()) {
    case b2Shape::e_polygon:
        return static_cast<const b2PolygonShape *>(shape)->m_vertices;
    case b2Shape::e_circle:
        return &static_cast<const b2CircleShape *>(shape)->m_p;
    case b2Shape::e_edge:
        return &static_cast<const b2EdgeShape *>(shape)->m_vertex1;
    default:
        return nullptr;
    }
}

bool Same(const b2Transform &a, const b2Transform &b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

bool Heeds() {
    static const char *const mode = std::getenv("BMR_FROZEN");
    return mode != nullptr && std::strcmp(mode, "heeding") == 0;
}

} // namespace

extern "C" {

// b2World::b2World: what was known of another world's contacts may be where this one's will be.
__attribute__((visibility("default"))) void _ZN7b2WorldC1ERK6b2Vec2(b2World *, const b2Vec2 &);
void _ZN7b2WorldC1ERK6b2Vec2(b2World *world, const b2Vec2 &gravity) {
    using Construct = void(b2World *, const b2Vec2 &);
    static auto *const real = reinterpret_cast<Construct *>(dlsym(RTLD_NEXT, "_ZN7b2WorldC1ERK6b2Vec2"));
    known.clear();
    notForImpacts.clear();
    real(world, gravity);
}

// b2Fixture::Refilter, for all but the drums and the commuter, whose bodies have user data
__attribute__((visibility("default"))) void _ZN9b2Fixture8RefilterEv(b2Fixture *);
void _ZN9b2Fixture8RefilterEv(b2Fixture *fixture) {
    using Refilter = void(b2Fixture *);
    static auto *const real = reinterpret_cast<Refilter *>(dlsym(RTLD_NEXT, "_ZN9b2Fixture8RefilterEv"));
    if (Heeds() || fixture->GetBody()->GetUserData().pointer != 0)
        real(fixture);
}

// b2Contact::Update
__attribute__((visibility("default"))) void _ZN9b2Contact6UpdateEP17b2ContactListener(b2Contact *,
                                                                                      b2ContactListener *);
void _ZN9b2Contact6UpdateEP17b2ContactListener(b2Contact *contact, b2ContactListener *listener) {
    using Update = void(b2Contact *, b2ContactListener *);
    static auto *const real =
        reinterpret_cast<Update *>(dlsym(RTLD_NEXT, "_ZN9b2Contact6UpdateEP17b2ContactListener"));
    const b2Shape *a = contact->GetFixtureA()->GetShape(), *b = contact->GetFixtureB()->GetShape();
    Known &record = known[{contact, a}];
    const b2Transform xfA = contact->GetFixtureA()->GetBody()->GetTransform(),
                      xfB = contact->GetFixtureB()->GetBody()->GetTransform();
    const Key corners = {CornersOf(a), CornersOf(b)};
    const bool rests = !Heeds() || (Same(record.a, xfA) && Same(record.b, xfB));
    if (record.left > 0 && rests) {
        --record.left;
        notForImpacts[corners] = true;
        return;
    }
    real(contact, listener);
    notForImpacts[corners] = false;
    record.a = xfA;
    record.b = xfB;
    record.apart = contact->IsTouching() ? 0 : record.apart + 1;
    record.left = record.apart >= 9 ? 20 : 0;
}

// b2TimeOfImpact
__attribute__((visibility("default"))) void
_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput(b2TOIOutput *, const b2TOIInput *);
void _Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput(b2TOIOutput *output, const b2TOIInput *input) {
    using Impact = void(b2TOIOutput *, const b2TOIInput *);
    static auto *const real =
        reinterpret_cast<Impact *>(dlsym(RTLD_NEXT, "_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput"));
    const auto found = notForImpacts.find({input->proxyA.m_vertices, input->proxyB.m_vertices});
    if (found == notForImpacts.end() || !found->second || Heeds()) {
        real(output, input);
        return;
    }
    output->state = b2TOIOutput::e_separated;
    output->t = input->tMax;
}
}
