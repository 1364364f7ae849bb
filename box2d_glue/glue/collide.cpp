// SPDX-License-Identifier: MIT
#include "glue/passes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include <box2d/b2_contact_manager.h>
#include <box2d/b2_polygon_shape.h>

#include "base/compiler.h"
#include "base/rounding_mode.h"
#include "debug/statistics.h"
#include "glue/contacts/solid_contact.h"
#include "glue/pairs/pair_tables.h"
#include "glue/proofs/thresholds.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "start/settings.h"

namespace bmr {

// What a contact that was updated proves for its pair.

static_assert(static_cast<double>(kBandReach) <= kReach && kImpactReach <= kSweepReach &&
                  kImpactAngle <= kSweepAngle,
              "the margins hold wherever a pair of band 0 has a budget");

namespace {

/// A polygon in the world, in double.
struct Placed {
    const b2PolygonShape *shape;
    const bmr_convex32_block *big; ///< nullptr: a small one
    bmr_pose pose;
    double reach;

    explicit Placed(const FixtureMotion &motion) : Placed(*motion.fixture, motion.mover.reach) {}
    Placed(const b2Fixture &fixture, double reachOfVertices)
        : shape(static_cast<const b2PolygonShape *>(fixture.GetShape())),
          big(AnyBigPolygon() ? BigPolygonOf(*shape) : nullptr),
          pose(PoseOf(fixture.GetBody()->GetTransform())), reach(reachOfVertices) {}

