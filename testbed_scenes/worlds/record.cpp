// SPDX-License-Identifier: MIT
#include "worlds/record.h"

#include <algorithm>
#include <cmath>

namespace testbed {
namespace {

using recording::Vec;

Vec ToVec(bmr_vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

/// The vertex of a body's polygon that is farthest in a direction of its frame.
Vec Farthest(const bmr_polygon *polygon, bmr_vec2 direction) {
    return ToVec(polygon->vertices[bmr_polygon_support(polygon, direction)]);
}

} // namespace

WorldRecorder::WorldRecorder(const WorldSetup &setup, int64_t steps) : m_setup(setup), m_steps(steps) {}

recording::Head WorldRecorder::Head() const {
    recording::Head head;
    head.scene = m_setup.choice.scene;
    head.program = "world";
    head.structure = m_setup.choice.structure;
    head.size = static_cast<int64_t>(m_setup.bodies.size());
    head.seed = m_setup.choice.seed;
    head.time_step = static_cast<float>(m_setup.choice.seconds / static_cast<double>(m_steps));
    head.last = m_steps;
    if (m_setup.choice.boundary == BMR_PERIODIC)
        head.period = ToVec(bmr_sub(m_setup.high, m_setup.low));
    return head;
}

int WorldRecorder::NumberOf(bmr_body body) const {
    return static_cast<int>(bmr_is_wall(body) ? m_setup.bodies.size() + (body - BMR_WALL(0)) : body);
}

bmr_vec2 WorldRecorder::Wrapped(bmr_vec2 position) const {
    if (m_setup.choice.boundary != BMR_PERIODIC)
        return bmr_vec2_make(0.0, 0.0);
    const bmr_vec2 box = bmr_sub(m_setup.high, m_setup.low), at = bmr_sub(position, m_setup.low);
    return bmr_vec2_make(box.x * std::floor(at.x / box.x), box.y * std::floor(at.y / box.y));
}

void WorldRecorder::Add(const bmr_contact &contact) {
    recording::Contact record;
    record.bodies = {NumberOf(contact.a), NumberOf(contact.b)};
    record.normal = ToVec(contact.normal);
    for (size_t i = 0; i < contact.count; ++i) {
        recording::ContactPoint point;
        point.at = ToVec(bmr_sub(contact.points[i], Wrapped(contact.points[i])));
        point.separation = static_cast<float>(contact.distance);
        record.points.push_back(point);
    }
    m_frame.touching.push_back(record);
}

void WorldRecorder::Add(const bmr_world_event &event) {
    if (event.b == BMR_NO_BODY)
        return;
    recording::Event record;
    record.step = m_step;
    record.kind = event.kind == BMR_WORLD_NEAR || event.kind == BMR_WORLD_REPAIR
                      ? bmr_kds_event_name(event.report.kind)
                      : bmr_world_event_name(event.kind);
    record.a = NumberOf(event.a);
    record.b = NumberOf(event.b);
    record.level_before = event.report.level_before;
    record.level_after = event.report.level_after;
    m_frame.events.push_back(record);
}

void WorldRecorder::AddWalls() {
    if (m_setup.choice.boundary != BMR_WALLED)
        return;
    const Vec low = ToVec(m_setup.low), high = ToVec(m_setup.high);
    const std::array<std::array<Vec, 2>, BMR_WALLS> sides = {{{{{low.x, low.y}, {low.x, high.y}}},
                                                              {{{high.x, low.y}, {high.x, high.y}}},
                                                              {{{low.x, low.y}, {high.x, low.y}}},
                                                              {{{low.x, high.y}, {high.x, high.y}}}}};
    for (unsigned side = 0; side < BMR_WALLS; ++side) {
        recording::Body body;
        body.number = NumberOf(BMR_WALL(side));
        body.type = "static";
        // The frame of core's wall: at the middle of its side.
        body.pose.position = {0.5f * (sides[side][0].x + sides[side][1].x),
                              0.5f * (sides[side][0].y + sides[side][1].y)};
        m_frame.bodies.push_back(body);
        if (m_step > 0)
            continue;
        recording::Fixture fixture;
        fixture.body = body.number;
        fixture.shape = "edge";
        for (const Vec &end : sides[side])
            fixture.points.push_back({end.x - body.pose.position.x, end.y - body.pose.position.y});
        m_frame.fixtures.push_back(fixture);
    }
}

void WorldRecorder::AddBodies(const WorldRun &run) {
    for (size_t i = 0; i < m_setup.bodies.size(); ++i) {
        const bmr_body_state state = run.StateOf(i);
        recording::Body body;
        body.number = static_cast<int>(i);
        body.type = "dynamic";
        body.pose = {ToVec(bmr_sub(state.pose.position, Wrapped(state.pose.position))),
                     static_cast<float>(state.pose.c), static_cast<float>(state.pose.s)};
        m_frame.bodies.push_back(body);
        const Vec low = ToVec(state.cell_low), high = ToVec(state.cell_high);
        if (low.x < high.x)
            m_frame.boxes.push_back({body.number, 0, 0, low.x, low.y, high.x, high.y});
        if (m_step > 0)
            continue;
        recording::Fixture fixture;
        fixture.body = body.number;
        fixture.shape = "polygon";
        for (const bmr_vec2 &vertex : m_setup.bodies[i].polygon->Vertices())
            fixture.points.push_back(ToVec(vertex));
        m_frame.fixtures.push_back(fixture);
    }
    AddWalls();
}

recording::Proof WorldRecorder::ProofOf(const bmr_world_pair &pair, const WorldRun &run) const {
    recording::Proof proof;
    const bmr_body_state a = run.StateOf(pair.a);
    bmr_pose pose = bmr_pose_identity(); // of b, its image that a is near to
    const bmr_polygon *polygon = nullptr;
    double radius = 0.0;
    if (!bmr_is_wall(pair.b)) {
        const bmr_body_state b = run.StateOf(pair.b);
        pose = b.pose;
        polygon = b.shape->polygon;
        radius = b.radius;
    }
    const bmr_vec2 image = bmr_sub(bmr_add(pose.position, pair.image), Wrapped(a.pose.position)),
                   shown = bmr_sub(pose.position, Wrapped(pose.position)), off = bmr_sub(image, shown);
    const double box = m_setup.high.x - m_setup.low.x;
    if (std::hypot(off.x, off.y) > 0.5 * box)
        return proof;
    if (pair.watch == BMR_WATCH_DISKS) {
        // Of a wall no disk can be drawn.
        if (polygon == nullptr)
            return proof;
        const bmr_vec2 way = bmr_sub(bmr_add(pose.position, pair.image), a.pose.position);
        proof.kind = "disks";
        proof.radii = {static_cast<float>(a.radius), static_cast<float>(radius)};
        proof.slack = static_cast<float>(std::max(0.0, std::hypot(way.x, way.y) - a.radius - radius));
        return proof;
    }
    bmr_kds_proof line;
    if (pair.kds == nullptr || polygon == nullptr || !bmr_kds_get_proof(pair.kds, &line))
        return proof;
    bmr_pose b = pose;
    b.position = bmr_add(b.position, pair.image);
    // The body born first is the structure's A, and the pair's.
    const bmr_pose *own = line.owner == 0 ? &a.pose : &b, *other = line.owner == 0 ? &b : &a.pose;
    const bmr_polygon *const owner = line.owner == 0 ? a.shape->polygon : polygon;
    const bmr_vec2 nearest = bmr_unrotate(own, bmr_sub(bmr_transform(other, line.nearest), own->position));
    const auto side = static_cast<size_t>(line.owner);
    proof.kind = "direction";
    proof.owner = line.owner;
    proof.level = line.level;
    proof.normal = ToVec(line.line.normal);
    proof.supports[side] = Farthest(owner, line.line.normal);
    proof.supports[1 - side] = ToVec(line.nearest);
    proof.slack = static_cast<float>(std::max(0.0, bmr_dot(line.line.normal, nearest) - line.line.offset));
    return proof;
}

void WorldRecorder::AddPair(const bmr_world_pair &pair, const WorldRun &run) {
    recording::Pair record;
    record.a = NumberOf(pair.a);
    record.b = NumberOf(pair.b);
    record.contacts = record.polygon_contacts = 1;
    record.asked = 1;
    const auto touches = [&record](const recording::Contact &contact) {
        return contact.bodies == std::array<int, 2>{record.a, record.b};
    };
    if (pair.watch == BMR_WATCH_PASSING ||
        std::any_of(m_frame.touching.begin(), m_frame.touching.end(), touches)) {
        record.touching = 1;
        record.handed_over = 1;
    }
    const recording::Proof proof = ProofOf(pair, run);
    if (proof.kind != "none") {
        record.slack = proof.slack;
        record.proofs.push_back(proof);
    }
    m_frame.pairs.push_back(record);
}

recording::Frame WorldRecorder::Take(const WorldRun &run) {
    AddBodies(run);
    struct Visit {
        WorldRecorder *recorder;
        const WorldRun *run;
    } visit = {this, &run};
    bmr_world_each_pair(
        run.World(),
        [](void *context, const bmr_world_pair *pair) {
            const auto *its = static_cast<const Visit *>(context);
            its->recorder->AddPair(*pair, *its->run);
        },
        &visit);
    std::sort(m_frame.pairs.begin(), m_frame.pairs.end(),
              [](const recording::Pair &x, const recording::Pair &y) {
                  return x.a != y.a ? x.a < y.a : x.b < y.b;
              });
    recording::Frame frame;
    std::swap(frame, m_frame);
    frame.step = m_step++;
    return frame;
}

} // namespace testbed
