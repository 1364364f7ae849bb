// SPDX-License-Identifier: MIT
#include "worlds/stepping.h"

#include <algorithm>
#include <cmath>

#include "boomerang/distance.h"

namespace testbed {
namespace {

/// Of the list, in radii of the smallest body: what made the whole fastest, within a tenth, at densities from
/// 0.1 to 0.3.
constexpr double kSkin = 0.4;
/// A contact may be told at a distance a little above the margin (what the bodies fly in failure.tolerance).
constexpr double kRounding = 1e-9;
constexpr double kShortest = 1e-12;
constexpr int kHalvings = 40;
constexpr double kNextStep = 0.98;

bmr_pose PoseAt(const bmr_motion_piece &piece, double time) {
    return bmr_screw_motion_pose(&piece.as.screw, time - piece.origin);
}

/// The least height of a body above a wall of the box.
double HeightAbove(const bmr_polygon *polygon, const bmr_pose &pose, bmr_body wall, const WorldSetup &setup) {
    const auto side = static_cast<unsigned>(wall - BMR_WALL(0));
    double least = HUGE_VAL;
    for (uint32_t i = 0; i < polygon->count; ++i) {
        const bmr_vec2 at = bmr_transform(&pose, polygon->vertices[i]);
        const double heights[BMR_WALLS] = {at.x - setup.low.x, setup.high.x - at.x, at.y - setup.low.y,
                                           setup.high.y - at.y};
        least = std::min(least, heights[side]);
    }
    return least;
}

} // namespace

double TimeToNotice(const bmr_contact &contact, const WorldRun &run, const WorldSetup &setup) {
    const double margin = std::max(bmr_default_kds_def().margin, contact.distance) + kRounding;
    const bmr_body_state a = run.StateOf(contact.a);
    const bool wall = bmr_is_wall(contact.b);
    const bmr_body_state b = wall ? a : run.StateOf(contact.b);
    const auto isNear = [&](double after) {
        const double time = contact.time + after;
        const bmr_pose pose = PoseAt(a.piece, time);
        if (wall)
            return HeightAbove(a.shape->polygon, pose, contact.b, setup) <= margin;
        bmr_pose other = PoseAt(b.piece, time);
        other.position = bmr_add(other.position, contact.image);
        bmr_closest_points closest;
        return bmr_distance(a.shape->polygon, &pose, b.shape->polygon, &other, &closest) == BMR_OK &&
               closest.distance <= margin;
    };
    double near = 0.0, apart = kShortest;
    while (apart < setup.choice.seconds && isNear(apart)) {
        near = apart;
        apart *= 2.0;
    }
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (near + apart);
        (isNear(middle) ? near : apart) = middle;
    }
    return near;
}

size_t CountMissed(const std::vector<Noticed> &contacts, double h) {
    return static_cast<size_t>(std::count_if(contacts.begin(), contacts.end(), [h](const Noticed &contact) {
        return std::ceil(contact.time / h) * h > contact.time + contact.window;
    }));
}

double FaithfulStep(const std::vector<Noticed> &contacts, double longest) {
    double h = longest;
    while (h > kShortest && CountMissed(contacts, h) > 0)
        h *= kNextStep;
    return h;
}

Paths::Paths(const WorldSetup &setup) {
    for (const WorldBody &body : setup.bodies) {
        m_legs.emplace_back();
        Change(m_legs.size() - 1, 0.0, bmr_piece_screw(0.0, body.pose, body.velocity, body.spin));
    }
}

void Paths::Change(size_t body, double time, const bmr_motion_piece &piece) {
    m_legs[body].push_back({time, piece.origin, piece.as.screw});
}

Stepper::Stepper(const WorldSetup &setup, const Paths &paths)
    : m_setup(setup), m_paths(paths), m_leg(setup.bodies.size(), 0), m_poses(setup.bodies.size()),
      m_def(bmr_default_pair_def()), m_skin(kSkin) {
    m_def.structure = BMR_FREE_DIRECTION;
    m_def.margin = bmr_default_kds_def().margin;
    for (const WorldBody &body : setup.bodies) {
        m_shapes.push_back(body.polygon->Shape());
        m_largest = std::max(m_largest, body.radius);
    }
    MoveTo(0.0);
    MakeList();
    Look();
}

