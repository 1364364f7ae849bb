// SPDX-License-Identifier: MIT
#include "worlds/world.h"

#include <algorithm>
#include <cmath>

#include "boomerang/distance.h"

namespace testbed {

using shown::Vec;

namespace {

Vec ToVec(bmr_vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

std::vector<Vec> ToVecs(const std::vector<bmr_vec2> &points) {
    std::vector<Vec> list;
    for (const bmr_vec2 &point : points)
        list.push_back(ToVec(point));
    return list;
}

/// A body's only fixture, a polygon.
shown::Fixture PolygonOf(int body, const std::vector<bmr_vec2> &vertices) {
    shown::Fixture fixture;
    fixture.body = body;
    fixture.shape = "polygon";
    fixture.points = ToVecs(vertices);
    return fixture;
}

/// A line that a structure keeps between two polygons at these poses, as a direction with its supports.
shown::Proof LineOf(const bmr_kds_proof &line, const bmr_polygon *const polygons[2],
                    const bmr_pose poses[2]) {
    shown::Proof proof;
    const auto own = static_cast<size_t>(line.owner), other = 1 - own;
    const bmr_vec2 normal = line.line.normal, nearest = bmr_transform(&poses[other], line.nearest);
    const bmr_vec2 seen = bmr_unrotate(&poses[own], bmr_sub(nearest, poses[own].position));
    proof.kind = "direction";
    proof.owner = line.owner;
    proof.normal = ToVec(normal);
    proof.supports[own] = ToVec(polygons[own]->vertices[bmr_polygon_support(polygons[own], normal)]);
    proof.supports[other] = ToVec(line.nearest);
    proof.slack = static_cast<float>(std::max(0.0, bmr_dot(normal, seen) - line.line.offset));
    return proof;
}

} // namespace

int WorldFrames::NumberOf(bmr_body body) const {
    return static_cast<int>(bmr_is_wall(body) ? m_setup.bodies.size() + (body - BMR_WALL(0)) : body);
}

bmr_vec2 WorldFrames::Wrapped(bmr_vec2 position) const {
    if (m_setup.choice.boundary != BMR_PERIODIC)
        return bmr_vec2_make(0.0, 0.0);
    const bmr_vec2 box = bmr_sub(m_setup.high, m_setup.low), at = bmr_sub(position, m_setup.low);
    return bmr_vec2_make(box.x * std::floor(at.x / box.x), box.y * std::floor(at.y / box.y));
}

void WorldFrames::Add(const bmr_contact &contact) {
    shown::Contact record;
    record.bodies = {NumberOf(contact.a), NumberOf(contact.b)};
    record.normal = ToVec(contact.normal);
    for (size_t i = 0; i < contact.count; ++i) {
        shown::ContactPoint point;
        point.at = ToVec(bmr_sub(contact.points[i], Wrapped(contact.points[i])));
        record.points.push_back(point);
    }
    m_frame.touching.push_back(record);
}

void WorldFrames::Add(const bmr_world_event &event) {
    if (event.b == BMR_NO_BODY || bmr_is_wall(event.b))
        return;
    shown::Event record;
    record.kind = event.kind == BMR_WORLD_NEAR || event.kind == BMR_WORLD_REPAIR
                      ? bmr_kds_event_name(event.report.kind)
                      : bmr_world_event_name(event.kind);
    record.a = NumberOf(event.a);
    record.b = NumberOf(event.b);
    m_frame.events.push_back(record);
}

void WorldFrames::AddWalls() {
    if (m_setup.choice.boundary != BMR_WALLED)
        return;
    const Vec low = ToVec(m_setup.low), high = ToVec(m_setup.high);
    const std::array<std::array<Vec, 2>, BMR_WALLS> sides = {{{{{low.x, low.y}, {low.x, high.y}}},
                                                              {{{high.x, low.y}, {high.x, high.y}}},
                                                              {{{low.x, low.y}, {high.x, low.y}}},
                                                              {{{low.x, high.y}, {high.x, high.y}}}}};
    for (unsigned side = 0; side < BMR_WALLS; ++side) {
        shown::Body body;
        body.number = NumberOf(BMR_WALL(side));
        body.type = "static";
        // Its frame is at the middle of its side.
        body.pose.position = {0.5f * (sides[side][0].x + sides[side][1].x),
                              0.5f * (sides[side][0].y + sides[side][1].y)};
        m_frame.bodies.push_back(body);
        shown::Fixture fixture;
        fixture.body = body.number;
        fixture.shape = "edge";
        for (const Vec &end : sides[side])
            fixture.points.push_back({end.x - body.pose.position.x, end.y - body.pose.position.y});
        m_frame.fixtures.push_back(fixture);
    }
}

void WorldFrames::AddBodies(const WorldRun &run) {
    for (size_t i = 0; i < m_setup.bodies.size(); ++i) {
        const bmr_body_state state = run.StateOf(i);
        shown::Body body;
        body.number = static_cast<int>(i);
        body.type = "dynamic";
        body.pose = {ToVec(bmr_sub(state.pose.position, Wrapped(state.pose.position))),
                     static_cast<float>(state.pose.c), static_cast<float>(state.pose.s)};
        body.disk = static_cast<float>(state.radius);
        m_frame.bodies.push_back(body);
        const Vec low = ToVec(state.cell_low), high = ToVec(state.cell_high);
        if (low.x < high.x)
            m_frame.boxes.push_back({low.x, low.y, high.x, high.y});
        m_frame.fixtures.push_back(PolygonOf(body.number, m_setup.bodies[i].polygon->Vertices()));
    }
    AddWalls();
}

/// Where a pair's other body is, beside A.
bmr_pose WorldFrames::OtherPose(const bmr_world_pair &pair, const WorldRun &run) const {
    bmr_pose pose = run.StateOf(pair.b).pose;
    pose.position = bmr_add(pose.position, pair.image);
    return pose;
}

shown::Proof WorldFrames::DisksProof(const bmr_world_pair &pair, const WorldRun &run) const {
    shown::Proof proof;
    const bmr_body_state a = run.StateOf(pair.a);
    const double radius = run.StateOf(pair.b).radius;
    const bmr_vec2 way = bmr_sub(OtherPose(pair, run).position, a.pose.position);
    proof.kind = "disks";
    proof.radii = {static_cast<float>(a.radius), static_cast<float>(radius)};
    proof.slack = static_cast<float>(std::max(0.0, std::hypot(way.x, way.y) - a.radius - radius));
    return proof;
}

shown::Proof WorldFrames::LineProof(const bmr_world_pair &pair, const WorldRun &run) const {
    bmr_kds_proof line;
    if (pair.kds == nullptr || !bmr_kds_get_proof(pair.kds, &line))
        return {};
    // The body born first is the structure's A, and the pair's.
    const bmr_body_state a = run.StateOf(pair.a), b = run.StateOf(pair.b);
    const bmr_polygon *const polygons[] = {a.shape->polygon, b.shape->polygon};
    const bmr_pose poses[] = {a.pose, OtherPose(pair, run)};
    return LineOf(line, polygons, poses);
}

/// None where the two are shown on different sides of a periodic box.
shown::Proof WorldFrames::ProofOf(const bmr_world_pair &pair, const WorldRun &run) const {
    const bmr_vec2 a = Wrapped(run.StateOf(pair.a).pose.position),
                   b = bmr_add(Wrapped(run.StateOf(pair.b).pose.position), pair.image), off = bmr_sub(b, a);
    if (std::hypot(off.x, off.y) > 0.5 * (m_setup.high.x - m_setup.low.x))
        return {};
    return pair.watch == BMR_WATCH_DISKS ? DisksProof(pair, run) : LineProof(pair, run);
}

/// Where a pair is to be shown: between the two.
void WorldFrames::SetClosest(const bmr_world_pair &pair, const WorldRun &run, shown::Pair *record) const {
    const bmr_body_state a = run.StateOf(pair.a);
    const bmr_vec2 shown = Wrapped(a.pose.position);
    const bmr_pose b = OtherPose(pair, run);
    bmr_closest_points closest = {};
    Require(bmr_distance(a.shape->polygon, &a.pose, run.StateOf(pair.b).shape->polygon, &b, &closest),
            "a pair");
    if (!(closest.distance > 0.0))
        closest.point_a = closest.point_b = bmr_scale(0.5, bmr_add(a.pose.position, b.position));
    record->closest = {ToVec(bmr_sub(closest.point_a, shown)), ToVec(bmr_sub(closest.point_b, shown))};
    record->distance = static_cast<float>(std::max(0.0, closest.distance));
}

void WorldFrames::AddPair(const bmr_world_pair &pair, const WorldRun &run) {
    shown::Pair record;
    record.a = NumberOf(pair.a);
    record.b = NumberOf(pair.b);
    record.contacts = record.polygon_contacts = 1;
    const auto touches = [&record](const shown::Contact &contact) {
        return contact.bodies == std::array<int, 2>{record.a, record.b};
    };
    if (pair.watch == BMR_WATCH_PASSING ||
        std::any_of(m_frame.touching.begin(), m_frame.touching.end(), touches)) {
        record.touching = 1;
        record.handed_over = 1;
    }
    SetClosest(pair, run, &record);
    const shown::Proof proof = ProofOf(pair, run);
    if (proof.kind != "none")
        record.proofs.push_back(proof);
    m_frame.pairs.push_back(record);
}

shown::Frame WorldFrames::Take(const WorldRun &run) {
    AddBodies(run);
    struct Visit {
        WorldFrames *recorder;
        const WorldRun *run;
    } visit = {this, &run};
    bmr_world_each_pair(
        run.World(),
        [](void *context, const bmr_world_pair *pair) {
            const auto *its = static_cast<const Visit *>(context);
            if (!bmr_is_wall(pair->b))
                its->recorder->AddPair(*pair, *its->run);
        },
        &visit);
    std::sort(m_frame.pairs.begin(), m_frame.pairs.end(),
              [](const shown::Pair &x, const shown::Pair &y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    shown::Frame frame;
    std::swap(frame, m_frame);
    frame.scene = m_setup.choice.scene;
    frame.program = "world";
    frame.step = m_step++;
    frame.time = run.Time();
    if (m_setup.choice.boundary == BMR_PERIODIC)
        frame.period = ToVec(bmr_sub(m_setup.high, m_setup.low));
    return frame;
}

} // namespace testbed
