// SPDX-License-Identifier: MIT
// See b2_world.cpp. b2DistanceProxy::Set of vertices goes with Set of a shape: other files find it below.
#include "box2d/b2_chain_shape.h"
#include "box2d/b2_circle_shape.h"
#include "box2d/b2_edge_shape.h"
#include "box2d/b2_math.h"
#include "box2d/b2_polygon_shape.h"

#define b2Distance BmrStockDistance
#define b2ShapeCast BmrStockShapeCast
#define Set(...)                                                                                             \
    Set(__VA_ARGS__);                                                                                        \
    void BmrStockSet(__VA_ARGS__)
#include "box2d/b2_distance.h"
#undef b2Distance
#undef Set

// Between two points b2Distance is another function, in b2_math.h, which the source calls, too.
static inline float BmrStockDistance(const b2Vec2 &a, const b2Vec2 &b) {
    return b2Distance(a, b);
}

#define b2Distance BmrStockDistance
#define Set BmrStockSet
#include BMR_BOX2D_SOURCE
#undef b2Distance
#undef b2ShapeCast
#undef Set

void b2DistanceProxy::Set(const b2Vec2 *vertices, int32 count, float radius) {
    BmrStockSet(vertices, count, radius);
}
