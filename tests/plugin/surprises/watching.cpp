// SPDX-License-Identifier: MIT
#include "watching.h"

namespace surprises {

const char *const kPlaceNames[kPlaces] = {"between",      "begin-first", "begin-last", "begin-impact",
                                          "end-first",    "end-last",    "end-impact", "pre-first",
                                          "pre-last",     "pre-impact",  "post-first", "post-impact",
                                          "filter-first", "filter-last", "filter-new", "unlocked"};

namespace {

uint32_t NumberOf(const b2Fixture *fixture) {
    return static_cast<uint32_t>(const_cast<b2Fixture *>(fixture)->GetUserData().pointer);
}

} // namespace

Watching::Watching(b2World *world) : m_world(world) {
    world->SetContactListener(this);
    world->SetContactFilter(this);
}

void Watching::Look(bool edges) {
    for (b2Contact *c = m_world->GetContactList(); c != nullptr; c = c->GetNext())
        hash.Add(NumberOf(c->GetFixtureA()) << 17 | NumberOf(c->GetFixtureB()) << 2 |
                 static_cast<uint32_t>(c->IsTouching()) << 1 | static_cast<uint32_t>(c->IsEnabled()));
    for (b2Body *body = m_world->GetBodyList(); edges && body != nullptr; body = body->GetNext()) {
        hash.Add(static_cast<uint32_t>(body->IsAwake()));
        const b2ContactEdge *last = nullptr;
        for (const b2ContactEdge *edge = body->GetContactList(); edge != nullptr; edge = edge->next) {
            hash.Add(NumberOf(edge->contact->GetFixtureA()) << 17 |
                     NumberOf(edge->contact->GetFixtureB()) << 2 | static_cast<uint32_t>(edge->prev == last));
            last = edge;
        }
    }
}

bool Watching::Act(Place place) {
    places.insert(place);
    bool acted = false;
    for (size_t i = 0; i < m_waiting.size();) {
        if (m_waiting[i].place != place) {
            ++i;
            continue;
        }
        const std::function<void()> act = std::move(m_waiting[i].act);
        m_waiting.erase(m_waiting.begin() + static_cast<std::ptrdiff_t>(i));
        act();
        acted = true;
    }
    return acted;
}

/// `byDrum`: the places that this callback is, for the drums in their order.
void Watching::Note(char what, b2Fixture *a, b2Fixture *b, std::initializer_list<Place> byDrum) {
    hash.Add(static_cast<uint32_t>(what));
    hash.Add(NumberOf(a) << 16 | NumberOf(b));
    if (tells)
        std::printf("    %c %u %u\n", what, NumberOf(a), NumberOf(b));
    // Box2D walks the bodies' lists while it solves: then they are looked at most often.
    if (looks)
        Look(what == 'S' || what == 'E');
    if (m_inside)
        return;
    m_inside = true;
    const uintptr_t drum = b2Max(a->GetBody()->GetUserData().pointer, b->GetBody()->GetUserData().pointer);
    bool acted = false;
    if (drum != kNoDrum && drum <= byDrum.size() && byDrum.begin()[drum - 1] != kBetween)
        acted = Act(byDrum.begin()[drum - 1]);
    if (what == 'B' && drum == kFirstDrum) {
        for (const Waiting &waiting : m_waiting)
            if (waiting.place == kUnlocked) {
                m_world->Step(0.0f, 1, 1);
                break;
            }
        acted = Act(kUnlocked) || acted;
    }
    m_inside = false;
    if (acted && looks)
        Look(true);
}

void Watching::BeginContact(b2Contact *contact) {
    Note('B', contact->GetFixtureA(), contact->GetFixtureB(), {kBeginFirst, kBeginLast, kBeginImpact});
}

void Watching::EndContact(b2Contact *contact) {
    Note('E', contact->GetFixtureA(), contact->GetFixtureB(), {kEndFirst, kEndLast, kEndImpact});
}

void Watching::PreSolve(b2Contact *contact, const b2Manifold *) {
    Note('P', contact->GetFixtureA(), contact->GetFixtureB(), {kPreFirst, kPreLast, kPreImpact});
}

void Watching::PostSolve(b2Contact *contact, const b2ContactImpulse *impulse) {
    for (int32 i = 0; i < impulse->count; ++i)
        hash.Add(impulse->normalImpulses[i]);
    Note('S', contact->GetFixtureA(), contact->GetFixtureB(), {kPostFirst, kBetween, kPostImpact});
}

bool Watching::ShouldCollide(b2Fixture *a, b2Fixture *b) {
    Note('F', a, b, {kFilterFirst, kFilterLast, kBetween, kFilterNew});
    return refused.count(a->GetBody()) == 0 && refused.count(b->GetBody()) == 0 &&
           b2ContactFilter::ShouldCollide(a, b);
}

} // namespace surprises
