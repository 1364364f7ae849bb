// SPDX-License-Identifier: MIT
#include "plugin.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <boomerang/box2d.h>

#include "debug/inspect.h"

namespace actor {

namespace {

/// A certificate of core that an event shows holds, wherever it happens.
void OnEvent(void *, const b2Body *, const b2Body *, const bmr_event &event) {
    if (event.pair == nullptr)
        return;
    double gap = 0.0;
    const bool holds = event.gap > 0.0 ? event.pair->state == BMR_PAIR_APART &&
                                             bmr_pair_check(event.pair, event.pose, 0.0, &gap)
                                       : event.kind == BMR_EVENT_CONTACT;
    if (!holds) {
        std::fprintf(stderr, "the certificate of a %s does not hold\n", bmr_event_name(event.kind));
        std::abort();
    }
}

} // namespace

bool Install() {
    const char *how = std::getenv("BMR_ACTOR_INSTALL");
    bmr::Options options;
    options.statistics = true;
    if (how != nullptr && std::strcmp(how, "observed") == 0)
        options.onEvent = OnEvent;
    return bmr::Install(options);
}

void InspectAll(b2World &world) {
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        bmr::internal::Inspect(*contact);
}

void CreateAnySize(b2Body *body, const b2FixtureDef &given, const AnySize &size) {
    bmr::ConvexShape shape;
    bmr_error error = BMR_OK;
    switch (size.kind % 4) {
    case 0:
        error = shape.SetRegular(size.vertices, size.width);
        break;
    case 1:
        error = shape.SetEllipse(size.vertices, size.width, size.height);
        break;
    case 2:
        error = shape.SetRounded(size.width, size.height, 0.5f * b2Min(size.width, size.height),
                                 2 + size.vertices / 4);
        break;
    default:
        error = shape.SetRegular(size.vertices, size.width);
        if (error == BMR_OK)
            error = shape.Simplify(0.02f * size.height);
    }
    if (error != BMR_OK)
        return;
    b2FixtureDef def = given;
    def.shape = &shape;
    body->CreateFixture(&def);
}

void CreateOutline(b2Body *body, const b2FixtureDef &def, float width, float depth) {
    const b2Vec2 ring[] = {
        {-width, -width}, {width, -width}, {width, width}, {0.0f, width - depth}, {-width, width}};
    const float in = 0.25f * width;
    const b2Vec2 around[] = {{-in, -3.0f * in}, {in, -3.0f * in}, {in, -2.0f * in}, {-in, -2.0f * in}};
    const bmr::OutlineHole hole = {around, 4};
    bmr::OutlineShape outline;
    if (outline.Set(ring, 5, &hole, 1) == BMR_OK)
        outline.CreateFixtures(body, def);
}

} // namespace actor