    /// The largest <d, v> of a point, in the world, and the point. Of a big polygon the vertex may be the
    /// wrong one of two that are as far along to rounding, which `slack` covers.
    bmr_vec2 Farthest(bmr_vec2 d, double *slack) const {
        const bmr_vec2 local = bmr_unrotate(&pose, d);
        if (big != nullptr) {
            const uint32_t at = bmr_convex32_support(
                &big->polygon, {static_cast<float>(local.x), static_cast<float>(local.y)});
            *slack += reach * 0x1p-20;
            return bmr_transform(&pose, Double(big->polygon.vertices[at]));
        }
        const bmr_vec32 *const vertices = Vectors32(shape->m_vertices);
        int32 best = 0;
        double most = bmr_dot(local, Double(vertices[0]));
        for (int32 i = 1; i < shape->m_count; ++i) {
            const double along = bmr_dot(local, Double(vertices[i]));
            if (along > most) {
                most = along;
                best = i;
            }
        }
        return bmr_transform(&pose, Double(vertices[best]));
    }
};

/// How far apart two are along a direction: <d, b - a> >= gap for all their points.
struct Gap {
    bmr_vec2 d;
    double gap;
    bmr_vec2 between; ///< from a's point that is farthest along d to b's that is least far
};

Gap GapAlong(const Placed &a, const Placed &b, bmr_vec2 d) {
    // Coordinates are those of the last band at most, so the rounding of doubles is far below this.
    constexpr double kRounding = 1e-9 * static_cast<double>(b2_lengthUnitsPerMeter);
    double slack = kRounding;
    const bmr_vec2 from = a.Farthest(d, &slack), to = b.Farthest(bmr_neg(d), &slack);
    const bmr_vec2 between = bmr_sub(to, from);
    return {d, bmr_dot(d, between) - slack, between};
}

/// Of unit length; false of nothing and of what is no number.
bool Normalize(bmr_vec2 *d) {
    const double length = std::sqrt(bmr_dot(*d, *d));
    if (!(length > 1e-12 && length < 1e12))
        return false;
    *d = bmr_scale(1.0 / length, *d);
    return true;
}

/// How far a vertex may be from its body's origin.
double ReachOf(const FixtureMotion &motion) {
    return motion.mover.reach + std::fabs(motion.mover.pivot.x) + std::fabs(motion.mover.pivot.y);
}

/// By how much b2TimeOfImpact's arithmetic may be off, for one of the two and for coordinates up to
/// `farthest` (glue/proofs/sweep_apart.cpp has the same for the coordinates of a step).
double ImpactRounding(const FixtureMotion &motion, double farthest) {
    return static_cast<double>(kUnit) *
           (static_cast<double>(kErrorPerCoordinate) * farthest +
            static_cast<double>(kErrorPerReach) * ReachOf(motion) +
            static_cast<double>(kErrorPerAngle * kImpactAngle) * motion.mover.reach);
}
double ImpactTilt(const FixtureMotion &motion, double farthest) {
    return static_cast<double>(kUnit) * (static_cast<double>(kTiltPerCoordinate) * farthest +
                                         static_cast<double>(kTiltPerReach) * ReachOf(motion));
}

/// Does a distance of `threshold` keep b2TimeOfImpact from finding the two touching, as far out as
/// kImpactReach of `band`?
bool KeepsFromImpact(const FixtureMotion &a, const FixtureMotion &b, int band, double threshold) {
    const double farthest = std::ldexp(static_cast<double>(kImpactReach), band);
    if (!(a.shortest >= kShortestSide && b.shortest >= kShortestSide))
        return false; // and of big polygons, whose sides are not measured
    const double lever = 1.0 + 2.0 * std::max(a.mover.reach / static_cast<double>(b.shortest),
                                              b.mover.reach / static_cast<double>(a.shortest));
    const auto impact = static_cast<double>(ImpactDistance(a.radius + b.radius));
    const double tilt = ImpactTilt(a, farthest) + ImpactTilt(b, farthest) + static_cast<double>(kTiltAlways) +
                        static_cast<double>(kUnit * kTiltPerDistance) * impact;
    return impact * (1.0 + static_cast<double>(kUnit * kErrorPerDistance)) + ImpactRounding(a, farthest) +
               ImpactRounding(b, farthest) + tilt * lever <
           threshold;
}

/// How far apart two polygons must be for b2CollidePolygons to give no points, b2TestOverlap to say no, and
/// (where their sides are long enough) b2TimeOfImpact to find them apart.
double ApartThreshold(const PairTable &table, uint32_t pair) {
    const Pair &at = table.At(pair);
    const FixtureMotions &motions = table.motions;
    return ContactMargin(static_cast<double>(motions[at.a].radius + motions[at.b].radius),
                         motions.RoundingMargin(at.a, at.b));
}

/// How far a fixture's body most likely carries its points in a step of this length.
double ExpectedMotion(const FixtureMotion &motion, float seconds) {
    constexpr double kUnknownReach = 0.5 * static_cast<double>(b2_lengthUnitsPerMeter);
    const b2Vec2 &v = motion.body->GetLinearVelocity();
    const double reach = motion.mover.reach > 0.0 ? motion.mover.reach : kUnknownReach;
    return static_cast<double>(seconds) *
           (static_cast<double>(b2Abs(v.x) + b2Abs(v.y)) +
            static_cast<double>(b2Abs(motion.body->GetAngularVelocity())) * reach);
}

/// Begins a proof; false, and the pair is due, where none is worth it. `soon`: how much is to be left
/// beyond it.
bool BeginProof(PairTable *table, uint32_t pair, double *soon) {
    constexpr double kFatBoxes = 6.0 * static_cast<double>(b2_aabbExtension);
    *soon = 2.0 * (ExpectedMotion(table->motions[table->At(pair).a], table->seconds) +
                   ExpectedMotion(table->motions[table->At(pair).b], table->seconds));
    if (*soon <= kFatBoxes && table->BeginProof(pair))
        return true;
    table->SetDue(pair);
    return false;
}

/// A contact was updated, and its two polygons do not touch: gives its pair the budget that their distance
/// allows, along the direction that is known already (the remembered edge's, that of a big polygon's memory,
/// that of the bodies' structure), or along one that is found from there in a step. Leaves the pair due where
/// that is no more than the margins.
///
/// What is proved is a distance of the vertices as they are, computed in double, so that it does not matter
/// where the direction came from.
void ProveApart(PairTable *table, uint32_t pair, SolidContact *contact) {
    double soon;
    if (!BeginProof(table, pair, &soon))
        return;
    const FixtureMotion &motionA = table->motions[table->At(pair).a],
                        &motionB = table->motions[table->At(pair).b];
    const Placed a(motionA), b(motionB);
    const double threshold = ApartThreshold(*table, pair);
    bmr_vec2 d = contact->GuessDirection();
    if (!Normalize(&d)) {
        d = bmr_sub(motionB.mover.center, motionA.mover.center);
        if (!Normalize(&d)) {
            table->SetDue(pair);
            return;
        }
    }
    Gap best = GapAlong(a, b, d);
    bmr_vec2 closer = best.between;
    // Where two corners face each other, or the guess is old, the line between what was found says more.
    const double length = std::sqrt(bmr_dot(closer, closer));
    if (length > threshold + soon && best.gap < 0.95 * length && Normalize(&closer)) {
        const Gap other = GapAlong(a, b, closer);
        if (other.gap > best.gap)
            best = other;
    }
    if (!(best.gap > threshold + soon)) {
        table->SetDue(pair);
        return;
    }
    const int band = table->motions.Band(table->At(pair).a, table->At(pair).b);
    table->Prove(pair, best.d, best.gap, threshold, KeepsFromImpact(motionA, motionB, band, threshold));
    if (GetSettings().options.statistics)
        contact->LeaveByLine();
}

/// Is polygon b beyond polygon a along this direction, of any length, where their bodies are?
bool SeparatesAlong(const b2Fixture &a, const b2Fixture &b, bmr_vec2 d) {
    const Placed placed[2] = {Placed(a, 0.0), Placed(b, 0.0)};
    constexpr int32 kLeast = 3; // a polygon that was never Set has fewer
    return placed[0].shape->m_count >= kLeast && placed[1].shape->m_count >= kLeast && Normalize(&d) &&
           GapAlong(placed[0], placed[1], d).gap > 0.0;
}

/// Takes the result of an update into the state of a sensor's contact. `before`: GuessDirection() from ahead
/// of the update.
void TakeSensorResult(SolidContact *sensor, bmr_vec2 before) {
    if (sensor->IsTouching()) {
        sensor->TakeResult(ProofResult::Nothing);
        return;
    }
    // If Box2D found the two apart, the direction is from another update, or there is none.
    const bmr_vec2 now = sensor->GuessDirection();
    if (SeparatesAlong(*sensor->GetFixtureA(), *sensor->GetFixtureB(), now))
        sensor->TakeResult(now.x == before.x && now.y == before.y ? ProofResult::Remembered
                                                                  : ProofResult::Another);
}

/// The contact of a sensor and another polygon, if statistics are on; otherwise nullptr.
SolidContact *SensorWithEvents(b2Contact *contact) {
    if (!GetSettings().options.statistics ||
        !(contact->GetFixtureA()->IsSensor() || contact->GetFixtureB()->IsSensor()))
        return nullptr;
    SolidContact *ours = SolidContact::AsOurs(contact);
    return ours != nullptr && ours->IsOfPolygons() ? ours : nullptr;
}

} // namespace

// A pass.

namespace {

/// Brings one contact up to date; false where it is to be destroyed. Counts those of awake bodies.
inline bool Persists(b2ContactManager *manager, b2Contact *contact, uint32_t *awake) {
    b2Fixture *fixtureA = contact->GetFixtureA(), *fixtureB = contact->GetFixtureB();
    if (ContactAccess::WantsFiltering(*contact)) {
        if (!PassesFilters(manager, fixtureA, fixtureB))
            return false;
        ContactAccess::FilteringIsDone(contact);
    }
    if (!IsActive(fixtureA->GetBody()) && !IsActive(fixtureB->GetBody()))
        return true;
    if (!BoxesOverlap(*manager, *contact))
        return false;
    b2ContactListener *const listener = manager->m_contactListener;
    const ContactChange change = UpdateContact(contact);
    CallListener(listener, contact, change, [] {}); // which may end it
    ++*awake;
    return true;
}

/// b2ContactManager::Collide by Box2D's list, contact by contact, from this one on. As in Box2D, a filter
/// or a listener that breaks the rules may have destroyed the contact that it was asked about: its memory
/// says which one is next. Returns how many contacts are of bodies that are awake.
uint32_t CollideByList(b2ContactManager *manager, b2Contact *contact) {
    uint32_t awake = 0;
    while (contact != nullptr) {
        ContactNumber::Prefetch(contact->GetNext());
        b2Contact *const visited = contact;
        const bool persists = Persists(manager, visited, &awake);
        contact = visited->*Named(NextContact());
        if (!persists)
            EndContact(manager, visited);
    }
    return awake;
}

/// A pass over the table, newest pair first.
class CollidePass {
public:
    CollidePass(PairTable *table, b2ContactManager *manager) : m_table(table), m_manager(manager) {}

