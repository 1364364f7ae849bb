// SPDX-License-Identifier: MIT
#include "glue/proofs/hull_pair.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>

#include "debug/statistics.h"
#include "glue/proofs/thresholds.h"
#include "shapes/big_polygons.h"
#include "shapes/shapes32.h"
#include "shapes/small_polygon.h"
#include "start/settings.h"

namespace bmr {

namespace {

void AddVertices(const b2PolygonShape &polygon, HullVector<bmr_vec2> *points) {
    if (const bmr_convex32_block *big = BigPolygonOf(polygon)) {
        for (uint32_t i = 0; i < big->polygon.count; ++i)
            points->push_back(Double(big->polygon.vertices[i]));
        return;
    }
    for (int32 i = 0; i < polygon.m_count; ++i)
        points->push_back(Double(polygon.m_vertices[i]));
}

/// nullptr where the structure needs none, or where the hull has too many vertices for the compass.
bmr_hierarchy *BuildHierarchy(const bmr_polygon *polygon) {
    const Settings &settings = GetSettings();
    bmr_hierarchy *hierarchy = nullptr;
    if (settings.pairDef.structure == BMR_LAZY_COMPASS)
        (void)bmr_hierarchy_build_compass(polygon, settings.compass, nullptr, &hierarchy);
    else if (settings.pairDef.structure == BMR_LAZY_DUDLEY)
        (void)bmr_hierarchy_build_dudley(polygon, nullptr, &hierarchy);
    return hierarchy;
}

} // namespace

/// Takes in the fixtures that the hull is to hold, and their vertices. False where one of them makes a hull
/// worthless: Box2D sees more of it than its vertices.
bool Hull::Gather(HullVector<bmr_vec2> *points) {
    for (const b2Fixture *f = m_body->GetFixtureList(); f != nullptr; f = f->GetNext()) {
        const b2PolygonShape *polygon = PolygonOf(*f);
        if (polygon == nullptr || f->IsSensor() || (m_fixture != nullptr && f != m_fixture))
            continue;
        if (BigPolygonOf(*polygon) == nullptr && !VerticesTellAll(*polygon))
            return false;
        m_members.push_back({f, DigestOf(*polygon)});
        m_radius = std::max(m_radius, polygon->m_radius);
        AddVertices(*polygon, points);
    }
    return true;
}

void Hull::Build() {
    Forget();
    HullVector<bmr_vec2> points;
    bmr_polygon *polygon = nullptr;
    if (!Gather(&points) || bmr_polygon_create(points.data(), points.size(), nullptr, &polygon) != BMR_OK)
        return;
    m_shape.polygon = polygon;
    if (bmr_hierarchy *hierarchy = BuildHierarchy(polygon))
        m_shape.hierarchies[bmr_hierarchy_get_kind(hierarchy)] = hierarchy;
    m_reach = 2.0 * polygon->extent; // no vertex is farther than sqrt(2) of it
    Count(&Counts::hulls);
}

void Hull::Forget() {
    for (const bmr_hierarchy *hierarchy : m_shape.hierarchies)
        bmr_hierarchy_destroy(const_cast<bmr_hierarchy *>(hierarchy), nullptr);
    bmr_polygon_destroy(const_cast<bmr_polygon *>(m_shape.polygon), nullptr);
    m_shape = {};
    m_members.clear();
    m_reach = 0.0;
    m_radius = 0.0f;
    ++m_version;
}

const bmr_hierarchy *Hull::Hierarchy() const {
    for (const bmr_hierarchy *hierarchy : m_shape.hierarchies)
        if (hierarchy != nullptr)
            return hierarchy;
    return nullptr;
}

bool Hull::Holds(const b2Fixture &fixture) const {
    for (const Member &member : m_members)
        if (member.fixture == &fixture)
            return member.digest == DigestOf(*PolygonOf(fixture));
    return false;
}

bool Hull::MakeHold(const b2Fixture &fixture) {
    // (Where none could be built, trying again for every contact would cost more than it could save.)
    if (m_shape.polygon == nullptr)
        return false;
    if (!Holds(fixture))
        Build();
    return m_shape.polygon != nullptr && Holds(fixture);
}

namespace {

bool SamePose(const b2Transform &a, const b2Transform &b) {
    // The same bits, NaNs too: four floats without padding.
    return std::memcmp(&a, &b, sizeof a) == 0; // NOLINT(bugprone-suspicious-memory-comparison)
}

bmr_pair_def DefOf(const HullPair &pair) {
    bmr_pair_def def = GetSettings().pairDef;
    def.margin = ContactMargin(static_cast<double>(pair.a->Radius() + pair.b->Radius()));
    return def;
}

void OnEvent(void *context, const bmr_event *event) {
    const auto *pair = static_cast<const HullPair *>(context);
    ReportEvent(pair->a->Body(), pair->b->Body(), *event);
}

bool IsWithinReach(const HullPair &pair, const b2Transform &poseA, const b2Transform &poseB) {
    return WithinReach(poseA, pair.a->Reach()) && WithinReach(poseB, pair.b->Reach());
}

bmr_answer Advance(HullPair *pair, const bmr_pose &relative) {
    const bmr_pair_def def = DefOf(*pair);
    const bmr_shape &a = pair->a->Shape(), &b = pair->b->Shape();
    if (!GetSettings().options.statistics)
        return bmr_pair_advance(&pair->kinetic, &def, &a, &b, &relative, nullptr, nullptr);
    bmr_counters counters = {};
    const bmr_observer observer = {&counters, OnEvent, pair};
    const bmr_answer answer = bmr_pair_advance(&pair->kinetic, &def, &a, &b, &relative, &observer, nullptr);
    GetCounts().hullChecks.fetch_add(counters.checks, std::memory_order_relaxed);
    return answer;
}

bmr_pose Relative(const b2Transform &poseA, const b2Transform &poseB) {
    const bmr_pose a = PoseOf(poseA), b = PoseOf(poseB);
    return bmr_pose_relative(&a, &b);
}

} // namespace

bool KnownApart(HullPair *pair, const b2Transform &poseA, const b2Transform &poseB) {
    const bool sameHulls = pair->versionA == pair->a->Version() && pair->versionB == pair->b->Version();
    if (sameHulls && SamePose(poseA, pair->poseA) && SamePose(poseB, pair->poseB)) {
        Count(&Counts::verdictsReused);
        return pair->apart;
    }
    if (!sameHulls) // also where the pair is out of reach: the next question finds these versions
        bmr_pair_init(&pair->kinetic);
    pair->apart = IsWithinReach(*pair, poseA, poseB) && Advance(pair, Relative(poseA, poseB)) == BMR_APART;
    pair->poseA = poseA;
    pair->poseB = poseB;
    pair->versionA = pair->a->Version();
    pair->versionB = pair->b->Version();
    return pair->apart;
}

bool HullPair::IsSwapped(const b2Contact &contact) const {
    return a->Body() != contact.GetFixtureA()->GetBody();
}

HullPairs::Used *HullPairs::Acquire(const b2Fixture &fixture) {
    const b2Body *const body = fixture.GetBody();
    const b2Fixture *const alone = body->GetType() == b2_staticBody ? &fixture : nullptr;
    const void *const key = alone != nullptr ? static_cast<const void *>(alone) : body;
    const auto [found, isNew] = m_hulls.try_emplace(key, body, alone, m_made);
    m_made += isNew ? 1 : 0;
    return &found->second;
}

HullPair *HullPairs::PairOf(const b2Contact &contact) {
    Used *a = Acquire(*contact.GetFixtureA()), *b = Acquire(*contact.GetFixtureB());
    if (a->number > b->number)
        std::swap(a, b);
    const auto [found, isNew] = m_pairs.try_emplace(uint64_t{a->number} << 32 | b->number);
    HullPair *const pair = &found->second;
    if (isNew) {
        pair->a = &a->hull;
        pair->b = &b->hull;
        ++a->pairs;
        ++b->pairs;
        Count(&Counts::structures);
    }
    ++pair->contacts;
    return pair;
}

bool HullPairs::SayApart(uint32_t number, const b2Contact &contact, const b2Transform &xfA,
                         const b2Transform &xfB) {
    if (m_ofContacts[number] == nullptr)
        m_ofContacts[number] = PairOf(contact);
    HullPair *const pair = m_ofContacts[number];
    const bool swapped = pair->IsSwapped(contact);
    const b2Fixture &first = *contact.GetFixtureA(), &second = *contact.GetFixtureB();
    return pair->a->MakeHold(swapped ? second : first) && pair->b->MakeHold(swapped ? first : second) &&
           KnownApart(pair, swapped ? xfB : xfA, swapped ? xfA : xfB);
}

void HullPairs::Reserve(uint32_t count) {
    if (count > m_ofContacts.size())
        m_ofContacts.resize(count);
}

void HullPairs::End(uint32_t number) {
    if (number >= m_ofContacts.size() || m_ofContacts[number] == nullptr)
        return;
    HullPair *const pair = m_ofContacts[number];
    m_ofContacts[number] = nullptr;
    if (--pair->contacts > 0)
        return;
    const auto keyOf = [](const Hull &hull) {
        return hull.Fixture() != nullptr ? static_cast<const void *>(hull.Fixture()) : hull.Body();
    };
    const auto a = m_hulls.find(keyOf(*pair->a)), b = m_hulls.find(keyOf(*pair->b));
    m_pairs.erase(uint64_t{a->second.number} << 32 | b->second.number);
    if (--a->second.pairs == 0)
        m_hulls.erase(a);
    if (--b->second.pairs == 0)
        m_hulls.erase(b);
}

void HullPairs::Renumber(uint32_t from, uint32_t to) {
    if (from != to && from < m_ofContacts.size())
        m_ofContacts[to] = std::exchange(m_ofContacts[from], nullptr);
}

void HullPairs::Clear() {
    m_ofContacts.assign(m_ofContacts.size(), nullptr);
    m_pairs.clear();
    m_hulls.clear();
}

bmr_vec2 DirectionOf(const HullPair &pair, const b2Contact &contact) {
    const bmr_pair &kinetic = pair.kinetic;
    if (!pair.apart || kinetic.state != BMR_PAIR_APART || kinetic.level == BMR_LEVEL_DISKS)
        return {0.0, 0.0};
    const bool ofA = kinetic.owner == 0;
    const b2Rot &q = (ofA ? pair.a : pair.b)->Body()->GetTransform().q;
    const bmr_pose turn = {{0.0, 0.0}, static_cast<double>(q.c), static_cast<double>(q.s)};
    const float *const n = kinetic.certificate.normal;
    const bmr_vec2 d = bmr_rotate(&turn, {static_cast<double>(n[0]), static_cast<double>(n[1])});
    return ofA != pair.IsSwapped(contact) ? d : bmr_neg(d);
}

bmr_pair KineticPairNow(const HullPair &pair, double *gap) {
    bmr_pair copy = pair.kinetic;
    *gap = 0.0;
    const b2Transform &poseA = pair.a->Body()->GetTransform(), &poseB = pair.b->Body()->GetTransform();
    if (pair.a->Shape().polygon == nullptr || pair.b->Shape().polygon == nullptr ||
        !IsWithinReach(pair, poseA, poseB))
        return copy;
    const bmr_pair_def def = DefOf(pair);
    const bmr_pose relative = Relative(poseA, poseB);
    double proved = 0.0;
    if (bmr_pair_advance(&copy, &def, &pair.a->Shape(), &pair.b->Shape(), &relative, nullptr, &proved) ==
        BMR_APART)
        *gap = proved - kRoundingMargin;
    return copy;
}

} // namespace bmr
