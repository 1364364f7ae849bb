// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_FRAME_H
#define BOOMERANG_TESTBED_FRAME_H

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// @file
/// A world after a step, as what draws it needs it. A worker prints it for `--frames` (PrintFrame), a kinetic
/// world fills it in memory. This header needs neither Box2D nor the plugin.
///
/// Lengths are metres, impulses newton seconds. "Body coordinates" are those of a body's own frame: the
/// world's are pose * point. Bodies and a body's fixtures have the numbers that their stage gave them, in
/// order of creation.

namespace testbed::shown {

struct Vec {
    float x = 0.0f, y = 0.0f;
};

/// x_world = position + (c x - s y, s x + c y).
struct Pose {
    Vec position;
    float c = 1.0f, s = 0.0f;
};
Vec Transform(const Pose &pose, const Vec &point);
/// A direction: turned, not moved.
Vec Rotate(const Pose &pose, const Vec &direction);

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

struct Body {
    int number = 0;
    std::string type; ///< static, kinematic or dynamic
    Pose pose;
    bool asleep = false, disabled = false;
    float disk = 0.0f; ///< of a kinetic world: the radius of the disk about its origin that holds it
};

/// The box of a fixture's child in the broad phase (fattened); of a kinetic world, a body's cell.
struct Box {
    float left = 0.0f, bottom = 0.0f, right = 0.0f, top = 0.0f;
};

/// A joint, in the world: from the first body's origin over both anchors to the second body's.
struct Joint {
    std::array<Vec, 4> line;
};

/// A point of a touching contact's manifold, in the world.
struct ContactPoint {
    Vec at;
    float impulse = 0.0f; ///< along the normal, of the last solver iteration
};

/// Two fixtures that touch.
struct Contact {
    std::array<int, 2> bodies = {0, 0};
    Vec normal; ///< from the first to the second
    std::vector<ContactPoint> points;
};

/// What proves two bodies, or two of their fixtures, apart at the poses of the frame. Element 0 of arrays of
/// two is of the pair's `a`, element 1 of its `b`; each in the coordinates of its own body.
///
///   kind             says                                     uses
///   none             nothing: the contact touches, or the     -
///                    proof was not found
///   remembered-edge  an edge of one fixture, kept by the      owner, normal, edge, opposite
///                    contact: all of the other lies beyond
///   edge-line        an edge of the owner's envelope at a     owner, normal, edge, opposite
///                    level, and the nearest corner of the
///                    other's
///   direction        a direction, and both supports           owner, normal, supports
///   disks            two bounding disks                       centres, radii
struct Proof {
    std::string kind = "none";
    int contacts = 1;            ///< how many contacts of the pair this proof serves
    float slack = 0.0f;          ///< certified: at least so far apart, skins (radii) not subtracted
    int owner = 0;               ///< 0: the line is a's; 1: it is b's
    Vec normal;                  ///< owner's coordinates, unit length, out of the owner
    std::array<Vec, 2> edge;     ///< owner's coordinates: the edge's ends
    Vec opposite;                ///< the other's coordinates: its vertex or corner nearest to the line
    std::array<Vec, 2> supports; ///< the vertices farthest along the direction
    std::array<Vec, 2> centres;
    std::array<float, 2> radii = {0.0f, 0.0f};
};

/// Two bodies with a contact (their fixtures' boxes overlap). a < b.
struct Pair {
    int a = 0, b = 0;
    int contacts = 0;         ///< between solid fixtures
    int polygon_contacts = 0; ///< of those, of two polygons: the ones that the plugin answers
    int touching = 0;         ///< of `contacts`, those with a manifold
    /// Closest points of the closest two fixtures of a polygon contact, in the world, and their distance
    /// (b2Distance, radii not subtracted); -1 where there is no polygon contact.
    std::array<Vec, 2> closest;
    float distance = -1.0f;
    std::vector<Proof> proofs; ///< one for each polygon contact, contacts with the same proof together
    int handed_over = 0;       ///< evaluations of its polygon contacts in this step that needed a manifold
};

/// What happened in this step to the certificate of a pair: start, push, stab, roll, coarsen, contact, leave
/// (Options::onEvent in boomerang/box2d_glue.h), or what a kinetic structure calls it.
struct Event {
    std::string kind;
    int a = 0, b = 0;
};

struct Frame {
    std::string scene;
    /// stock, plugin, or off: with the plugin switched off; world: none of Box2D
    std::string program;
    double time = 0.0; ///< of a kinetic world
    /// Sides of a periodic box about the origin, whose bodies are taken back into it; else (0, 0).
    Vec period;
    int64_t step = 0; ///< the first is 0
    std::vector<Body> bodies;
    std::vector<Fixture> fixtures;
    std::vector<Box> boxes;
    std::vector<Joint> joints;
    std::vector<Contact> touching;
    std::vector<Pair> pairs; ///< by a, then b
    std::vector<Event> events;
};

/// `frame {json}`, a line without its end; keys are the members' names.
std::string PrintFrame(const Frame &frame);
/// Throws std::runtime_error, which says what is wrong, on anything that is no such line.
Frame ParseFrame(const std::string &line);

} // namespace testbed::shown

#endif
