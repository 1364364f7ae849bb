// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_CONTACT_LOOK_H
#define BOOMERANG_GLUE_CONTACT_LOOK_H

#include <box2d/b2_body.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_contact_manager.h>
#include <box2d/b2_world_callbacks.h>

#include "glue/contact_access.h"

class b2Contact;

/// @file
/// What passes ask and do of one contact.

namespace bmr {

inline bool IsActive(const b2Body *body) {
    return body->IsAwake() && body->GetType() != b2_staticBody;
}

/// Do the fat boxes of the two still overlap?
bool BoxesOverlap(b2ContactManager *manager, const b2Contact &contact);

/// What an update changed, for TellListener.
struct ContactChange {
    bool touched, touches; ///< before, and behind it
    bool isSensor;         ///< one of the two fixtures is
    b2Manifold old;        ///< the manifold before, if the two touch
};

/// b2Contact::Update of any contact, but for the calls of the listener: the same manifold, impulses and
/// flags, and bodies are woken where it wakes them. TellListener comes next.
ContactChange UpdateContact(b2Contact *contact);

/// The calls of b2Contact::Update. `beforeGame()` is called ahead of each one that runs code of the game. Was
/// there any? `listener`: of the moment ahead of the update. If it replaces itself in BeginContact, PreSolve
/// is still its own.
template <typename BeforeGame>
bool TellListener(b2ContactListener *listener, b2Contact *contact, const ContactChange &change,
                  BeforeGame beforeGame) {
    if (listener == nullptr || !(change.touched || change.touches))
        return false;
    const bool preSolves = change.touches && !change.isSensor && HasOwnPreSolve(*listener);
    if (change.touched == change.touches && !preSolves)
        return false;
    const bool isOfGame = IsOfGame(listener);
    const auto before = [&] {
        if (isOfGame)
            beforeGame();
    };
    if (change.touches && !change.touched) {
        before();
        listener->BeginContact(contact);
    }
    if (change.touched && !change.touches) {
        before();
        listener->EndContact(contact);
    }
    if (preSolves) {
        before();
        listener->PreSolve(contact, &change.old);
    }
    AskRoundingAgain();
    return isOfGame;
}

} // namespace bmr

#endif
