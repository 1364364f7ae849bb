// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_REACH_STOCK_H
#define BOOMERANG_REACH_STOCK_H

#include <box2d/b2_math.h>

#if !defined(BMR_RENAMED)
#    include "reach/interposed/real.h"
#endif

class b2BroadPhase;
class b2Body;
class b2Contact;
class b2ContactManager;
class b2DynamicTree;
class b2Fixture;
class b2Joint;
class b2Shape;
class b2World;
struct b2AABB;
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
/// Box2D's own functions, for the hooks that stand in front of them: `stock::Collide(manager)` is what
/// `manager->Collide()` would be without us. A hook is an ordinary definition of Box2D's function, in hooks/.
/// How calls get to it, and how a hook gets to what it stands in front of, is one of two ways:
///
/// - interposed: Box2D is a shared library, and this one stands ahead of it for the loader. What is asked for
///   here is looked up by name behind this library.
/// - renamed: boomerang_accelerate compiles Box2D's sources with the plugin, and they define all of this
///   under other names. BMR_RENAMED is defined. What is asked for here is defined in renamed/.
///
/// BMR_FOR_LOADERS(name), ahead of a hook's definition, says by which name loaders ask for it; it means
/// something in the first way alone.

#if defined(BMR_RENAMED)
#    define BMR_FOR_LOADERS(name) static_assert(true)
#    define BMR_STOCK(name, mangled, ...)                                                                    \
        using name##Function = __VA_ARGS__;                                                                  \
        name##Function name
#else
#    define BMR_STOCK(name, mangled, ...) inline Real<__VA_ARGS__> name(mangled)
#endif

namespace bmr::stock {

BMR_STOCK(Step, "_ZN7b2World4StepEfii", void(b2World *, float, int32, int32));
BMR_STOCK(Solve, "_ZN7b2World5SolveERK10b2TimeStep", void(b2World *, const b2TimeStep &));
BMR_STOCK(SolveToi, "_ZN7b2World8SolveTOIERK10b2TimeStep", void(b2World *, const b2TimeStep &));
BMR_STOCK(DrawShape, "_ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color",
          void(b2World *, b2Fixture *, const b2Transform &, const b2Color &));
BMR_STOCK(CreateJoint, "_ZN7b2World11CreateJointEPK10b2JointDef", b2Joint *(b2World *, const b2JointDef *));
BMR_STOCK(DestroyJoint, "_ZN7b2World12DestroyJointEP7b2Joint", void(b2World *, b2Joint *));
BMR_STOCK(DestroyBody, "_ZN7b2World11DestroyBodyEP6b2Body", void(b2World *, b2Body *));

BMR_STOCK(Collide, "_ZN16b2ContactManager7CollideEv", void(b2ContactManager *));
BMR_STOCK(FindNewContacts, "_ZN16b2ContactManager15FindNewContactsEv", void(b2ContactManager *));
BMR_STOCK(Destroy, "_ZN16b2ContactManager7DestroyEP9b2Contact", void(b2ContactManager *, b2Contact *));

BMR_STOCK(Synchronize, "_ZN9b2Fixture11SynchronizeEP12b2BroadPhaseRK11b2TransformS4_",
          void(b2Fixture *, b2BroadPhase *, const b2Transform &, const b2Transform &));
BMR_STOCK(Refilter, "_ZN9b2Fixture8RefilterEv", void(b2Fixture *));
BMR_STOCK(SetFilterData, "_ZN9b2Fixture13SetFilterDataERK8b2Filter", void(b2Fixture *, const b2Filter &));

#if defined(BMR_RENAMED)
/// Are Box2D's assertions compiled?
bool Asserts();
/// b2Assert, of an assertion that does not hold.
void Fails(const char *assertion);
#endif

BMR_STOCK(CreateProxy, "_ZN13b2DynamicTree11CreateProxyERK6b2AABBPv",
          int32(b2DynamicTree *, const b2AABB &, void *));
BMR_STOCK(DestroyProxy, "_ZN13b2DynamicTree12DestroyProxyEi", void(b2DynamicTree *, int32));
BMR_STOCK(MoveProxy, "_ZN13b2DynamicTree9MoveProxyEiRK6b2AABBRK6b2Vec2",
          bool(b2DynamicTree *, int32, const b2AABB &, const b2Vec2 &));

BMR_STOCK(TimeOfImpact, "_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput",
          void(b2TOIOutput *, const b2TOIInput *));
BMR_STOCK(Distance, "_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput",
          void(b2DistanceOutput *, b2SimplexCache *, const b2DistanceInput *));
BMR_STOCK(ShapeCast, "_Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput",
          bool(b2ShapeCastOutput *, const b2ShapeCastInput *));
BMR_STOCK(SetProxy, "_ZN15b2DistanceProxy3SetEPK7b2Shapei", void(b2DistanceProxy *, const b2Shape *, int32));

} // namespace bmr::stock

namespace bmr::hooks {

/// A world's destructor begins. (No definition of ours can stand in front of a destructor, which ends its
/// members, too: each way has its own means.)
void NoteWorldEnds(b2World *world);

} // namespace bmr::hooks

#endif
