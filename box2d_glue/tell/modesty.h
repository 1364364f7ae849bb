// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_MODESTY_H
#define BOOMERANG_GLUE_MODESTY_H

#include <cstdint>
#include <vector>

class b2Contact;
class b2World;

namespace bmr {

/// Mode::Verify with Options::modestListeners: while it lives, do the game's listeners and filters keep the
/// promise? At its end it compares the world with what it was at its beginning, and reports what changed. It
/// stops where bodies or fixtures came or went: then a step was made inside this one.
class ModestyCheck {
public:
    /// `inCollide`: nothing but the game puts bodies to sleep, or disables contacts. `world` may be nullptr.
    ModestyCheck(const b2World *world, bool inCollide);
    ~ModestyCheck();
    ModestyCheck(const ModestyCheck &) = delete;
    ModestyCheck &operator=(const ModestyCheck &) = delete;

private:
    void Remember();
    void CompareFixtures() const;
    void CompareContacts() const;

    const b2World *m_world; ///< nullptr: nothing is compared
    bool m_inCollide;
    std::vector<uint64_t> m_fixtures;         ///< in the order of Box2D's lists: what each was
    std::vector<const b2Contact *> m_excused; ///< they touched, or were disabled; by their addresses
};

} // namespace bmr

#endif
