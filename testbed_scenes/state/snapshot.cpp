// SPDX-License-Identifier: MIT
#include "state/snapshot.h"

#include "state/visit.h"

namespace testbed {
namespace {

template <typename Sink> void VisitBodies(Sink &sink, const b2World &world) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        VisitBody(sink, *body);
}

template <typename Sink> void VisitContacts(Sink &sink, const b2World &world) {
    uint64_t number = 0;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        VisitContact(sink, number++, *contact);
}

/// The kinds of events, in the hash by their number and in the dump by their name.
enum class EventKind : uint32_t { Begin, End, PreSolve, PostSolve, JointGoodbye, FixtureGoodbye };

template <typename Sink>
void BeginContactEvent(Sink &sink, uint64_t number, EventKind kind, const char *name,
                       const b2Contact &contact) {
    sink.Begin("event", number);
    sink.Is(name, static_cast<uint64_t>(kind));
    NameContact(sink, contact);
    sink.Field("flags", ContactMembers::FlagsThatLast(contact));
    VisitManifold(sink, *contact.GetManifold());
}

} // namespace

void EventRecorder::StartStep(bool inWords) {
    m_hash = HashSink();
    m_text.Clear();
    m_inWords = inWords;
    m_count = 0;
}

template <typename Visit> void EventRecorder::Record(Visit visit) {
    visit(m_hash);
    if (m_inWords)
        visit(m_text);
    ++m_count;
}

void EventRecorder::OnBegin(const b2Contact &contact) {
    Record([&](auto &sink) { BeginContactEvent(sink, m_count, EventKind::Begin, "begin", contact); });
}

void EventRecorder::OnEnd(const b2Contact &contact) {
    Record([&](auto &sink) { BeginContactEvent(sink, m_count, EventKind::End, "end", contact); });
}

void EventRecorder::OnPreSolve(const b2Contact &contact, const b2Manifold &old) {
    Record([&](auto &sink) {
        BeginContactEvent(sink, m_count, EventKind::PreSolve, "presolve", contact);
        sink.Of("old");
        VisitManifold(sink, old);
    });
}

void EventRecorder::OnPostSolve(const b2Contact &contact, const b2ContactImpulse &impulse) {
    Record([&](auto &sink) {
        BeginContactEvent(sink, m_count, EventKind::PostSolve, "postsolve", contact);
        static constexpr const char *names[2][2] = {{"impulse0.normal", "impulse0.tangent"},
                                                    {"impulse1.normal", "impulse1.tangent"}};
        sink.Field("impulseCount", impulse.count);
        for (int32 i = 0; i < impulse.count; ++i) {
            sink.Field(names[i][0], impulse.normalImpulses[i]);
            sink.Field(names[i][1], impulse.tangentImpulses[i]);
        }
    });
}

void EventRecorder::OnGoodbye(const b2Joint &joint) {
    Record([&](auto &sink) {
        sink.Begin("event", m_count);
        sink.Is("goodbye", static_cast<uint64_t>(EventKind::JointGoodbye));
        sink.Field("joint", NumberOf(joint));
    });
}

void EventRecorder::OnGoodbye(const b2Fixture &fixture) {
    Record([&](auto &sink) {
        sink.Begin("event", m_count);
        sink.Is("goodbye", static_cast<uint64_t>(EventKind::FixtureGoodbye));
        sink.Key("body", NumberOf(*fixture.GetBody()));
        sink.Field("fixture", NumberOf(fixture));
    });
}

StateHashes HashState(const b2World &world, const EventRecorder &events) {
    HashSink bodies, contacts;
    VisitBodies(bodies, world);
    VisitContacts(contacts, world);
    return {bodies.Value(), contacts.Value(), events.Hash()};
}

std::string DescribeState(const b2World &world, const EventRecorder &events) {
    TextSink sink;
    VisitBodies(sink, world);
    VisitContacts(sink, world);
    return sink.Text() + events.Text();
}

} // namespace testbed