void Stepper::MoveTo(double time) {
    double fastest = 0.0;
    for (size_t i = 0; i < m_poses.size(); ++i) {
        const std::vector<Paths::Leg> &legs = m_paths.Of(i);
        while (m_leg[i] + 1 < legs.size() && legs[m_leg[i] + 1].from <= time)
            ++m_leg[i];
        const Paths::Leg &leg = legs[m_leg[i]];
        m_poses[i] = bmr_screw_motion_pose(&leg.motion, time - leg.origin);
        fastest = std::max(fastest, bmr_dot(leg.motion.velocity, leg.motion.velocity));
    }
    m_moved += (time - m_time) * std::sqrt(fastest);
    m_time = time;
}

void Stepper::MakeList() {
    const double cell = 2.0 * m_largest + m_skin;
    const auto columnOf = [&](double x, double low) {
        return static_cast<int64_t>(std::floor((x - low) / cell));
    };
    std::unordered_map<int64_t, std::vector<uint32_t>> cells;
    const auto keyOf = [](int64_t column, int64_t row) { return column * 4194304 + row; };
    std::unordered_map<uint64_t, bmr_pair> kept;
    for (size_t k = 0; k < m_pairs.size(); ++k)
        kept.emplace(static_cast<uint64_t>(m_bodies[k].a) << 32U | m_bodies[k].b, m_pairs[k]);
    m_pairs.clear();
    m_bodies.clear();
    for (uint32_t i = 0; i < m_poses.size(); ++i) {
        const bmr_vec2 at = m_poses[i].position;
        const int64_t column = columnOf(at.x, m_setup.low.x), row = columnOf(at.y, m_setup.low.y);
        for (int64_t x = column - 1; x <= column + 1; ++x)
            for (int64_t y = row - 1; y <= row + 1; ++y) {
                const auto found = cells.find(keyOf(x, y));
                if (found == cells.end())
                    continue;
                for (const uint32_t j : found->second) {
                    const bmr_vec2 way = bmr_sub(m_poses[j].position, at);
                    const double reach = m_setup.bodies[i].radius + m_setup.bodies[j].radius + m_skin;
                    if (bmr_dot(way, way) > reach * reach)
                        continue;
                    const auto old = kept.find(static_cast<uint64_t>(j) << 32U | i);
                    m_bodies.push_back({j, i});
                    m_pairs.emplace_back();
                    if (old != kept.end())
                        m_pairs.back() = old->second;
                    else
                        bmr_pair_init(&m_pairs.back());
                }
            }
        cells[keyOf(column, row)].push_back(i);
    }
    m_failed.resize(m_pairs.size());
    m_moved = 0.0;
    ++m_lists;
}

void Stepper::Look() {
    size_t count = 0;
    Require(bmr_pairs_check(m_pairs.data(), m_bodies.data(), m_pairs.size(), m_poses.data(), m_poses.size(),
                            m_def.margin, m_failed.data(), &count),
            "the pairs");
    m_touching = 0;
    for (size_t k = 0; k < count; ++k) {
        const bmr_pair_bodies &of = m_bodies[m_failed[k]];
        const bmr_pose pose = bmr_pose_relative(&m_poses[of.a], &m_poses[of.b]);
        double gap = 0.0;
        if (bmr_pair_advance(&m_pairs[m_failed[k]], &m_def, &m_shapes[of.a], &m_shapes[of.b], &pose, nullptr,
                             &gap) == BMR_STAB_POLYGON)
            ++m_touching;
    }
    m_repairs += count;
}

void Stepper::StepTo(double time) {
    MoveTo(time);
    if (2.0 * m_moved > m_skin)
        MakeList();
    Look();
}

} // namespace testbed
