// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_PROOFS_H
#define BOOMERANG_TESTBED_PICTURE_PROOFS_H

#include <array>
#include <map>
#include <string>
#include <vector>

#include "picture/picture.h"
#include "picture/world_view.h"

/// @file
/// Why pairs are known to be apart. `unit` is one point of a picture 1200 wide.

namespace testbed {

/// A pair that is explained by itself: its number in the picture, and where that is to stand (on the page).
struct Explained {
    int number = 0;
    const shown::Pair *pair = nullptr;
    /// The least slack of its proofs; nullptr where nothing proves it apart.
    const shown::Proof *proof = nullptr;
    bmr_vec2 place = {0.0, 0.0};
    std::array<bmr_vec2, 2> ends = {}; ///< of the gap, on the page: a's and b's
};

/// The proof that bounds a pair's slack; nullptr if one of its contacts has none, or with stock.
const shown::Proof *WeakestProof(const shown::Pair &pair);

/// The pairs of the bodies in focus.
struct Explanation {
    /// Those that do not touch (two bodies' own in any case), in the region, the closest first, up to a
    /// number.
    std::vector<Explained> pairs;
    std::vector<const shown::Pair *> touching; ///< the others that touch
    std::vector<const shown::Pair *> alone;    ///< apart, but not of two polygons: Box2D's alone
    int rest = 0;                              ///< how many more there are, or are not in the region
};
Explanation Explain(const WorldView &world, const PictureOptions &options, const Rectangle &region, int most);

/// "all of body 7 lies beyond an edge of body 12": why, in a line.
std::string ReasonOf(const Explained &explained);

/// Hulls and envelopes that proofs of pairs (of the bodies in focus, if any) use, each once.
void DrawOutlines(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// Every proof as a short stroke across its gap, with its edge; with bodies in focus those of pairs that
/// touch elsewhere.
void DrawProofs(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// In full: the line with its edge and the vertex opposite, the direction, or the disks. Sets place and ends.
void DrawExplained(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit,
                   Explained *explained);
/// A diamond at each pair that needed a manifold; a dashed stroke first, where it does not touch.
void DrawHandedOver(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// A ring at each pair to whose certificate something happened in the step.
void DrawEvents(Canvas &canvas, const WorldView &world, const PictureOptions &options, double unit);
/// What that was, by its name in the paper, and how often.
std::map<std::string, std::size_t> EventsInFocus(const WorldView &world, const PictureOptions &options);

/// Is the pair one of those that the bodies in focus are about? All are, without any.
bool IsInFocus(const PictureOptions &options, const shown::Pair &pair);

} // namespace testbed

#endif
