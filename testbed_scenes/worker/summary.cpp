// SPDX-License-Identifier: MIT
#include "worker/summary.h"

#include <algorithm>
#include <cinttypes>
#include <cstdio>

#include <dlfcn.h>

#include "count/count.h"

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

Summary::Summary(const SceneInfo &info, const Options &options)
    : m_info(info), m_options(options), m_toiRunsBefore(ToiRuns()), m_gjkRunsBefore(GjkRuns()),
      m_callsBefore(ReadCounts()) {}

void Summary::AddStep(const b2World &world, long nanoseconds) {
    ++m_steps;
    m_contacts += world.GetContactCount();
    m_nanoseconds += nanoseconds;
    m_collide += static_cast<double>(world.GetProfile().collide);
    // Walking the contacts would warm the caches of the next step, so not while it is timed.
    if (m_options.mode == Mode::Time)
        return;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        m_polygonContacts += IsPolygonContact(*contact) ? 1 : 0;
}

void Summary::AddHashes(const StateHashes &hashes) {
    m_hash.Field("bodies", hashes.bodies);
    m_hash.Field("contacts", hashes.contacts);
    m_hash.Field("events", hashes.events);
}

nlohmann::json Summary::ToJson(const b2World &world) const {
    const double steps = static_cast<double>(std::max(m_steps, 1L));
    nlohmann::json json = {{"scene", m_info.name},
                           {"program", PluginName()},
                           {"mode", NameOf(m_options.mode)},
                           {"size", m_options.size.value_or(m_info.size)},
                           {"seed", m_options.seed.value_or(m_info.seed)},
                           {"steps", m_steps},
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
        break;
    case Mode::Time:
        json["step_ns_total"] = m_nanoseconds;
        json["collide_ms_total"] = m_collide;
        break;
    }
    return json;
}

} // namespace testbed
