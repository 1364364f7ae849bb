// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_INSPECT_H
#define BOOMERANG_INSPECT_H

#include <cstdint>

#include <box2d/b2_math.h>

#include "boomerang/box2d_glue.h"

class b2Contact;
class b2Fixture;

/// @file
/// Looking at what is known: which line proves two bodies apart, and by how much. For pictures, debuggers and
/// tests; nothing here changes the simulation. Between steps, from the thread that steps. Games include
/// boomerang/box2d.h.

namespace bmr {

/// The kind of a proof.
enum class ProofKind : int32_t {
    None,           ///< nothing is proved: the contact touches, or is not the plugin's
    Disks,          ///< two bounding disks
    EdgeLine,       ///< an edge of one hull's envelope, and the nearest corner of the other's
    Direction,      ///< a direction, and the vertices of both hulls that are farthest along it
    RememberedEdge, ///< an edge of one fixture, remembered by the contact, and all of the other fixture
    Count
};
/// "none", "disks", "edge-line", "direction", "remembered-edge"; nullptr for anything else.
BMR_BOX2D_API const char *NameOf(ProofKind kind);

/// One of the two bodies of a proof. Points and directions are in the body's own frame, lengths in length
/// units.
struct ProofSide {
    const b2Body *body = nullptr;
    const b2Fixture *fixture = nullptr; ///< what the proof is about; nullptr: the hull of all its polygons
    /// The vertex or corner nearest to the other body along the proof's direction; of Disks the centre. Where
    /// this side owns an edge it is one of the edge's ends.
    b2Vec2 support = {0.0f, 0.0f};
    /// Of a Direction, if the other side owns the line: the two points that represent this side while the
    /// direction turns. Else both are the support.
    b2Vec2 window[2] = {{0.0f, 0.0f}, {0.0f, 0.0f}};
    float diskRadius = 0.0f; ///< of Disks
};

/// Why the two fixtures of a contact are known to be apart at their bodies' present poses.
struct Proof {
    ProofKind kind = ProofKind::None;
    ProofSide a, b;        ///< of the contact's fixtures A and B
    bool ownerIsB = false; ///< whose the line is
    int32_t level = 0;     ///< EdgeLine: of the hierarchies; 0 is the bounding rectangle
    /// Unit length, out of the owner, in the owner's frame. Zero for Disks.
    b2Vec2 normal = {0.0f, 0.0f};
    /// EdgeLine and RememberedEdge: its ends, counter-clockwise, in the owner's frame.
    b2Vec2 edge[2] = {{0.0f, 0.0f}, {0.0f, 0.0f}};
    /// A lower bound of the distance, as CertifiedSlack has it (radii not subtracted); 0 where kind is None,
    /// or where a remembered edge is so far from the origin that rounding leaves nothing.
    float slack = 0.0f;
    /// True: the last evaluation left this proof, and it still holds. False: an evaluation would find this
    /// proof now.
    bool remembered = false;
    /// The proof's kinetic structure, the same for all contacts that share it; nullptr for a RememberedEdge.
    /// Compare it, or call InspectHull before the world changes.
    const void *structure = nullptr;
};

/// The proof that the next evaluation of this contact would end with if its bodies stayed where they are.
/// None for a contact that touched at its last evaluation, that is a sensor's, or that is not of two
/// polygons. O(1) where what is remembered holds, else what a repair costs.
BMR_BOX2D_API Proof Inspect(const b2Contact &contact);

/// The least slack of the proofs of all contacts between solid polygons of two bodies, with its proof: a
/// proof of kind None if one of them has none, or if there is no such contact. O(contacts of bodyA).
BMR_BOX2D_API Proof Inspect(const b2Body *bodyA, const b2Body *bodyB);

/// A level past every hierarchy's deepest: the hull itself.
constexpr int32_t kHullLevel = INT32_MAX;

/// The hull that a proof's structure keeps for one of its two sides, or an envelope of its hierarchy, in the
/// body's frame, counter-clockwise. Fills up to `capacity` vertices and returns how many there are: 0 where
/// the proof has no structure. Without a hierarchy (the free direction needs none) every level is the hull.
/// Call it before the world changes. O(n).
BMR_BOX2D_API int32_t InspectHull(const Proof &proof, bool ofB, int32_t level, b2Vec2 *vertices,
                                  int32_t capacity);

} // namespace bmr

#endif
