// SPDX-License-Identifier: MIT
#include "count/count.h"

#include <cstdio>
#include <cstdlib>

#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>
#include <dlfcn.h>

namespace {

boomerang_counts counted;

/// The function of that name in whatever was loaded after this library: the plugin's, or Box2D's.
template <typename Function> Function Next(const char *name) {
    void *found = dlvsym(RTLD_NEXT, name, "BOOMERANG_HOOKS"); // the plugin's, which dlsym passes over
    if (found == nullptr)
        found = dlsym(RTLD_NEXT, name);
    if (found == nullptr) {
        std::fprintf(stderr, "libboomerang-count: %s is nowhere\n", name);
        std::abort();
    }
    return reinterpret_cast<Function>(found);
}

} // namespace

void boomerang_count_read(boomerang_counts *counts) {
    *counts = counted;
}

// Each finds the next of its own name; the names are those of the Itanium C++ ABI.

void b2CollidePolygons(b2Manifold *manifold, const b2PolygonShape *polygonA, const b2Transform &xfA,
                       const b2PolygonShape *polygonB, const b2Transform &xfB) {
    static const auto next = Next<decltype(&b2CollidePolygons)>(
        "_Z17b2CollidePolygonsP10b2ManifoldPK14b2PolygonShapeRK11b2TransformS3_S6_");
    ++counted.polygon_tests;
    next(manifold, polygonA, xfA, polygonB, xfB);
    if (manifold->pointCount == 0)
        ++counted.polygon_tests_apart;
}

void b2TimeOfImpact(b2TOIOutput *output, const b2TOIInput *input) {
    static const auto next =
        Next<decltype(&b2TimeOfImpact)>("_Z14b2TimeOfImpactP11b2TOIOutputPK10b2TOIInput");
    ++counted.toi_calls;
    next(output, input);
}

void b2Distance(b2DistanceOutput *output, b2SimplexCache *cache, const b2DistanceInput *input) {
    using Distance = void (*)(b2DistanceOutput *, b2SimplexCache *, const b2DistanceInput *);
    static const auto next =
        Next<Distance>("_Z10b2DistanceP16b2DistanceOutputP14b2SimplexCachePK15b2DistanceInput");
    ++counted.distance_calls;
    next(output, cache, input);
}
