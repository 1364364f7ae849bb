// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_GLUE_HOOK_LIST_H
#define BOOMERANG_GLUE_HOOK_LIST_H

/// @file
/// The hooks: Box2D's functions that the plugin stands in front of. A hook is named here, where it is defined
/// (plugin/hooks), and, if a `#define` does not rename Box2D's own, in plugin/renamed. All else is made of
/// this list: the names by which hooks call Box2D's own (bmr::stock), the symbols (CMake reads them here),
/// what the trial step has to hear (HookOf), and what boomerang_accelerate looks for in Box2D's sources.
///
///     HOOK(name, function, symbol, heard, result, parameters, renamed)
///
///     name         of it in bmr::stock and in HookOf
///     function     Box2D's name for it
///     symbol       the mangled name
///     heard        kHeard: our passes need it, and a step of a small world calls it; else kAny
///     result, parameters   of bmr::stock's function: an object goes first
///     renamed      the call of Box2D's own where its source is compiled with ours
///
/// A list for each of Box2D's files that define them.

#define BMR_HOOKS_OF_b2_world(HOOK)                                                                          \
    HOOK(Step, b2World::Step, _ZN7b2World4StepEfii, kHeard, void,                                            \
         (b2World * world, float timeStep, int32 velocityIterations, int32 positionIterations),              \
         world->BmrStockStep(timeStep, velocityIterations, positionIterations))                              \
    HOOK(DrawShape, b2World::DrawShape, _ZN7b2World9DrawShapeEP9b2FixtureRK11b2TransformRK7b2Color, kAny,    \
         void, (b2World * world, b2Fixture * fixture, const b2Transform &xf, const b2Color &color),          \
         world->BmrStockDrawShape(fixture, xf, color))                                                       \
    HOOK(CreateJoint, b2World::CreateJoint, _ZN7b2World11CreateJointEPK10b2JointDef, kAny, b2Joint *,        \
         (b2World * world, const b2JointDef *def), world->BmrStockCreateJoint(def))                          \
    HOOK(DestroyJoint, b2World::DestroyJoint, _ZN7b2World12DestroyJointEP7b2Joint, kAny, void,               \
         (b2World * world, b2Joint * joint), world->BmrStockDestroyJoint(joint))

#define BMR_HOOKS_OF_b2_contact_manager(HOOK)                                                                \
    HOOK(FindNewContacts, b2ContactManager::FindNewContacts, _ZN16b2ContactManager15FindNewContactsEv,       \
         kHeard, void, (b2ContactManager * manager), manager->BmrStockFindNewContacts())                     \
    HOOK(Destroy, b2ContactManager::Destroy, _ZN16b2ContactManager7DestroyEP9b2Contact, kHeard, void,        \
         (b2ContactManager * manager, b2Contact * contact), manager->BmrStockDestroy(contact))

#define BMR_HOOKS_OF_b2_fixture(HOOK)                                                                        \
    HOOK(Refilter, b2Fixture::Refilter, _ZN9b2Fixture8RefilterEv, kAny, void, (b2Fixture * fixture),         \
         fixture->BmrStockRefilter())                                                                        \
    HOOK(SetFilterData, b2Fixture::SetFilterData, _ZN9b2Fixture13SetFilterDataERK8b2Filter, kAny, void,      \
         (b2Fixture * fixture, const b2Filter &filter), fixture->BmrStockSetFilterData(filter))

#define BMR_HOOKS_OF_b2_time_of_impact(HOOK)                                                                 \
    HOOK(TimeOfImpact, b2TimeOfImpact, _Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput, kAny, void,           \
         (b2TOIOutput * output, const b2TOIInput *input), BmrStockTimeOfImpact(output, input))

#define BMR_HOOKS_OF_b2_distance(HOOK)                                                                       \
    HOOK(Distance, b2Distance, _Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput, kAny,  \
         void, (b2DistanceOutput * output, b2SimplexCache * cache, const b2DistanceInput *input),            \
         BmrStockDistance(output, cache, input))                                                             \
    HOOK(ShapeCast, b2ShapeCast, _Z11b2ShapeCastP17b2ShapeCastOutputPK16b2ShapeCastInput, kAny, bool,        \
         (b2ShapeCastOutput * output, const b2ShapeCastInput *input), BmrStockShapeCast(output, input))      \
    HOOK(SetProxy, b2DistanceProxy::Set, _ZN15b2DistanceProxy3SetEPK7b2Shapei, kAny, void,                   \
         (b2DistanceProxy * proxy, const b2Shape *shape, int32 child), proxy->BmrStockSet(shape, child))

#define BMR_HOOKS(HOOK)                                                                                      \
    BMR_HOOKS_OF_b2_world(HOOK) BMR_HOOKS_OF_b2_contact_manager(HOOK) BMR_HOOKS_OF_b2_fixture(HOOK)          \
        BMR_HOOKS_OF_b2_time_of_impact(HOOK) BMR_HOOKS_OF_b2_distance(HOOK)

/// A declaration or a definition of bmr::stock's function.
#define BMR_DECLARE_STOCK(name, function, symbol, heard, result, parameters, renamed) result name parameters;
#define BMR_DEFINE_STOCK(name, function, symbol, heard, result, parameters, renamed)                         \
    result name parameters {                                                                                 \
        return renamed;                                                                                      \
    }

#endif
