// SPDX-License-Identifier: MIT
//
// Small worlds of one kind of work each, to be run under callgrind by measure_costs.sh: with nothing but
// Box2D, and with libboomerang_box2d.so preloaded. Nothing of this project is called here, and nothing is
// timed.
//
//     bench_worlds WORLD COUNT STEPS
//
// The instructions of the STEPS steps are those of MeasuredStep; the first steps, in which contacts are made,
// are not among them (except in the worlds new-*, where they are what is measured).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <box2d/box2d.h>

void MeasuredStep(b2World &world);

__attribute__((noinline)) void MeasuredStep(b2World &world) {
    world.Step(1.0f / 60.0f, 8, 3);
}

namespace {

// Slow enough that no box of the broad phase is left in a run, so that the contacts stay; but poses change.
constexpr float kCreep = 0.02f;
// Two skins of b2_polygonRadius, less 4 mm: touching, and no deeper than the slop, so that nothing is pushed
// apart.
constexpr float kTouchingGap = 2.0f * b2_polygonRadius - 0.8f * b2_linearSlop;
constexpr int kWarmUp = 3;
constexpr float kSlant = 0.25f * b2_pi;

enum class Partner { kDynamic, kStatic };

b2PolygonShape Regular(int corners, float radius) {
    b2Vec2 points[b2_maxPolygonVertices];
    for (int i = 0; i < corners; ++i) {
        // Flat sides right and left, above and below, where the number of corners allows it.
        const float angle = 2.0f * b2_pi * (static_cast<float>(i) + 0.5f) / static_cast<float>(corners);
        points[i].Set(radius * std::cos(angle), radius * std::sin(angle));
    }
    b2PolygonShape shape;
    shape.Set(points, corners);
    return shape;
}

b2PolygonShape Box(float halfWidth, float halfHeight) {
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight);
    return shape;
}

b2Body *AddBody(b2World &world, b2BodyType type, b2Vec2 position, float angle, b2Vec2 velocity) {
    b2BodyDef def;
    def.type = type;
    def.position = position;
    def.angle = angle;
    def.linearVelocity = velocity;
    return world.CreateBody(&def);
}

void AddFixture(b2Body *body, const b2Shape &shape, bool sensor = false) {
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 1.0f;
    def.isSensor = sensor;
    body->CreateFixture(&def);
}

/// Rows of `columns`, upwards from the origin.
b2Vec2 Place(int index, int columns, float spacing) {
    const int column = index % columns - columns / 2, row = index / columns;
    return {spacing * static_cast<float>(column), spacing * static_cast<float>(row)};
}

/// Pairs of bodies far from each other pair.
struct Pairs {
    const b2Shape &first, &second;
    b2Vec2 offset; ///< from the first body to the second
    float angle = 0.0f;
    Partner partner = Partner::kDynamic;
    bool sensor = false; ///< the second
};

void AddPairs(b2World &world, int count, const Pairs &pairs) {
    constexpr int kColumns = 40;
    constexpr float kSpacing = 20.0f;
    for (int i = 0; i < count; ++i) {
        const b2Vec2 place = Place(i, kColumns, kSpacing);
        const b2Vec2 creep(kCreep, 0.5f * kCreep);
        const bool fixed = pairs.partner == Partner::kStatic;
        AddFixture(AddBody(world, fixed ? b2_staticBody : b2_dynamicBody, place, pairs.angle,
                           fixed ? b2Vec2_zero : creep),
                   pairs.first);
        AddFixture(AddBody(world, b2_dynamicBody, place + pairs.offset, pairs.angle, creep), pairs.second,
                   pairs.sensor);
    }
}

/// Bodies in chains far from each other chain, as many as AddPairs makes of `count`. Along a chain each is
/// `offset` further; so one body is in several pairs.
void AddChains(b2World &world, int count, const b2Shape &shape, b2Vec2 offset, float angle) {
    constexpr int kLinks = 16, kColumns = 10;
    constexpr float kSpacing = 20.0f;
    for (int i = 0; i < 2 * count; ++i) {
        const b2Vec2 place = Place(i / kLinks, kColumns, kSpacing);
        AddFixture(AddBody(world, b2_dynamicBody, place + static_cast<float>(i % kLinks) * offset, angle,
                           {kCreep, 0.5f * kCreep}),
                   shape);
    }
}

/// Whether there is a world of this name.
bool Build(b2World &world, const char *name, int count) {
    const auto is = [name](const char *other) { return std::strcmp(name, other) == 0; };
    const b2PolygonShape plank = Box(2.0f, 0.1f), box = Box(0.5f, 0.5f), hexagon = Regular(6, 0.25f);
    const b2PolygonShape octagon = Regular(8, 1.0f), fan = Regular(8, 2.0f);
    const float apothem = std::cos(b2_pi / 8.0f);
    b2EdgeShape edge;
    edge.SetTwoSided({-2.0f, 0.0f}, {2.0f, 0.0f});
    const b2Vec2 aside(0.5f, -0.5f), diagonal(1.5f, 1.5f), far(8.0f, 0.0f);
    const auto pairs = [&](const Pairs &of) { AddPairs(world, count, of); };

    if (is("apart-box"))
        pairs({plank, plank, aside, kSlant});
    else if (is("apart-chain"))
        AddChains(world, count, plank, aside, kSlant);
    else if (is("apart-octagon") || is("new-pairs"))
        pairs({octagon, octagon, diagonal});
    else if (is("touching-box"))
        pairs({box, box, {1.0f + kTouchingGap, 0.1f}});
    else if (is("touching-octagon"))
        pairs({octagon, octagon, {2.0f * apothem + kTouchingGap, 0.1f}});
    else if (is("far") || is("new-far")) // what bodies cost that meet nobody
        pairs({octagon, octagon, far});
    else if (is("toi-polygon"))
        pairs({plank, hexagon, aside, kSlant, Partner::kStatic});
    else if (is("toi-edge"))
        pairs({edge, hexagon, aside, kSlant, Partner::kStatic});
    else if (is("toi-far"))
        pairs({plank, hexagon, far, kSlant, Partner::kStatic});
    else if (is("sensor-apart"))
        pairs({octagon, fan, {2.3f, 2.3f}, 0.0f, Partner::kDynamic, true});
    else if (is("sensor-overlapping"))
        pairs({octagon, fan, diagonal, 0.0f, Partner::kDynamic, true});
    else
        return false;
    return true;
}

} // namespace

int main(int argc, char **argv) {
    const int count = argc > 3 ? std::atoi(argv[2]) : 0, steps = argc > 3 ? std::atoi(argv[3]) : 0;
    b2World world(b2Vec2_zero);
    world.SetAllowSleeping(false);
    if (count < 1 || steps < 1 || !Build(world, argv[1], count)) {
        std::fprintf(stderr, "usage: bench_worlds WORLD COUNT STEPS; measure_costs.sh knows the worlds\n");
        return 2;
    }
    // What is done once in a process is done in the first step of any world.
    b2World(b2Vec2_zero).Step(1.0f / 60.0f, 8, 3);
    const bool fresh = std::strncmp(argv[1], "new-", 4) == 0;
    for (int i = 0; !fresh && i < kWarmUp; ++i)
        world.Step(1.0f / 60.0f, 8, 3);
    for (int i = 0; i < steps; ++i)
        MeasuredStep(world);
    int touching = 0;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext())
        touching += contact->IsTouching() ? 1 : 0;
    std::printf("%d bodies, %d contacts, %d touching\n", world.GetBodyCount(), world.GetContactCount(),
                touching);
}
