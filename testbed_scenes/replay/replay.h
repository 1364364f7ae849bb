// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_REPLAY_H
#define BOOMERANG_TESTBED_REPLAY_H

#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

/// @file
/// What the page of `boomerang-testbed replay` plays, as plain data: who fills it need not know the page, and
/// the page's encoding (encoding.h) need not know how a scene is run. Lengths are Box2D's, angles radians;
/// steps count from 0, and what is said of a step holds after it.

namespace testbed::replay {

struct Point {
    double x = 0.0, y = 0.0;
};
inline bool operator==(const Point &a, const Point &b) {
    return a.x == b.x && a.y == b.y;
}

enum class ShapeKind : int32_t { Polygon, Circle, Chain };

/// A fixture, in its body's frame. A circle's only point is its centre.
struct Shape {
    ShapeKind kind = ShapeKind::Polygon;
    bool sensor = false;
    double radius = 0.0;
    std::vector<Point> points;
};

enum class BodyType : int32_t { Static, Kinematic, Dynamic };

/// Bits of Pose::flags.
constexpr int32_t kAwake = 1, kEnabled = 2;

struct Pose {
    double x = 0.0, y = 0.0, angle = 0.0;
    int32_t flags = kAwake | kEnabled;
};

/// A body while its fixtures stay what they are: where a scene changes them, a second one with the same
/// number follows.
struct Body {
    int32_t number = 0;
    BodyType type = BodyType::Dynamic;
    bool bullet = false;
    std::vector<Shape> shapes;
    int32_t firstStep = 0;
    std::vector<Pose> poses; ///< of firstStep, firstStep + 1, ..
};

/// A convex polygon around a body that proofs speak of: its hull, or an envelope of it. Body's frame.
struct Outline {
    int32_t body = 0; ///< its number
    std::vector<Point> points;
};

/// What answered for a pair in a step; of several answers, the dearest.
enum class Answer : uint8_t {
    Unasked,   ///< nobody asked the plugin: both sleep, or the contact is none of its own
    Apart,     ///< proved apart
    Manifold,  ///< the plugin found the contact points
    HandedOver ///< Box2D's own test ran
};

/// How one pair stood after one step.
struct PairStep {
    float slack = -1.0f; ///< certified distance, a lower bound; 0: nothing is proved; negative: not known
    Answer answer = Answer::Unasked;
    bool touching = false; ///< there is a contact point
    // Calls of Box2D's own functions in a stock run of the same scene, in this step; at most 65535 are
    // kept.
    uint16_t stockPolygonTests = 0, stockToi = 0, stockOverlaps = 0;
};

/// Two bodies while they have a contact; a pair that parts and comes back has several of these.
struct Pair {
    int32_t a = 0, b = 0; ///< numbers, a < b
    int32_t firstStep = 0;
    std::vector<PairStep> steps;
};

enum class ProofKind : int32_t { RememberedEdge, EdgeLine, Direction, Disks };

/// One proof of a pair. `owner` 0: the line is a's, 1: b's. Points are in body frames.
struct Proof {
    ProofKind kind = ProofKind::RememberedEdge;
    int32_t owner = 0, level = 0;
    double angle = 0.0; ///< of the line's normal, in the owner's frame
    std::array<Point, 2>
        line;       ///< the edge, or the support vertex twice, in the owner's frame; disks: a's centre
    Point opposite; ///< the point of the other nearest to the line; disks: b's centre
    std::array<double, 2> radii = {0.0, 0.0}; ///< of disks
    std::array<int32_t, 2> hulls = {-1, -1},
                           envelopes = {-1, -1}; ///< of a and b, indices of Replay::outlines
};

inline bool operator==(const Proof &a, const Proof &b) {
    const auto members = [](const Proof &proof) {
        return std::tie(proof.kind, proof.owner, proof.level, proof.angle, proof.line, proof.opposite,
                        proof.radii, proof.hulls, proof.envelopes);
    };
    return members(a) == members(b);
}

/// The proofs that a pair has from `step` on, until its next Certificate. None: it is not proved apart.
struct Certificate {
    int32_t pair = 0, step = 0; ///< `pair` indexes Replay::pairs
    std::vector<Proof> proofs;
};

/// Something that happened to a pair.
struct Event {
    int32_t a = 0, b = 0; ///< numbers, a < b
    int32_t step = 0;
    int32_t kind = 0; ///< indexes Replay::eventKinds
    int32_t levelBefore = 0, levelAfter = 0;
    double gap = 0.0; ///< certified after the event, 0 if none
};

/// A point of a manifold while it exists.
struct ContactPoint {
    int32_t firstStep = 0;
    std::vector<Point> at;
};

/// A segment that Box2D draws of a joint, while there is one.
struct JointSegment {
    int32_t firstStep = 0;
    std::vector<std::pair<Point, Point>> ends;
};

/// A box of the broad phase, from `step` on until `end` (exclusive).
struct Box {
    std::array<int32_t, 3> of = {0, 0, 0}; ///< body, fixture, child; by these they are sorted, then by step
    int32_t step = 0, end = 0;
    Point low, high;
};

/// Calls of Box2D's own functions in one step of a run.
struct Calls {
    int64_t polygonTests = 0, toi = 0, distance = 0, overlaps = 0;
};

struct Replay {
    /// What the page says in words, and the totals it shows: see PageOf.
    nlohmann::json about;
    int32_t stepCount = 0;
    std::vector<std::string> eventKinds;
    std::vector<Body> bodies;
    std::vector<Outline> outlines;
    std::vector<Pair> pairs;               ///< sorted by a, b, first step
    std::vector<Certificate> certificates; ///< sorted by pair, then step
    std::vector<Event> events;             ///< by step; within a step as they happened
    std::vector<ContactPoint> contacts;
    std::vector<JointSegment> joints;
    std::vector<Box> boxes;
    std::vector<Calls> stockCalls, pluginCalls; ///< by step; empty where they were not counted
};

} // namespace testbed::replay

#endif
