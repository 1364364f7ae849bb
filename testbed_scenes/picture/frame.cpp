// SPDX-License-Identifier: MIT
#include "picture/frame.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

namespace testbed::shown {
namespace {

constexpr char kPrefix[] = "frame ";

} // namespace

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Vec, x, y)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pose, position, c, s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Fixture, body, number, shape, points, radius, sensor, inner)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Body, number, type, pose, asleep, disabled, disk)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Box, left, bottom, right, top)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Joint, line)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ContactPoint, at, impulse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Contact, bodies, normal, points)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Proof, kind, contacts, slack, owner, normal, edge, opposite, supports,
                                   centres, radii)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Pair, a, b, contacts, polygon_contacts, touching, closest, distance,
                                   proofs, handed_over)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Event, kind, a, b)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Frame, scene, program, time, period, step, bodies, fixtures, boxes, joints,
                                   touching, pairs, events)

Vec Transform(const Pose &pose, const Vec &point) {
    const Vec turned = Rotate(pose, point);
    return {pose.position.x + turned.x, pose.position.y + turned.y};
}

Vec Rotate(const Pose &pose, const Vec &direction) {
    return {pose.c * direction.x - pose.s * direction.y, pose.s * direction.x + pose.c * direction.y};
}

std::string PrintFrame(const Frame &frame) {
    return kPrefix + nlohmann::json(frame).dump();
}

Frame ParseFrame(const std::string &line) {
    try {
        return nlohmann::json::parse(line.substr(sizeof kPrefix - 1)).get<Frame>();
    } catch (const nlohmann::json::exception &error) {
        throw std::runtime_error("a frame cannot be read: " + std::string(error.what()));
    }
}

} // namespace testbed::shown
