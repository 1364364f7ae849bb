// SPDX-License-Identifier: MIT
#include "events.h"

namespace as_stock {

namespace {

Witness *listening = nullptr; // Options are the process's, and so is who listens

bool IsOfHulls(const bmr_event &event) {
    return event.pair != nullptr;
}

const b2Fixture *OnlySensor(const b2Body *body) {
    const b2Fixture *fixture = body->GetFixtureList();
    return fixture->GetNext() == nullptr && fixture->IsSensor() ? fixture : nullptr;
}

bool IsSensors(const b2Contact &contact) {
    return contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor();
}

} // namespace

void Witness::CheckCertificate(const bmr_event &event) {
    if (!IsOfHulls(event)) {
        m_run.Expect(event.pose == nullptr && event.gap == 0.0, "a contact's event shows no certificate");
        return;
    }
    double gap = 0.0;
    if (event.kind == BMR_EVENT_CONTACT) {
        m_run.Expect(event.pair->state == BMR_PAIR_CONTACT && event.gap == 0.0,
                     "in contact nothing is proved");
        return;
    }
    m_run.Expect(event.gap > 0.0, "something is proved");
    m_run.Expect(bmr_pair_check(event.pair, event.pose, 0.0, &gap), "the certificate holds at the pose");
}

void Witness::OnEvent(const b2Body *a, const b2Body *b, const bmr_event &event) {
    ++m_counts[event.kind];
    m_run.Expect(a->GetWorld() == m_world && b->GetWorld() == m_world, "events are of this world");
    CheckCertificate(event);
    const bool hulls = IsOfHulls(event);
    const b2Vec2 between = b2MulT(a->GetTransform(), b->GetTransform()).p;
    m_run.Expect(event.pose == nullptr || (std::fabs(event.pose->position.x - double{between.x}) < 1e-3 &&
                                           std::fabs(event.pose->position.y - double{between.y}) < 1e-3),
                 "the pose is of the two bodies as they are given");
    if (m_prints)
        m_run.Print("event %s %s %d %d", hulls ? "hulls" : "contact", bmr_event_name(event.kind),
                    event.level_before, event.level_after);
    if (hulls) {
        ++m_ofHulls;
        return;
    }
    // Nobody answers for a sensor; its body has no other fixture here, nor has the one that it meets.
    if (OnlySensor(a) != nullptr || OnlySensor(b) != nullptr) {
        ++m_ofSensors;
        Turn(&m_states[KeyOf(a->GetFixtureList(), b->GetFixtureList())], event);
        return;
    }
    if (m_pending.empty()) {
        m_pendingA = a;
        m_pendingB = b;
    }
    m_pending.push_back(event);
}

/// By the words of boomerang/box2d_glue.h.
void Witness::Turn(State *state, const bmr_event &event) {
    const State before = *state;
    const bool fits = event.kind == BMR_EVENT_START     ? before == State::Unborn
                      : event.kind == BMR_EVENT_PUSH    ? before == State::Apart
                      : event.kind == BMR_EVENT_STAB    ? before == State::Coarse
                      : event.kind == BMR_EVENT_COARSEN ? before == State::Apart
                      : event.kind == BMR_EVENT_CONTACT ? before != State::Contact
                      : event.kind == BMR_EVENT_LEAVE   ? before == State::Contact
                                                        : false;
    m_run.Expect(fits, "an event follows from the one before");
    const int level = before == State::Apart || before == State::Contact ? 0 : BMR_LEVEL_DISKS;
    m_run.Expect(event.level_before == level, "levels follow from one another");
    *state = event.kind == BMR_EVENT_CONTACT ? State::Contact
             : event.level_after == 0        ? State::Apart
                                             : State::Coarse;
    if (event.kind == BMR_EVENT_PUSH || event.kind == BMR_EVENT_STAB)
        m_run.Expect(event.level_after == 0, "a push and a stab end at the polygons");
    if (event.kind == BMR_EVENT_COARSEN)
        m_run.Expect(event.level_after == BMR_LEVEL_DISKS, "what is coarser are the disks");
}

/// The ledger finds lines of its own, where a look found none: such a LEAVE follows the answer.
void Witness::TakeBelated(const b2Contact *next) {
    if (m_pending.empty() || m_pending.front().kind != BMR_EVENT_LEAVE || m_answered == Key())
        return;
    const auto isOf = [this](const Key &key) {
        const b2Body *a = key.first->GetBody(), *b = key.second->GetBody();
        return (a == m_pendingA && b == m_pendingB) || (a == m_pendingB && b == m_pendingA);
    };
    State &state = m_states[m_answered];
    const bool ofNext = next != nullptr && m_pending.size() == 1 && isOf(KeyOf(*next)) &&
                        m_states[KeyOf(*next)] == State::Contact;
    if (state != State::Contact || !isOf(m_answered) || ofNext)
        return;
    Turn(&state, m_pending.front());
    m_pending.erase(m_pending.begin());
}

void Witness::OnAnswer(const b2Contact &contact, bmr::Answer answer) {
    ++m_answers[static_cast<int>(answer)];
    TakeBelated(&contact);
    const bool ofPolygons = contact.GetFixtureA()->GetType() == b2Shape::e_polygon &&
                            contact.GetFixtureB()->GetType() == b2Shape::e_polygon;
    m_run.Expect(m_pending.size() <= (ofPolygons ? 1u : 0u), "an evaluation has one event at most");
    State &state = m_states[KeyOf(contact)];
    const State before = state;
    for (const bmr_event &event : m_pending)
        Turn(&state, event);
    if (ofPolygons && m_run.RemembersEdges()) {
        if (answer == bmr::Answer::ApartBySearch)
            m_run.Expect(m_pending.size() == 1, "what was searched and found is an event");
        m_run.Expect(answer != bmr::Answer::ApartByPair, "no structure of hulls answers unasked");
        if (answer == bmr::Answer::ApartByEdge || answer == bmr::Answer::ApartBySearch)
            m_run.Expect(state == State::Apart || state == State::Coarse,
                         "apart by a certificate of its own");
        if (answer == bmr::Answer::HandedOver)
            m_run.Expect(state == State::Contact, "handed over is in contact");
        if (answer == bmr::Answer::Touching)
            m_run.Expect(before == State::Contact &&
                             (state == State::Contact || contact.GetManifold()->pointCount == 0),
                         "what touched was in contact");
    }
    m_pending.clear();
    m_answered = KeyOf(contact);
}

void Witness::CheckContacts(const b2World &world) {
    TakeBelated(nullptr);
    m_answered = Key();
    m_run.Expect(m_pending.empty(), "each event of a contact has its answer");
    if (!m_run.RemembersEdges())
        return;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        if (contact->GetFixtureA()->GetType() != b2Shape::e_polygon ||
            contact->GetFixtureB()->GetType() != b2Shape::e_polygon)
            continue;
        const auto known = m_states.find(KeyOf(*contact));
        if (contact->IsTouching() && !IsSensors(*contact))
            m_run.Expect(known != m_states.end() && known->second == State::Contact,
                         "what touches is in contact");
    }
}

