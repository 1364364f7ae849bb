// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_HOOKS_STOCK_H
#define BOOMERANG_HOOKS_STOCK_H

#include <box2d/b2_math.h>

#include "start/hook_list.h"

#if !defined(BMR_RENAMED)
#    include "interposed/real.h"
#endif

class b2Contact;
class b2ContactManager;
class b2Fixture;
class b2Joint;
class b2Shape;
class b2World;
struct b2Color;
struct b2DistanceInput;
struct b2DistanceOutput;
struct b2DistanceProxy;
struct b2Filter;
struct b2JointDef;
struct b2ShapeCastInput;
struct b2ShapeCastOutput;
struct b2SimplexCache;
struct b2TimeStep;
struct b2TOIInput;
struct b2TOIOutput;

/// @file
/// Box2D's own functions, for the hooks that stand in front of them: `stock::FindNewContacts(manager)` is
/// what `manager->FindNewContacts()` would be without us. A hook is an ordinary definition of Box2D's
/// function, in hooks/. How calls get to it, and how a hook gets to what it stands in front of, is one of two
/// ways:
///
/// - interposed: Box2D is a shared library, and this one stands ahead of it for the loader. What is asked for
///   here is looked up by name behind this library.
/// - renamed: boomerang_accelerate compiles Box2D's sources with the plugin, and they define all of this
///   under other names. BMR_RENAMED is defined. What is asked for here is defined in renamed/.
///
/// BMR_FOR_LOADERS(name), in the file of the hook's definition, says by which name loaders ask for it; it
/// means something in the first way alone.

#if defined(BMR_RENAMED)
#    define BMR_FOR_LOADERS(name) static_assert(true)
#    define BMR_STOCK BMR_DECLARE_STOCK
#else
#    define BMR_STOCK(name, function, symbol, heard, result, parameters, renamed)                            \
        inline Real<result parameters> name(#symbol);
#endif

namespace bmr::stock {

BMR_HOOKS(BMR_STOCK)

} // namespace bmr::stock

namespace bmr::hooks {

/// A world's destructor begins. (No definition of ours can stand in front of a destructor, which ends its
/// members, too: each way has its own means.)
void NoteWorldEnds(b2World *world);

} // namespace bmr::hooks

#endif