    void Run();

private:
    uint32_t Next();
    uint32_t TakeNewest(uint64_t *left) const;
    void Visit(uint32_t i);
    bool PassesFilter(b2Contact *contact);
    void Destroy(uint32_t i, b2Contact *contact);
    void Wake(const b2Body *body, uint32_t i);
    void Update(uint32_t i, b2Contact *contact);
    void Prove(uint32_t i, b2Contact *contact);

    void BeforeGame();
    void AfterGame();

    PairTable *m_table;
    b2ContactManager *m_manager;
    uint32_t m_updates = 0; ///< in this pass
    uint32_t m_at = 0;      ///< pairs from here on are passed; the one that is visited is the last of them
    uint64_t m_seen = 0;    ///< the stamp of what the pass uses, as long as no code of the game ran
    uint64_t m_due = 0; ///< of the word of 64 pairs that the pass is in, those that are due and still to come
    uint32_t m_word = 0;         ///< its number; words from it on were passed
    b2Contact *m_next = nullptr; ///< if the world has left its table: the contact that comes next in the list
};

// The game's code: a listener or a filter.

/// The game may be called: contacts that the pass has passed are enabled, as Box2D's loop would have left
/// them.
void CollidePass::BeforeGame() {
    m_table->deferred.Flush(m_at + 1);
}

/// The game was called: what was read before may have changed.
void CollidePass::AfterGame() {
    if (HasLeft(m_table))
        return;
    m_table->deferred.NoteGame();
    m_table->Distrust();
    m_table->deferred.Resume(m_at + 1);
}

/// The next pair that is due. Found for 64 pairs at a time; contacts are asked for from memory some
/// visits ahead.
uint32_t CollidePass::Next() {
    constexpr int kAhead = 3;
    if (m_table->Stamp() != m_seen)
        return m_table->NextDue(m_at);
    while (m_due == 0) {
        if (m_word == 0)
            return PairTable::kNone;
        --m_word;
        m_due = m_table->DueOf(m_word);
        for (uint64_t left = m_due, ahead = kAhead; left != 0 && ahead > 0; --ahead)
            ContactNumber::Prefetch(m_table->Contact(TakeNewest(&left)));
    }
    const uint32_t next = TakeNewest(&m_due);
    uint64_t left = m_due;
    for (int ahead = 1; left != 0 && ahead < kAhead; ++ahead)
        TakeNewest(&left);
    if (left != 0)
        ContactNumber::Prefetch(m_table->Contact(TakeNewest(&left)));
    return next;
}

/// The number of the last of the word's pairs that are left.
uint32_t CollidePass::TakeNewest(uint64_t *left) const {
    const uint32_t bit = HighestBit(*left);
    *left &= ~(uint64_t{1} << bit);
    return m_word * 64 + bit;
}

bool CollidePass::PassesFilter(b2Contact *contact) {
    const bool ofGame = IsOfGame(m_manager->m_contactFilter); // ahead of the call: it may replace itself
    if (ofGame)
        BeforeGame();
    const bool passes = PassesFilters(m_manager, contact->GetFixtureA(), contact->GetFixtureB());
    if (passes)
        ContactAccess::FilteringIsDone(contact);
    if (ofGame)
        AfterGame();
    return passes;
}

void CollidePass::Destroy(uint32_t i, b2Contact *contact) {
    if (m_table->WasLeft() || (contact->IsTouching() && IsOfGame(m_manager->m_contactListener))) {
        if (!m_table->WasLeft())
            BeforeGame();
        m_next = contact->GetNext();
        EndContact(m_manager, contact);
        AfterGame();
        return;
    }
    b2Body *const bodies[2] = {contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody()};
    const bool slept[2] = {!IsActive(bodies[0]), !IsActive(bodies[1])};
    EndContact(m_manager, contact);
    for (int side = 0; side < 2; ++side) // the end of a contact that touched wakes its bodies
        if (slept[side] && IsActive(bodies[side]))
            Wake(bodies[side], i);
}

/// A body woke in the middle of the pass: its pairs that are still to come are due. The others slept when the
/// pass reached them, so they are not enabled.
void CollidePass::Wake(const b2Body *body, uint32_t i) {
    m_table->deferred.EnableDownTo(i + 1);
    m_table->Awaken(body);
    if (m_word == i / 64)
        m_due = m_table->DueOf(m_word) & ~(~uint64_t{0} << (i % 64));
}

/// As Box2D updates a contact. If it is apart afterwards, it gets a deadline.
void CollidePass::Update(uint32_t i, b2Contact *contact) {
    FixtureMotions &motions = m_table->motions;
    const Pair pair = m_table->At(i);
    Count(&Counts::updates);
    ++m_updates;
    m_table->deferred.NoteSettled(i);
    SolidContact *const sensor = SensorWithEvents(contact);
    const bmr_vec2 before = sensor != nullptr ? sensor->GuessDirection() : bmr_vec2{0.0, 0.0};
    b2ContactListener *const listener = m_manager->m_contactListener; // of this moment
    const ContactChange change = UpdateContact(contact);
    if (CallListener(listener, contact, change, [this] { BeforeGame(); }))
        AfterGame();
    if (m_table->WasLeft()) {
        m_next = contact->*Named(NextContact()); // it may have ended
        return;
    }
    if (sensor != nullptr)
        TakeSensorResult(sensor, before);
    for (const uint32_t row : {pair.a, pair.b})
        if (!motions.IsActive(row) && motions.IsActiveNow(row))
            Wake(motions[row].body, i);
    Prove(i, contact);
}

/// Gives the pair the proof that fits what it is at this moment, when the game's code ran. A listener may
/// have made a sensor solid in BeginContact, flagged the contact for filtering, or changed the two in a way
/// that it takes back before the next pass. If it stepped the world, which unlocks it, the two's boxes may
/// have parted since they were compared: the pair is due then.
void CollidePass::Prove(uint32_t i, b2Contact *contact) {
    m_table->Refresh(i);
    m_table->SetTouching(i, contact->IsTouching());
    SolidContact *ours = SolidContact::AsOurs(contact);
    if (ours != nullptr && ours->IsOfPolygons() && !contact->IsTouching() &&
        contact->GetManifold()->pointCount == 0 && !ContactAccess::WantsFiltering(*contact))
        ProveApart(m_table, i, ours);
    else
        m_table->SetDue(i);
}

void CollidePass::Visit(uint32_t i) {
    const FixtureMotions &motions = m_table->motions;
    const Pair pair = m_table->At(i);
    b2Contact *const contact = m_table->Contact(i);
    const bool hasProof = (m_table->Bits(i) & kHasProof) != 0;
    if (!hasProof)
        m_table->Refresh(i);
    // A contact that is flagged for filtering loses its proof (PairTable::Flag), and Prove gives it none.
    if (!hasProof && ContactAccess::WantsFiltering(*contact)) {
        const bool passes = PassesFilter(contact);
        if (!passes) {
            Destroy(i, contact);
            return;
        }
        if (m_table->WasLeft()) {
            m_next = contact;
            return;
        }
        m_table->Refresh(i);
    }
    if (!motions.IsActive(pair.a) && !motions.IsActive(pair.b)) { // Wake has marked bodies that woke since
        m_table->SetTouching(i, contact->IsTouching());           // an impact may have changed it
        m_table->SetAsleep(i);
        return;
    }
    const std::optional<bool> known = m_table->BoxesOverlap(i);
    if (!(known.has_value() ? *known : BoxesOverlap(*m_manager, *contact))) {
        Destroy(i, contact);
        return;
    }
    if (m_table->Renew(i, ApartThreshold(*m_table, i))) {
        Count(&Counts::renewals);
        return;
    }
    Update(i, contact);
}

void CollidePass::Run() {
    const uint32_t fixtures = m_table->UpdateMotions();
    for (uint32_t word = 0; GetSettings().options.statistics && word <= m_table->Count() / 64; ++word)
        GetCounts().pairs.fetch_add(CountBits(m_table->AwakeOf(word)), std::memory_order_relaxed);
    m_table->deferred.Begin(m_table->Count());
    m_seen = m_table->Stamp();
    m_at = m_table->Count();
    m_word = m_at / 64 + 1;
    for (uint32_t i = Next(); i != PairTable::kNone; i = Next()) {
        m_at = i;
        Visit(i);
        if (m_table->WasLeft()) {
            CollideByList(m_manager, m_next);
            return;
        }
    }
    m_table->deferred.End();
    m_table->cost.NotePass(m_updates, fixtures, static_cast<uint32_t>(m_manager->m_contactCount),
                           m_table->AwakeCount());
}

} // namespace

void Collide(b2ContactManager *manager, PairTable *table) {
    if (table != nullptr) {
        CollidePass(table, manager).Run();
        return;
    }
    const uint32_t awake = CollideByList(manager, manager->m_contactList);
    if (PairTable *const resting = FindPairTable(manager))
        resting->cost.NoteList(static_cast<uint32_t>(manager->m_contactCount), awake);
}

} // namespace bmr