void Witness::CheckCounts() {
    const bmr::Counted s = bmr::internal::ReadCounts();
    for (int kind = 0; kind < BMR_EVENT_KIND_COUNT; ++kind)
        m_run.Expect(m_counts[kind] == s.events[kind], "every event is counted");
    uint64_t answers = 0;
    for (const uint64_t count : m_answers)
        answers += count;
    const uint64_t touching = m_answers[static_cast<int>(bmr::Answer::Touching)];
    m_run.Expect(answers == s.evaluations, "every evaluation has an answer");
    m_run.Expect(touching == s.handedOverTouching, "what touched is counted");
    m_run.Expect(m_answers[static_cast<int>(bmr::Answer::HandedOver)] + touching == s.handedOver,
                 "and so is all that is handed over");
}

std::string Told(Lived lived, bmr::Options options) {
    static Lived chosen;
    chosen = lived;
    options.onEvent = [](void *, const b2Body *a, const b2Body *b, const bmr_event &event) {
        listening->OnEvent(a, b, event);
    };
    bmr::internal::ObserveAnswers(
        [](const b2Contact &contact, bmr::Answer answer) { listening->OnAnswer(contact, answer); });
    std::string told = InChild(
        [](Run &run) {
            Witness witness(run);
            listening = &witness;
            chosen(run, witness);
            witness.CheckCounts();
        },
        &options);
    bmr::internal::ObserveAnswers(nullptr);
    return told;
}

} // namespace as_stock
