// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_VERIFY_H
#define BOOMERANG_GLUE_VERIFY_H

#include <box2d/b2_settings.h>

class b2Contact;
class b2DynamicTree;
class b2Fixture;
struct b2Manifold;
struct b2Pair;

/// @file
/// Mode::Verify. The passes work as in Mode::On. Where Verifying() (settings.h) they hand over here what they
/// have answered, and Box2D is asked the same: of contacts that were updated, of contacts that the loop
/// over contacts passed without an update, and of pairs that were found. Each of these functions counts a
/// comparison; the first difference of the process is described in one line on stderr, the others are
/// counted. From any thread.
///
/// Not seen: times of impact, islands, boxes and the tree.

namespace bmr {

/// A contact is as Box2D's update of it would leave it: the manifold or, of a sensor, whether it touches. To
/// be called before code of the game can change anything.
void VerifyContact(const b2Contact &contact);

/// The pairs of the moved proxies that overlap others, in Box2D's order.
void VerifyPairs(const b2DynamicTree &tree, const int32 *moves, int32 count, const b2Pair *found,
                 int32 foundCount);

/// Two manifolds are the same where both have no points, or all fields that have a meaning agree to the bit
/// (zeros of either sign are equal, and so are numbers that are none). The fixtures name the two in the line;
/// nullptr where they are not known.
void VerifyManifold(const b2Fixture *fixtureA, const b2Fixture *fixtureB, const b2Manifold &ours,
                    const b2Manifold &box2d);
/// `what` of the two, in a few words.
void VerifyAnswer(const char *what, const b2Fixture *fixtureA, const b2Fixture *fixtureB, bool ours,
                  bool box2d);

/// One line on stderr: how many answers were compared and how many differed, also where none was. For
/// CallAtEnd.
void SayVerified();

} // namespace bmr

#endif
