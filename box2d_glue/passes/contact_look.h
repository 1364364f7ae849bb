// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_LOOK_H
#define BOOMERANG_GLUE_CONTACT_LOOK_H

#include <box2d/b2_body.h>
#include <box2d/b2_contact_manager.h>

class b2Contact;
class b2ContactListener;

/// @file
/// What b2ContactManager::Collide asks and does of one contact.

namespace bmr {

inline bool IsActive(const b2Body *body) {
    return body->IsAwake() && body->GetType() != b2_staticBody;
}

/// Do the fat boxes of the two still overlap?
bool BoxesOverlap(b2ContactManager *manager, const b2Contact &contact);

/// b2Contact::Update: makes the manifold, by a contact of ours if it is one, and calls the listener.
void UpdateContact(b2Contact *contact, b2ContactListener *listener);

} // namespace bmr

#endif
