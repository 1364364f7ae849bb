// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_GAME_CALLS_H
#define BOOMERANG_GLUE_GAME_CALLS_H

#include <cstring>

#include <box2d/b2_contact_manager.h>
#include <box2d/b2_world_callbacks.h>

#include "base/private_members.h"
#include "base/rounding_mode.h"
#include "glue/contacts/solid_contact.h"
#include "start/install.h"

/// @file
/// Calls of the game's filter and listener for a contact.

namespace bmr {

/// Is it a listener or a filter of the game's own? Those that worlds begin with are Box2D's, and do nothing.
inline bool IsOfGame(const b2ContactListener *listener) {
    return listener != nullptr && listener != ListenerOfNewWorlds();
}
inline bool IsOfGame(const b2ContactFilter *filter) {
    return filter != nullptr && filter != FilterOfNewWorlds();
}

/// Is the function's first instruction its return? False where the processor's code is not known here.
inline bool ReturnsAtOnce(const void *function) {
#if defined(__x86_64__) && defined(__linux__)
    const unsigned char *code = static_cast<const unsigned char *>(function);
    constexpr unsigned char kBranchTarget[] = {0xf3, 0x0f, 0x1e, 0xfa}, kReturn = 0xc3; // endbr64, ret
    if (std::memcmp(code, kBranchTarget, sizeof kBranchTarget) == 0)
        code += sizeof kBranchTarget;
    return *code == kReturn;
#else
    return function == nullptr;
#endif
}

/// Does a listener's class have a PreSolve of its own (or a PostSolve, below)? Most games listen to
/// BeginContact and EndContact alone, and inherit the others, which do nothing. Read from the tables of
/// virtual functions, which hold two destructors and then, in their order, BeginContact, EndContact, PreSolve
/// and PostSolve. What is inherited is Box2D's function, or the game's copy of it, for it is inline. True if
/// that is not certain.
inline bool HasOwn(const b2ContactListener &listener, int slot) {
    const b2ContactListener *const empty = ListenerOfNewWorlds();
    if (empty == nullptr)
        return true;
    void *const *table, *const *emptyTable;
    std::memcpy(&table, static_cast<const void *>(&listener), sizeof table);
    std::memcpy(&emptyTable, static_cast<const void *>(empty), sizeof emptyTable);
    return table[slot] != emptyTable[slot] && !ReturnsAtOnce(table[slot]);
}
inline bool HasOwnPreSolve(const b2ContactListener &listener) {
    return HasOwn(listener, 4);
}
inline bool HasOwnPostSolve(const b2ContactListener &listener) {
    return HasOwn(listener, 5);
}
/// The listener if its PostSolve is to be called, else nullptr.
inline b2ContactListener *PostSolveListener(b2ContactListener *listener) {
    return listener != nullptr && HasOwnPostSolve(*listener) ? listener : nullptr;
}

/// Do bodies, joints and the game's filter let the two collide?
inline bool PassesFilters(const b2ContactManager *manager, b2Fixture *fixtureA, b2Fixture *fixtureB) {
    const b2Body *bodyA = fixtureA->GetBody(), *bodyB = fixtureB->GetBody();
    const bool passes =
        (bodyB->*Named(ShouldCollide()))(bodyA) &&
        (manager->m_contactFilter == nullptr || manager->m_contactFilter->ShouldCollide(fixtureA, fixtureB));
    AskRoundingAgain();
    return passes;
}

/// The calls of b2Contact::Update. `beforeGame()` is called ahead of them if they run code of the game. Do
/// they? `listener`: of the moment ahead of the update. If it replaces itself in BeginContact, PreSolve is
/// still its own.
template <typename BeforeGame>
bool CallListener(b2ContactListener *listener, b2Contact *contact, const ContactChange &change,
                  BeforeGame beforeGame) {
    if (listener == nullptr || !(change.touched || change.touches))
        return false;
    const bool preSolves = change.touches && !change.isSensor && HasOwnPreSolve(*listener);
    if (change.touched == change.touches && !preSolves)
        return false;
    const bool isOfGame = IsOfGame(listener);
    if (isOfGame)
        beforeGame();
    if (change.touches && !change.touched)
        listener->BeginContact(contact);
    if (change.touched && !change.touches)
        listener->EndContact(contact);
    if (preSolves)
        listener->PreSolve(contact, &change.old);
    AskRoundingAgain();
    return isOfGame;
}

} // namespace bmr

#endif
