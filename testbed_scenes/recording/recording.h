// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_RECORDING_H
#define BOOMERANG_TESTBED_RECORDING_H

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// @file
/// A run as data: what a worker prints for `--record FIRST:LAST:EVERY`, so that pictures, pages and reports
/// can show worlds that their program does not hold. This header is the contract of both ends, and needs
/// neither Box2D nor the plugin.
///
/// A recording is lines. The first is `recording {json}` (Head), then comes `frame {json}` (Frame) for each
/// recorded step, in order; other lines of the worker may stand between. The JSON keys are the members' names
/// below, lists are arrays, a Vec is [x, y], and what has its default value (as below) may be left out.
/// Numbers are floats in their shortest form that reads back to the same bits. Lengths are metres, impulses
/// newton seconds.
///
/// "Body coordinates" are those of a body's own frame: the world's are pose * point. Bodies, joints and a
/// body's fixtures have the numbers that their stage gave them, in order of creation; no number is given
/// twice.

namespace testbed::recording {

constexpr int kVersion = 1;

struct Vec {
    float x = 0.0f, y = 0.0f;
};
inline bool operator==(const Vec &a, const Vec &b) {
    return a.x == b.x && a.y == b.y;
}

/// x_world = position + (c x - s y, s x + c y). [x, y, c, s]
struct Pose {
    Vec position;
    float c = 1.0f, s = 0.0f;
};
Vec Transform(const Pose &pose, const Vec &point);
/// A direction: turned, not moved.
Vec Rotate(const Pose &pose, const Vec &direction);

struct Head {
    int version = 0; ///< kVersion; set by Print
    std::string scene;
    /// stock, plugin, or off: with the plugin told to be off; world: none of Box2D (worlds/record.h)
    std::string program;
    std::string structure; ///< of the plugin: free-direction, lazy-compass, lazy-dudley; of a world: any
    int64_t size = 0;
    uint64_t seed = 0;
    float time_step = 0.0f;
    int64_t first = 0, last = 0, every = 1; ///< the steps with frames: first, first + every, ... <= last
    bool counts_calls =
        false; ///< whether `calls` were counted (they are with the counting library preloaded)
    /// Sides of a periodic box about the origin, whose bodies are taken back into it; else (0, 0).
    Vec period;
};

/// A fixture as it was made. Sent when it first appears, and again when its shape or sensor flag changed.
struct Fixture {
    int body = 0, number = 0;
    std::string shape; ///< polygon, circle, edge or chain
    /// Body coordinates: a polygon's vertices counter-clockwise (any number of them), a circle's centre, an
    /// edge's two ends, a chain's vertices (a loop's first one again at the end).
    std::vector<Vec> points;
    float radius = 0.0f; ///< a circle's; of the others, the skin around them
    bool sensor = false;
    /// Of a piece of an outline: the edges, by the index of the point where they begin, behind which another
    /// piece goes on.
    std::vector<int> inner;
};

/// A body after the step.
struct Body {
    int number = 0;
    std::string type; ///< static, kinematic or dynamic
    Pose pose;
    bool asleep = false, disabled = false, bullet = false;
};

/// The box of a fixture's child in the broad phase (fattened). [body, fixture, child, left, bottom, right,
/// top]
struct Box {
    int body = 0, fixture = 0, child = 0;
    float left = 0.0f, bottom = 0.0f, right = 0.0f, top = 0.0f;
};

/// A joint as Box2D itself draws it, in the world.
struct Joint {
    int number = 0;
    std::string
        type; ///< revolute, prismatic, distance, pulley, mouse, gear, wheel, weld, friction, motor, rope
    std::array<int, 2> bodies = {0, 0};
    std::array<Vec, 2> anchors;
    std::vector<std::array<Vec, 2>> segments; ///< what b2Joint::Draw draws
};

/// A point of a touching contact's manifold, in the world.
struct ContactPoint {
    Vec at;
    float impulse = 0.0f; ///< along the normal, of the last solver iteration
};

/// Two fixtures that touch.
struct Contact {
    std::array<int, 2> bodies = {0, 0}, fixtures = {0, 0};
    Vec normal; ///< from the first to the second
    std::vector<ContactPoint> points;
};

/// A convex polygon of a body that proofs speak of, counter-clockwise, in body coordinates: its hull, or the
/// envelope around the hull at a level of its hierarchy. Sent once, before or in the frame that first names
/// it.
struct Outline {
    int id = 0; ///< 1, 2, ...; 0 is none
    int body = 0;
    std::vector<Vec> points;
};

/// What proves two bodies, or two of their fixtures, apart at the poses of the frame. Element 0 of arrays of
/// two is of the pair's `a`, element 1 of its `b`; each in the coordinates of its own body.
///
///   kind             says                                     uses
///   none             nothing: the contact touches, or the     -
///                    proof was not found
///   remembered-edge  an edge of one fixture, kept by the      fixtures, owner, normal, edge, opposite
///                    contact: all of the other lies beyond
///   edge-line        an edge of the owner's envelope at       owner, level, normal, edge, opposite, hulls,
///                    `level`, and the nearest corner of       envelopes
///                    the other's
///   direction        a direction, and both supports           owner, normal, supports, hulls
///   disks            two bounding disks                       centres, radii, hulls
struct Proof {
    std::string kind = "none";
    std::array<int, 2> fixtures = {-1, -1}; ///< -1: the hull of all the body's polygon fixtures
    int contacts = 1;                       ///< how many contacts of the pair this proof serves
    float slack = 0.0f;          ///< certified: at least so far apart, skins (radii) not subtracted
    int owner = 0;               ///< 0: the line is a's; 1: it is b's
    int level = 0;               ///< of the hierarchies
    Vec normal;                  ///< owner's coordinates, unit length, out of the owner
    std::array<Vec, 2> edge;     ///< owner's coordinates: the edge's ends
    Vec opposite;                ///< the other's coordinates: its vertex or corner nearest to the line
    std::array<Vec, 2> supports; ///< the vertices farthest along the direction
    std::array<Vec, 2> centres;
    std::array<float, 2> radii = {0.0f, 0.0f};
    std::array<int, 2> hulls = {0, 0}, envelopes = {0, 0}; ///< ids of Outlines
};

/// Calls of Box2D's own functions that reached Box2D.
struct Calls {
    int64_t polygon_tests = 0; ///< b2CollidePolygons
    int64_t toi = 0;           ///< b2TimeOfImpact
    int64_t distance = 0;      ///< b2Distance, those from within the other two among them
    int64_t overlap = 0;       ///< b2TestOverlap
};
inline bool IsZero(const Calls &calls) {
    return calls.polygon_tests == 0 && calls.toi == 0 && calls.distance == 0 && calls.overlap == 0;
}

/// Two bodies with a contact (their fixtures' boxes overlap), or for which Box2D was called. a < b.
///
/// Counts "of the frame" are of all steps since the frame before; in the first frame, of its own step.
struct Pair {
    int a = 0, b = 0;
    int contacts = 0;         ///< between solid fixtures
    int polygon_contacts = 0; ///< of those, of two polygons: the ones that the plugin answers
    int touching = 0;         ///< of `contacts`, those with a manifold
    /// Closest points of the closest two fixtures of a polygon contact, in the world, and their distance
    /// (b2Distance, radii not subtracted); -1 where there is no polygon contact.
    std::array<Vec, 2> closest;
    float distance = -1.0f;
    /// The least slack of its proofs, 0 if one is missing; -1 with stock or without a polygon contact.
    float slack = -1.0f;
    std::vector<Proof> proofs; ///< one for each polygon contact, contacts with the same proof together
    /// In packed frames alone (bytes.h): `proofs` is empty, for they are those of the frame before, slack
    /// aside.
    bool proofs_kept = false;
    int64_t asked = 0;       ///< evaluations of its polygon contacts, of the frame
    int64_t handed_over = 0; ///< of those, not proved apart: a manifold was needed, of the frame
    Calls calls;             ///< of the frame
};

/// Something that happened to a pair, since the frame before.
struct Event {
    int64_t step = 0;
    /// start, push, stab, roll, coarsen, contact, leave: of the structure of two hulls, or of a contact
    /// (Options::onEvent in boomerang/box2d_glue.h). begin, end: Box2D's own BeginContact and EndContact.
    std::string kind;
    int a = 0, b = 0;
    int level_before = 0, level_after = 0; ///< of the structure's
    float gap = 0.0f;                      ///< certified after the event
};

/// The world after a step.
struct Frame {
    int64_t step = 0;                     ///< the first is 0
    std::vector<Body> bodies;             ///< all there are: who is missing has been destroyed
    std::vector<Fixture> fixtures;        ///< new or changed since the frame before; in the first frame all
    std::vector<std::array<int, 2>> gone; ///< [body, fixture] destroyed since the frame before
    std::vector<Box> boxes;               ///< with --record-boxes alone
    std::vector<Joint> joints;
    std::vector<Contact> touching;
    std::vector<Outline> outlines; ///< first used in this frame
    std::vector<Pair> pairs;       ///< by (a, b)
    std::vector<Event> events;     ///< in order
    Calls calls;                   ///< of the frame
};

/// One line of a recording, without a line's end. O(size).
std::string Print(const Head &head);
std::string Print(const Frame &frame);

bool IsHead(const std::string &line);
bool IsFrame(const std::string &line);
/// Throw std::runtime_error, which says what is wrong, on anything that is no such line of this version.
Head ParseHead(const std::string &line);
Frame ParseFrame(const std::string &line);

/// What frames send once, gathered as they come: after Add(frame), all that is there in that frame.
struct Gathered {
    std::map<std::pair<int, int>, Fixture> fixtures; ///< by body and number
    std::map<int, Outline> outlines;                 ///< by id

    void Add(const Frame &frame);
};

} // namespace testbed::recording

#endif
