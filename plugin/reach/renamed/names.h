// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_REACH_RENAMED_NAMES_H
#define BOOMERANG_REACH_RENAMED_NAMES_H

/// @file
/// How hooks are reached where Box2D is compiled with the plugin (boomerang_accelerate,
/// cmake/BoomerangAccelerate.cmake).
///
/// Each file of this folder stands for one of Box2D's sources, by the same name: it gives some functions that
/// the source defines other names (BmrStock...), includes the source as it is (BMR_BOX2D_SOURCE), and defines
/// the functions of bmr::stock (reach/stock.h, start/hook_list.h) that call them. All other files of Box2D
/// call Box2D's names, which hooks/ defines. Members that only this file has do not change how a class is
/// laid out.
///
/// Most functions are called from other files alone, and one `#define` renames them. Those that their own
/// source calls, too, keep their name in calls and get another one where they are defined. Two ways tell
/// calls from definitions:
///
///   - By the first word in parentheses. `#define Destroy(...) BMR_DESTROY_##__VA_ARGS__)` makes one name
///     of it and of the word: the definition's is a type, a call's a variable. For each word that is known
///     there is a definition of that name; a source with another word does not compile.
///   - By overloading, where the first word will not do. The definition and the call have the new name;
///     what the call passes is not what the definition takes, and fits an overload better that calls the
///     hook.
///
/// All is C++11, and compiled as the rest of Box2D is.

#endif
