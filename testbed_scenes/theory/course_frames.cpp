// SPDX-License-Identifier: MIT
#include "theory/course.h"

#include <algorithm>
#include <cmath>

#include "boomerang/distance.h"
#include "theory/figure.h"

namespace testbed {

shown::Vec ToVec(bmr_vec2 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

std::vector<shown::Vec> ToVecs(const std::vector<bmr_vec2> &points) {
    std::vector<shown::Vec> list;
    for (const bmr_vec2 &point : points)
        list.push_back(ToVec(point));
    return list;
}

shown::Fixture PolygonOf(int body, const std::vector<bmr_vec2> &vertices) {
    shown::Fixture fixture;
    fixture.body = body;
    fixture.shape = "polygon";
    fixture.points = ToVecs(vertices);
    return fixture;
}

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

namespace {

class CourseFrames {
public:
    CourseFrames(const Course &course, const bmr_kds_info &structure, int64_t steps)
        : m_course(course), m_structure(structure), m_steps(steps),
          m_simulation(nullptr, bmr_simulation_destroy) {
        bmr_simulation_def def = bmr_default_simulation_def();
        def.structure = &structure;
        def.kds = DefFor(course);
        const bmr_shape shapes[] = {course.BodyOf(0).Shape(), course.BodyOf(1).Shape()};
        bmr_motion *const motions[] = {course.AsCourse().motions[0], course.AsCourse().motions[1]};
        bmr_simulation *made = nullptr;
        Require(bmr_simulation_create(&def, shapes, motions, 2, course.From(), OnEvent, this, nullptr, &made),
                structure.name);
        m_simulation.reset(made);
    }

    /// The frames come in order, the first is 0.
    shown::Frame Take(int64_t step) {
        const double time = step == m_steps ? m_course.Until()
                                            : m_course.From() + (m_course.Until() - m_course.From()) *
                                                                    static_cast<double>(step) /
                                                                    static_cast<double>(m_steps);
        Require(bmr_simulation_run(m_simulation.get(), time), m_structure.name);
        m_frame.program = "world";
        m_frame.step = step;
        m_frame.time = time;
        for (int i = 0; i < 2; ++i)
            AddBody(i, bmr_motion_pose(m_course.Motion(i), time, nullptr, nullptr));
        AddPair();
        shown::Frame taken;
        std::swap(taken, m_frame);
        return taken;
    }

private:
    static void OnEvent(void *context, const bmr_simulation_event *event) {
        shown::Event record;
        record.kind = bmr_kds_event_name(event->report.kind);
        record.b = 1;
        static_cast<CourseFrames *>(context)->m_frame.events.push_back(record);
    }

    void AddBody(int number, const bmr_pose &pose) {
        m_poses[number] = pose;
        shown::Body body;
        body.number = number;
        body.type = "dynamic";
        const bmr_vec2 along = bmr_rotate(&pose, bmr_vec2_make(1.0, 0.0));
        body.pose = {ToVec(pose.position), static_cast<float>(along.x), static_cast<float>(along.y)};
        m_frame.bodies.push_back(body);
        m_frame.fixtures.push_back(PolygonOf(number, m_course.BodyOf(number).Vertices()));
    }

    void AddPair() {
        shown::Pair pair;
        pair.b = 1;
        pair.contacts = pair.polygon_contacts = 1;
        bmr_closest_points closest = {};
        Require(bmr_distance(m_course.BodyOf(0).Polygon(), &m_poses[0], m_course.BodyOf(1).Polygon(),
                             &m_poses[1], &closest),
                "the distance");
        pair.closest = {ToVec(closest.point_a), ToVec(closest.point_b)};
        pair.distance = static_cast<float>(closest.distance);
        bmr_kds_proof proof;
        if (bmr_kds_get_proof(bmr_simulation_pair(m_simulation.get(), 0, nullptr, nullptr), &proof)) {
            pair.proofs.push_back(Shown(proof));
        } else {
            pair.handed_over = 1;
            pair.touching = closest.distance > 0.0 ? 0 : 1;
        }
        m_frame.pairs.push_back(pair);
    }

    shown::Proof Shown(const bmr_kds_proof &line) {
        const bmr_polygon *const polygons[] = {m_course.BodyOf(0).Polygon(), m_course.BodyOf(1).Polygon()};
        shown::Proof proof = LineOf(line, polygons, m_poses);
        if (m_structure.hierarchy >= 0)
            AddEnvelopes(line, &proof);
        return proof;
    }

    /// The line of a structure with a hierarchy is one of an edge of its owner's envelope.
    void AddEnvelopes(const bmr_kds_proof &line, shown::Proof *proof) {
        std::vector<bmr_vec2> envelopes[2];
        for (int i = 0; i < 2; ++i) {
            const bmr_hierarchy *its =
                m_course.BodyOf(i).Hierarchy(static_cast<bmr_hierarchy_kind>(m_structure.hierarchy));
            const auto level = static_cast<uint32_t>(std::max(line.level, 0));
            envelopes[i] = Envelope(its, std::min(level, bmr_hierarchy_depth(its)));
            m_frame.outlines.push_back({i + 1, i, ToVecs(envelopes[i])});
        }
        proof->envelopes = {1, 2};
        const std::vector<bmr_vec2> &corners = envelopes[line.owner];
        const double near = 1e-9 * m_course.Diameter();
        const auto isOnLine = [&](bmr_vec2 point) {
            return std::fabs(bmr_dot(line.line.normal, point) - line.line.offset) <= near;
        };
        for (size_t i = 0; i < corners.size(); ++i) {
            const bmr_vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
            if (!isOnLine(a) || !isOnLine(b))
                continue;
            proof->kind = "edge-line";
            proof->edge = {ToVec(a), ToVec(b)};
            proof->opposite = ToVec(line.nearest);
            return;
        }
    }

    const Course &m_course;
    const bmr_kds_info &m_structure;
    const int64_t m_steps;
    shown::Frame m_frame; ///< in the making; events come into it while the simulation runs
    bmr_pose m_poses[2] = {};
    std::unique_ptr<bmr_simulation, decltype(&bmr_simulation_destroy)> m_simulation;
};

} // namespace

void VisitFrames(const Course &course, const bmr_kds_info &structure, int64_t steps,
                 const std::function<void(const shown::Frame &)> &onFrame) {
    CourseFrames frames(course, structure, steps);
    for (int64_t step = 0; step <= steps; ++step)
        onFrame(frames.Take(step));
}

} // namespace testbed
