// SPDX-License-Identifier: MIT
// Polygons of more than 8 vertices: a bowl is filled with coins of 256, capsules and a hull of many points.
// Each is one fixture. Build it on an installed Boomerang with
//
//     c++ -std=c++17 any_size.cpp $(pkg-config --cflags --libs boomerang-box2d) -o any_size
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <boomerang/box2d.h>
#include <box2d/box2d.h>

namespace {

/// Made once: all fixtures share the polygon.
bmr::ConvexShape Checked(const bmr::ConvexShape &shape, bmr_error error) {
    if (error != BMR_OK) {
        std::fprintf(stderr, "no polygon: %s\n", bmr_error_describe(error));
        std::exit(1);
    }
    return shape;
}

} // namespace

int main() {
    bmr::Install(); // not needed by ConvexShape: it makes the rest faster

    bmr::ConvexShape shape;
    bmr_error error = shape.SetRegular(256, 0.3f);
    const bmr::ConvexShape coin = Checked(shape, error);
    error = shape.SetRounded(0.6f, 0.15f, 0.15f, 24);
    const bmr::ConvexShape capsule = Checked(shape, error);
    std::vector<b2Vec2> points; // in any order; the shape is their hull
    points.reserve(500);
    for (int i = 0; i < 500; ++i)
        points.emplace_back(0.5f * std::cos(0.7f * i), 0.3f * std::sin(1.1f * i));
    error = shape.Set(points.data(), static_cast<int32>(points.size()));
    const bmr::ConvexShape pebble = Checked(shape, error);

    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef def;
    b2ChainShape bowl;
    std::vector<b2Vec2> rim;
    rim.reserve(61);
    for (int i = 0; i <= 60; ++i)
        rim.emplace_back(5.0f * std::cos(b2_pi * i / 60.0f), -5.0f * std::sin(b2_pi * i / 60.0f));
    bowl.CreateChain(rim.data(), static_cast<int32>(rim.size()), {5.0f, 1.0f}, {-5.0f, 1.0f});
    world.CreateBody(&def)->CreateFixture(&bowl, 0.0f);

    const bmr::ConvexShape *const shapes[] = {&coin, &capsule, &pebble};
    def.type = b2_dynamicBody;
    for (int i = 0; i < 60; ++i) {
        const int row = i / 6;
        def.position.Set(0.9f * (i % 6) - 2.25f, 0.8f * row);
        world.CreateBody(&def)->CreateFixture(shapes[i % 3], 1.0f);
    }
    for (int frame = 0; frame < 600; ++frame)
        world.Step(1.0f / 60.0f, 8, 3);

    int inside = 0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        inside += body->GetType() == b2_dynamicBody && body->GetPosition().y > -5.0f;
    std::printf("vertices %d %d %d\n", coin.GetVertexCount(), capsule.GetVertexCount(),
                pebble.GetVertexCount());
    std::printf("in the bowl %d\n", inside);
}
