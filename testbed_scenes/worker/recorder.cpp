// SPDX-License-Identifier: MIT
#include "worker/recorder.h"

#include <algorithm>
#include <tuple>

#include <box2d/b2_distance.h>
#include <dlfcn.h>

#include "recording/bytes.h"
#include "worker/record_world.h"

namespace testbed {
namespace {

using Watch = decltype(&boomerang_count_watch);

/// Nothing where the counting library is not preloaded.
Watch FindWatch() {
    return reinterpret_cast<Watch>(dlsym(RTLD_DEFAULT, "boomerang_count_watch"));
}

int Number(const b2Body &body) {
    return static_cast<int>(NumberOf(body));
}

std::pair<int, int> Sorted(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

std::pair<int, int> BodiesOf(const b2Contact &contact) {
    return Sorted(Number(*contact.GetFixtureA()->GetBody()), Number(*contact.GetFixtureB()->GetBody()));
}

bool IsSolid(const b2Contact &contact) {
    return !contact.GetFixtureA()->IsSensor() && !contact.GetFixtureB()->IsSensor();
}

bool IsOfPolygons(const b2Contact &contact) {
    return contact.GetFixtureA()->GetType() == b2Shape::e_polygon &&
           contact.GetFixtureB()->GetType() == b2Shape::e_polygon;
}

/// Whether the plugin is there, and at work.
bool ShowsProofs() {
    static const bool shows = PluginName() == std::string("plugin");
    return shows;
}

void AddCall(boomerang_counted what, recording::Calls *calls) {
    switch (what) {
    case BOOMERANG_COUNTED_POLYGON_TEST:
        ++calls->polygon_tests;
        break;
    case BOOMERANG_COUNTED_TOI:
        ++calls->toi;
        break;
    case BOOMERANG_COUNTED_DISTANCE:
        ++calls->distance;
        break;
    case BOOMERANG_COUNTED_OVERLAP:
        ++calls->overlap;
        break;
    }
}

bool IsSame(const recording::Fixture &a, const recording::Fixture &b) {
    return a.shape == b.shape && a.points == b.points && a.radius == b.radius && a.sensor == b.sensor;
}

/// A proof between the same two bodies, called the other way round.
void Swap(recording::Proof *proof) {
    proof->owner = proof->kind == "disks" ? proof->owner : 1 - proof->owner;
    for (auto *two : {&proof->fixtures, &proof->hulls, &proof->envelopes})
        std::swap((*two)[0], (*two)[1]);
    std::swap(proof->supports[0], proof->supports[1]);
    std::swap(proof->centres[0], proof->centres[1]);
    std::swap(proof->radii[0], proof->radii[1]);
}

} // namespace

std::size_t Recorder::BodiesHash::operator()(const Bodies &bodies) const {
    const auto a = static_cast<std::uint64_t>(bodies.first), b = static_cast<std::uint64_t>(bodies.second);
    return static_cast<std::size_t>((a << 32 ^ b) * 0x9e3779b97f4a7c15U >> 16);
}

Recorder::~Recorder() {
    WatchCalls(false);
}

bool Recorder::CountsCalls() const {
    return FindWatch() != nullptr;
}

void Recorder::WatchCalls(bool on) {
    if (const Watch watch = FindWatch())
        watch(on ? OnCall : nullptr, this);
}

void Recorder::BeginStep(const b2World &world, int step) {
    m_step = step;
    if (step <= m_range.first) { // a frame tells of what came after the one before, and the first of its step
        m_recent.clear();
        m_events.clear();
        m_calls = {};
    }
    if (step < m_range.first || !CountsCalls())
        return;
    m_bodyOf.clear();
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        for (const b2Fixture *f = body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
            if (f->GetType() == b2Shape::e_chain)
                continue; // its proxies point into themselves
            b2DistanceProxy proxy;
            proxy.Set(f->GetShape(), 0);
            m_bodyOf[proxy.m_vertices] = Number(*body);
        }
    }
    WatchCalls(true);
}

void Recorder::OnCall(void *context, boomerang_counted what, const void *a, const void *b) {
    auto &recorder = *static_cast<Recorder *>(context);
    AddCall(what, &recorder.m_calls);
    const auto foundA = recorder.m_bodyOf.find(a), foundB = recorder.m_bodyOf.find(b);
    if (foundA != recorder.m_bodyOf.end() && foundB != recorder.m_bodyOf.end())
        AddCall(what, &recorder.m_recent[Sorted(foundA->second, foundB->second)].calls);
}

void Recorder::AddEvent(recording::Event event, const Bodies &bodies) {
    event.step = m_step;
    std::tie(event.a, event.b) = bodies;
    m_events.push_back(std::move(event));
}

void Recorder::OnKineticEvent(const b2Body &bodyA, const b2Body &bodyB, recording::Event event) {
    AddEvent(std::move(event), Sorted(Number(bodyA), Number(bodyB)));
}

void Recorder::OnAnswer(const b2Contact &contact, bool handedOver) {
    const Bodies bodies = BodiesOf(contact);
    Counters &recent = m_recent[bodies];
    ++recent.asked;
    recent.handedOver += handedOver ? 1 : 0;
}

void Recorder::OnBegin(const b2Contact &contact) {
    recording::Event event;
    event.kind = "begin";
    AddEvent(event, BodiesOf(contact));
}

void Recorder::OnEnd(const b2Contact &contact) {
    recording::Event event;
    event.kind = "end";
    AddEvent(event, BodiesOf(contact));
}

recording::Frame Recorder::Take(const b2World &world) {
    WatchCalls(false); // what is measured here is no call of the run's
    recording::Frame frame;
    frame.step = m_step;
    frame.bodies = RecordBodies(world);
    if (!m_range.compact || ShowsProofs()) {
        RecordChanges(world, &frame);
        if (m_range.boxes)
            frame.boxes = RecordBoxes(world);
        frame.joints = RecordJoints(world);
        frame.touching = RecordTouching(world);
    }
    RecordPairs(world, &frame);
    frame.events = std::move(m_events);
    frame.calls = m_calls;
    m_recent.clear();
    m_events.clear();
    m_calls = {};
    return frame;
}

/// The fixtures that are new, other or gone since the last frame.
void Recorder::RecordChanges(const b2World &world, recording::Frame *frame) {
    std::map<std::pair<int, int>, recording::Fixture> now;
    for (recording::Fixture &fixture : RecordFixtures(world)) {
        const std::pair<int, int> key = {fixture.body, fixture.number};
        const auto sent = m_sent.find(key);
        if (sent == m_sent.end() || !IsSame(sent->second, fixture))
            frame->fixtures.push_back(fixture);
        now.emplace(key, std::move(fixture));
    }
    for (const auto &[key, fixture] : m_sent) {
        if (now.count(key) == 0)
            frame->gone.push_back({key.first, key.second});
    }
    m_sent = std::move(now);
}

void Recorder::RecordPairs(const b2World &world, recording::Frame *frame) {
    std::vector<Draft> drafts;
    ByBodies<std::size_t> places;
    const auto draftOf = [&](const Bodies &bodies) -> Draft & {
        const auto [place, isNew] = places.try_emplace(bodies, drafts.size());
        if (isNew) {
            drafts.emplace_back();
            std::tie(drafts.back().pair.a, drafts.back().pair.b) = bodies;
        }
        return drafts[place->second];
    };
    const bool contacts = !m_range.compact || ShowsProofs();
    for (const b2Contact *contact = contacts ? world.GetContactList() : nullptr; contact != nullptr;
         contact = contact->GetNext()) {
        if (IsSolid(*contact))
            AddContact(*contact, frame, &draftOf(BodiesOf(*contact)));
    }
    for (const auto &[bodies, recent] : m_recent) {
        recording::Pair &pair = draftOf(bodies).pair;
        pair.asked = recent.asked;
        pair.handed_over = recent.handedOver;
        pair.calls = recent.calls;
    }
    std::vector<std::pair<Bodies, std::size_t>> order(places.begin(), places.end());
    std::sort(order.begin(), order.end());
    frame->pairs.reserve(order.size());
    for (const auto &[bodies, place] : order) {
        recording::Pair &pair = drafts[place].pair;
        if (m_range.compact)
            LeaveOutKept(&pair);
        frame->pairs.push_back(std::move(pair));
    }
}

/// Most pairs have the proofs of the frame before.
void Recorder::LeaveOutKept(recording::Pair *pair) {
    for (recording::Proof &proof : pair->proofs)
        proof.slack = 0.0f; // the pair's own is what a replay shows
    const auto [known, isNew] = m_shown.try_emplace({pair->a, pair->b});
    Shown &shown = known->second;
    pair->proofs_kept =
        !isNew && shown.step == m_step - m_range.every && pair->proofs.size() == shown.proofs.size() &&
        std::equal(pair->proofs.begin(), pair->proofs.end(), shown.proofs.begin(), recording::IsSame);
    shown.step = m_step;
    if (pair->proofs_kept)
        pair->proofs.clear();
    else
        shown.proofs = pair->proofs;
}

void Recorder::AddContact(const b2Contact &contact, recording::Frame *frame, Draft *draft) {
    recording::Pair &pair = draft->pair;
    ++pair.contacts;
    pair.touching += contact.IsTouching() ? 1 : 0;
    if (!IsOfPolygons(contact))
        return;
    const b2Fixture *a = contact.GetFixtureA(), *b = contact.GetFixtureB();
    const bool swapped = Number(*a->GetBody()) > Number(*b->GetBody());
    if (swapped)
        std::swap(a, b);
    const bool isFirst = pair.polygon_contacts++ == 0;
    if (!m_range.compact) {
        const Closest closest = MeasureClosest(*a, *b);
        if (isFirst || closest.distance < pair.distance) {
            pair.distance = closest.distance;
            pair.closest = {ToVec(closest.onA), ToVec(closest.onB)};
        }
    }
    if (ShowsProofs())
        AddProof(contact, swapped, frame, draft);
}

void Recorder::AddProof(const b2Contact &contact, bool swapped, recording::Frame *frame, Draft *draft) {
    recording::Pair &pair = draft->pair;
    ShownProof shown = ShowProof(contact);
    recording::Proof &proof = shown.proof;
    pair.slack = pair.proofs.empty() ? proof.slack : std::min(pair.slack, proof.slack);
    // All that is unproved goes together, and so does what one structure proves.
    const bool alone = shown.structure == nullptr && proof.kind != "none";
    if (!alone) {
        for (const auto &[structure, place] : draft->shared) {
            if (structure == shown.structure) {
                ++pair.proofs[place].contacts;
                return;
            }
        }
        draft->shared.emplace_back(shown.structure, pair.proofs.size());
    }
    if (swapped)
        Swap(&proof);
    if (shown.structure != nullptr)
        NameHulls(contact, swapped, frame, &proof);
    pair.proofs.push_back(std::move(proof));
}

void Recorder::NameHulls(const b2Contact &contact, bool swapped, recording::Frame *frame,
                         recording::Proof *proof) {
    const auto [first, second] = BodiesOf(contact);
    for (const bool envelope : {false, true}) {
        std::array<std::vector<recording::Vec>, 2> hulls = ShowHulls(contact, envelope);
        if (swapped)
            std::swap(hulls[0], hulls[1]);
        (envelope ? proof->envelopes : proof->hulls) = {NameOutline(first, hulls[0], frame),
                                                        NameOutline(second, hulls[1], frame)};
    }
}

int Recorder::NameOutline(int body, const std::vector<recording::Vec> &points, recording::Frame *frame) {
    if (points.empty())
        return 0;
    std::vector<float> key;
    for (const recording::Vec &point : points)
        key.insert(key.end(), {point.x, point.y});
    const auto [place, isNew] =
        m_outlines.emplace(std::pair(body, std::move(key)), static_cast<int>(m_outlines.size()) + 1);
    if (isNew)
        frame->outlines.push_back({place->second, body, points});
    return place->second;
}

recording::Head MakeHead(const Recorder &recorder, const PluginOptions &plugin) {
    recording::Head head;
    head.program = PluginName();
    if (head.program == "plugin")
        head.structure = plugin.structure;
    head.first = recorder.Range().first;
    head.last = recorder.Range().last;
    head.every = recorder.Range().every;
    head.counts_calls = recorder.CountsCalls();
    return head;
}

} // namespace testbed
