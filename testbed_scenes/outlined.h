// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_OUTLINED_H
#define BOOMERANG_TESTBED_OUTLINED_H

#include <memory>
#include <vector>

#include "polygon_choice.h"
#include "shapes.h"

/// @file
/// The same world with concave bodies in two ways: cut into few convex pieces that know their seams, or into
/// triangles. (The worlds are not the same, so their bits are not comparable; any_size.h.)

namespace testbed {

/// An outline, and triangles that it can be cut into.
struct Concave {
    Outline ring; ///< the outer one
    std::vector<Outline> holes;
    std::vector<Outline> triangles;
};

/// An outline that is star-shaped about the origin.
Concave StarShaped(const Outline &outline);

/// An outline as `kind` asks for it, made once and put on as many bodies as there are.
class OutlinedBody {
public:
    /// Pieces within `tolerance` of the outline. Throws std::runtime_error where this worker has none.
    OutlinedBody(BodyKind kind, const Concave &concave, float tolerance = 0.0f);

    void AddTo(Stage &stage, b2Body *body, const b2FixtureDef &def) const;

private:
    std::vector<std::unique_ptr<b2Shape>> m_pieces;
};

/// The pieces of an outline that know their seams. Each worker has its own; stock's throws
/// std::runtime_error.
std::vector<std::unique_ptr<b2Shape>> MakeOutlinePieces(const Concave &concave, float tolerance);
/// Of a fixture's polygon: the edges behind which another piece goes on.
std::vector<int> InnerEdgesOf(const b2Fixture &fixture);

} // namespace testbed

#endif
