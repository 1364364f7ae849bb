// SPDX-License-Identifier: MIT
// Included ahead of every source of the shared library: its references to Box2D are weak. With another
// libbox2d than the one it was built for it must load all the same, look at what is there, and stay out of
// the way; a reference that is not weak would end the program before its first line. (Not for the static
// glue: weak references draw nothing out of an archive.)
#ifndef BOOMERANG_INTERPOSED_WEAK_BOX2D_H
#define BOOMERANG_INTERPOSED_WEAK_BOX2D_H

#include "start/hook_list.h"

#define BMR_SHARED_LIBRARY

// What the shared library wants from Box2D beside the functions that it has hooks for. tests/plugin holds
// this list against the library.
//   FUNCTION(name)      it refers to this function, weakly
//   DATA(name, bytes)   it refers to this data, of this size
//   SIGN(name)          it does not refer to this function, but a Box2D without it is not 2.4.1
// clang-format off
#define BMR_BOX2D_SYMBOLS(FUNCTION, DATA, SIGN) \
    FUNCTION(_Z13b2TestOverlapPK7b2ShapeiS1_iRK11b2TransformS4_) \
    FUNCTION(_Z17b2CollidePolygonsP10b2ManifoldPK14b2PolygonShapeRK11b2TransformS3_S6_) \
    FUNCTION(_Z23b2CollideEdgeAndPolygonP10b2ManifoldPK11b2EdgeShapeRK11b2TransformPK14b2PolygonShapeS6_) \
    FUNCTION(_ZN12b2BroadPhase11CreateProxyERK6b2AABBPv) \
    FUNCTION(_ZN12b2BroadPhase12DestroyProxyEi) \
    FUNCTION(_ZN12b2BroadPhase13QueryCallbackEi) \
    FUNCTION(_ZN12b2BroadPhase10TouchProxyEi) \
    FUNCTION(_ZN12b2BroadPhase9MoveProxyEiRK6b2AABBRK6b2Vec2) \
    FUNCTION(_ZN14b2PolygonShape3SetEPK6b2Vec2i) \
    FUNCTION(_ZNK12b2ChainShape12GetChildEdgeEP11b2EdgeShapei) \
    FUNCTION(_ZNK14b2PolygonShape11ComputeAABBEP6b2AABBRK11b2Transformi) \
    FUNCTION(_ZNK14b2PolygonShape11ComputeMassEP10b2MassDataf) \
    FUNCTION(_ZNK14b2PolygonShape13GetChildCountEv) \
    FUNCTION(_ZNK14b2PolygonShape7RayCastEP15b2RayCastOutputRK14b2RayCastInputRK11b2Transformi) \
    FUNCTION(_ZNK14b2PolygonShape9TestPointERK11b2TransformRK6b2Vec2) \
    FUNCTION(_ZN14b2PolygonShape8SetAsBoxEff) \
    FUNCTION(_ZN14b2PolygonShape8SetAsBoxEffRK6b2Vec2f) \
    FUNCTION(_ZN16b2BlockAllocator4FreeEPvi) \
    FUNCTION(_ZN16b2BlockAllocator8AllocateEi) \
    FUNCTION(_Z14b2Free_DefaultPv) \
    FUNCTION(_Z15b2Alloc_Defaulti) \
    FUNCTION(_ZN6b2Body13CreateFixtureEPK12b2FixtureDef) \
    FUNCTION(_ZN6b2Body14DestroyFixtureEP9b2Fixture) \
    FUNCTION(_ZN6b2Body13ResetMassDataEv) \
    FUNCTION(_ZN6b2Body19SynchronizeFixturesEv) \
    FUNCTION(_ZN7b2Timer5ResetEv) \
    FUNCTION(_ZN7b2TimerC1Ev) \
    FUNCTION(_ZN7b2World10CreateBodyEPK9b2BodyDef) \
    FUNCTION(_ZN7b2World11DestroyBodyEP6b2Body) \
    FUNCTION(_ZN7b2WorldC1ERK6b2Vec2) \
    FUNCTION(_ZN7b2WorldD1Ev) \
    FUNCTION(_ZN9b2Contact6CreateEP9b2FixtureiS1_iP16b2BlockAllocator) \
    FUNCTION(_ZN9b2Contact7DestroyEPS_P16b2BlockAllocator) \
    FUNCTION(_ZN9b2Contact7AddTypeEPFPS_P9b2FixtureiS2_iP16b2BlockAllocatorEPFvS0_S4_EN7b2Shape4TypeESA_) \
    FUNCTION(_ZN9b2ContactC2EP9b2FixtureiS1_i) \
    FUNCTION(_ZN9b2Contact6UpdateEP17b2ContactListener) \
    FUNCTION(_ZNK6b2Body13ShouldCollideEPKS_) \
    FUNCTION(_ZNK7b2Timer15GetMillisecondsEv) \
    FUNCTION(_ZNK7b2World13GetProxyCountEv) \
    DATA(_ZN9b2Contact11s_registersE, sizeof(b2ContactRegister) * b2Shape::e_typeCount * b2Shape::e_typeCount) \
    DATA(_ZN9b2Contact13s_initializedE, sizeof(bool)) \
    DATA(g_blockSolve, sizeof(bool)) \
    DATA(_ZTI14b2PolygonShape, 3 * sizeof(void *)) \
    DATA(_ZTV11b2EdgeShape, TableSize(8)) \
    DATA(_ZTV13b2CircleShape, TableSize(8)) \
    DATA(_ZTV14b2PolygonShape, TableSize(8)) \
    SIGN(_ZN11b2EdgeShape11SetOneSidedERK6b2Vec2S2_S2_S2_) \
    SIGN(_Z17b2LinearStiffnessRfS_ffPK6b2BodyS2_) \
    SIGN(_ZN6b2Body10SetEnabledEb)
// clang-format on

#define BMR_WEAK(name, ...) __asm__(".weak " #name);
#define BMR_NOT_REFERRED_TO(name)
#define BMR_WEAK_HOOK(name, function, symbol, heard, result, parameters, renamed) BMR_WEAK(symbol)
BMR_BOX2D_SYMBOLS(BMR_WEAK, BMR_WEAK, BMR_NOT_REFERRED_TO)
BMR_HOOKS(BMR_WEAK_HOOK)
#undef BMR_WEAK_HOOK
#undef BMR_NOT_REFERRED_TO
#undef BMR_WEAK

#endif
