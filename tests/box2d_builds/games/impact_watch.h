// SPDX-License-Identifier: MIT
#ifndef BOX2D_BUILDS_IMPACT_WATCH_H
#define BOX2D_BUILDS_IMPACT_WATCH_H

#include <vector>

#include "stage.h"

namespace box2d_builds {

/// Tells a listener whether a step has come to its impacts (b2World::SolveTOI). Box2D calls PreSolve twice in
/// a step at most: where contacts are brought up to date, before any body has moved, and in impacts, after
/// all have.
class ImpactWatch {
public:
    void StepBegins(const b2World &world) {
        m_inImpacts = false;
        m_places.clear();
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            m_places.push_back({body, body->GetWorldCenter(), body->GetAngle()});
    }
    /// To be called from BeginContact and PreSolve.
    void Told(const b2Contact &contact) {
        m_inImpacts = m_inImpacts || HasMoved(contact.GetFixtureA()->GetBody()) ||
                      HasMoved(contact.GetFixtureB()->GetBody());
    }
    bool InImpacts() const { return m_inImpacts; }

private:
    struct Place {
        const b2Body *body;
        b2Vec2 center;
        float angle;
    };
    bool HasMoved(const b2Body *body) const {
        for (const Place &place : m_places)
            if (place.body == body)
                return place.center != body->GetWorldCenter() || place.angle != body->GetAngle();
        return false;
    }

    std::vector<Place> m_places;
    bool m_inImpacts = false;
};

} // namespace box2d_builds

#endif
