// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_PAIR_REGISTRY_H
#define BOOMERANG_GLUE_PAIR_REGISTRY_H

class b2BlockAllocator;
class b2Body;

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

/// Do the hulls of the contact's pair hold its fixtures as they are now? Some 20 ns.
bool HullsHold(const SolidContact &contact);
/// The same, to be asked when the stamps differ; makes them agree.
bool VerifyStamp(SolidContact *contact);

/// To be called once in each step, ahead of the first question to a pair: builds those of its hulls anew that
/// do not hold all fixtures as they are now. (Vertices may be changed in place. What a listener or a filter
/// changes after that, in the middle of the step, is found by HullsHold.)
void LookAtShapes(const SolidContact &contact);

/// The stamp that contacts of a pair compare with their own.
unsigned StampOf(const BodyPair &pair);

/// Builds every hull of the body again and forgets what its pairs knew.
void InvalidateBody(b2Body *body);

} // namespace bmr

#endif
