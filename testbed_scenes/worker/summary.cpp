// SPDX-License-Identifier: MIT
#include "worker/summary.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <numeric>

#include <dlfcn.h>

#include "count/count.h"
#include "stage.h"

// Box2D counts its own work; it declares these where it uses them.
extern B2_API int32 b2_toiCalls, b2_gjkCalls;

namespace testbed {
namespace {

// As unsigned numbers their differences are right even past 2^31 calls.
uint32_t ToiRuns() {
    return static_cast<uint32_t>(b2_toiCalls);
}
uint32_t GjkRuns() {
    return static_cast<uint32_t>(b2_gjkCalls);
}

long Median(std::vector<long> values) {
    if (values.empty())
        return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

bool IsPolygonContact(const b2Contact &contact) {
    return contact.GetFixtureA()->GetType() == b2Shape::e_polygon &&
           contact.GetFixtureB()->GetType() == b2Shape::e_polygon;
}

/// Calls since the process began; nothing where the counting library is not preloaded.
std::optional<boomerang_counts> ReadCounts() {
    const auto read =
        reinterpret_cast<decltype(&boomerang_count_read)>(dlsym(RTLD_DEFAULT, "boomerang_count_read"));
    if (read == nullptr)
        return std::nullopt;
    boomerang_counts counts = {};
    read(&counts);
    return counts;
}

/// Calls of the whole run (`before`: those made before it), null where they are not counted.
void AddCalls(nlohmann::json &json, const std::optional<boomerang_counts> &before) {
    const std::optional<boomerang_counts> counts = ReadCounts();
    const auto set = [&](const char *name, uint64_t boomerang_counts::*calls) {
        json[name] =
            counts && before ? nlohmann::json((*counts).*calls - (*before).*calls) : nlohmann::json();
    };
    set("polygon_tests", &boomerang_counts::polygon_tests);
    set("polygon_tests_apart", &boomerang_counts::polygon_tests_apart);
    set("toi_calls", &boomerang_counts::toi_calls);
    set("distance_calls", &boomerang_counts::distance_calls);
    set("overlap_calls", &boomerang_counts::overlap_calls);
}

} // namespace

Summary::Summary(const SceneInfo &info, const Options &options, int steps)
    : m_info(info), m_options(options), m_stepsWanted(steps), m_toiRunsBefore(ToiRuns()),
      m_gjkRunsBefore(GjkRuns()), m_callsBefore(ReadCounts()) {
    m_nanoseconds.reserve(static_cast<std::size_t>(steps));
}

void Summary::AddStep(const b2World &world, long nanoseconds) {
    ++m_steps;
    m_contacts += world.GetContactCount();
    m_nanoseconds.push_back(nanoseconds);
    const b2Profile &profile = world.GetProfile();
    m_collide += static_cast<double>(profile.collide);
    m_solve += static_cast<double>(profile.solve);
    m_broadphase += static_cast<double>(profile.broadphase);
    m_solveToi += static_cast<double>(profile.solveTOI);
    // Walking the contacts would warm the caches of the next step, so not while it is timed.
    if (m_options.mode == Mode::Time)
        return;
    if (m_options.mode == Mode::Count)
        m_behaviour.AddStep(world);
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        m_polygonContacts += IsPolygonContact(*contact) ? 1 : 0;
}

void Summary::AddHashes(const StateHashes &hashes) {
    m_hash.Field("bodies", hashes.bodies);
    m_hash.Field("contacts", hashes.contacts);
    m_hash.Field("events", hashes.events);
}

void Summary::AddTimes(nlohmann::json &json) const {
    json["step_ns_total"] = std::accumulate(m_nanoseconds.begin(), m_nanoseconds.end(), 0L);
    json["step_ns_median"] = Median(m_nanoseconds);
    json["collide_ms_total"] = m_collide;
    json["solve_ms"] = m_solve;
    json["broadphase_ms"] = m_broadphase;
    json["solveTOI_ms"] = m_solveToi;
}

nlohmann::json Summary::ToJson(const b2World &world) const {
    const double steps = static_cast<double>(std::max(m_steps, 1L));
    nlohmann::json json = {{"scene", m_info.name},
                           {"program", PluginName()},
                           {"presence", PluginPresence()},
                           {"mode", NameOf(m_options.mode)},
                           {"size", m_options.size.value_or(m_info.size)},
                           {"seed", m_options.seed.value_or(m_info.seed)},
                           {"steps", m_steps},
                           {"steps_wanted", m_stepsWanted},
                           {"bodies", world.GetBodyCount()},
                           {"contacts", static_cast<double>(m_contacts) / steps}};
    if (const PolygonChoice polygons = PolygonsOf(m_info, m_options); polygons.vertices > 0) {
        json["vertices"] = polygons.vertices;
        json["kind"] = NameOf(polygons.bodies);
    }
    if (m_options.mode != Mode::Time)
        json["polygon_contacts"] = static_cast<double>(m_polygonContacts) / steps;
    switch (m_options.mode) {
    case Mode::Hash: {
        char text[17];
        std::snprintf(text, sizeof text, "%016" PRIx64, m_hash.Value());
        json["hash"] = text;
        break;
    }
    case Mode::Count:
        AddCalls(json, m_callsBefore);
        json["box2d_toi_runs"] = ToiRuns() - m_toiRunsBefore;
        json["box2d_gjk_runs"] = GjkRuns() - m_gjkRunsBefore;
        json["plugin"] = PluginStatistics();
        json["behaviour"] = m_behaviour.ToJson();
        break;
    case Mode::Time:
        AddTimes(json);
        break;
    }
    return json;
}

namespace {

double EnergyOf(const b2Body &body, const b2Vec2 &gravity) {
    const double mass = static_cast<double>(body.GetMass());
    // Of a body inertia is given about its origin.
    const b2Vec2 centre = body.GetLocalCenter();
    const double inertia =
        static_cast<double>(body.GetInertia()) - mass * static_cast<double>(b2Dot(centre, centre));
    const double speed2 = static_cast<double>(body.GetLinearVelocity().LengthSquared());
    const double spin = static_cast<double>(body.GetAngularVelocity());
    return 0.5 * (mass * speed2 + inertia * spin * spin) -
           mass * static_cast<double>(b2Dot(gravity, body.GetWorldCenter()));
}

float DeepestOverlap(const b2World &world) {
    float deepest = 0.0f;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        if (!contact->IsTouching() || contact->GetFixtureA()->IsSensor() ||
            contact->GetFixtureB()->IsSensor())
            continue;
        b2WorldManifold points;
        contact->GetWorldManifold(&points);
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            deepest = std::max(deepest, -points.separations[i]);
    }
    return deepest;
}

} // namespace

void Behaviour::AddStep(const b2World &world) {
    if (m_steps == 0)
        for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
            if (body->GetType() == b2_dynamicBody)
                m_places.emplace(NumberOf(*body), body->GetPosition());
    m_awake = 0;
    m_energy = 0.0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() != b2_dynamicBody)
            continue;
        m_awake += body->IsAwake() ? 1 : 0;
        m_energy += EnergyOf(*body, world.GetGravity());
    }
    if (m_steps == 0)
        m_energyStart = m_energy;
    m_energyGain = std::max(m_energyGain, m_energy - m_energyStart);
    if (m_awake > 0)
        m_asleepFrom = -1;
    else if (m_asleepFrom < 0)
        m_asleepFrom = m_steps;
    m_overlap = DeepestOverlap(world);
    m_deepest = std::max(m_deepest, m_overlap);
    ++m_steps;
    AddMoved(world);
}

/// A body that was made since has no place to be compared with.
void Behaviour::AddMoved(const b2World &world) {
    double sum = 0.0, most = 0.0;
    std::size_t count = 0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        const auto place = m_places.find(NumberOf(*body));
        if (place == m_places.end())
            continue;
        const auto moved = static_cast<double>(b2Distance(body->GetPosition(), place->second));
        sum += moved;
        most = std::max(most, moved);
        ++count;
    }
    m_moved = count > 0 ? sum / static_cast<double>(count) : 0.0;
    m_movedMost = most;
}

nlohmann::json Behaviour::ToJson() const {
    return {{"awake", m_awake},
            {"asleep_from", m_asleepFrom < 0 ? nlohmann::json() : nlohmann::json(m_asleepFrom)},
            {"overlap", m_overlap},
            {"overlap_deepest", m_deepest},
            {"energy", m_energy},
            {"energy_start", m_energyStart},
            {"energy_gain", m_energyGain},
            {"moved", m_moved},
            {"moved_most", m_movedMost}};
}

} // namespace testbed
