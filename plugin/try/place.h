// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TRY_PLACE_H
#define BOOMERANG_TRY_PLACE_H

#include <string>

#include "try/verdict.h"

namespace bmr::trial {

/// Where Box2D is in this game, from the files that it had in memory.
struct Place {
    std::string shared; ///< libbox2d.so, where it is a library of its own
    std::string inside; ///< another file with Box2D 2 in it
    std::string version3;
    std::string boomerang; ///< our own library, where the game has it as it is
    bool callsInstall = false;
};

Place PlaceOfBox2D(const Trial &trial);

/// How a game has Boomerang as it is.
enum class Already { kNot, kCompiled, kPreloaded, kInstalled, kLinked };

Already AlreadyIn(const Trial &trial, const Place &place);

/// Was the library in memory?
bool HasBoomerang(const Run &run);

} // namespace bmr::trial

#endif
