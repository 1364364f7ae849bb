// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_REGISTRY_H
#define BOOMERANG_GLUE_PAIR_REGISTRY_H

class b2BlockAllocator;
class b2Body;
struct b2Transform;

namespace bmr {

class SolidContact;
struct BodyPair;

/// @file
/// Which contacts share which structure. There is no table: pairs and hulls are found through the contact
/// lists that Box2D keeps anyway, so they belong to one world, need no lock, and die with it.

/// Gives a new contact (not in Box2D's lists yet) the structure it is to ask, or none. While remembered edges
/// are on, the contacts of two bodies get one when there are enough of them to be worth its hulls; until then
/// an edge each serves them. Contacts that are born as a sensor's get none, also if the sensor turns solid
/// later.
void AttachPair(SolidContact *contact, b2BlockAllocator *allocator);
/// Gives it back.
void DetachPair(SolidContact *contact, b2BlockAllocator *allocator);

/// Does the structure that the contact shares prove its two fixtures apart at these poses? To be asked where
/// state.pair is not nullptr.
bool PairSaysApart(SolidContact *contact, const b2Transform &xfA, const b2Transform &xfB);

/// The stamp that contacts of a pair compare with their own.
unsigned StampOf(const BodyPair &pair);

/// Builds every hull of the body again and forgets what its pairs knew.
void InvalidateBody(b2Body *body);

} // namespace bmr

#endif
