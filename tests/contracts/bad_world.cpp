// SPDX-License-Identifier: MIT
// A plain Box2D game to which one bad thing happens, by its number. It prints a hash after every step, at
// once: what was printed before an assertion ends the program must be there too. Without a number: the names
// of the bad things.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <utility>

#include <unistd.h>

#include "../plugin/small_world.h"

namespace {

const float kNone = std::nanf(""), kInfinite = INFINITY;

/// Does what is to be done when it is first asked about a new pair, before the world is locked; or when it is
/// told of an end outside of a step.
class Meddler final : public b2ContactFilter, public b2ContactListener {
public:
    std::function<void(b2Body *)> asked;
    std::function<void()> told;
    bool ShouldCollide(b2Fixture *a, b2Fixture *b) override {
        if (asked)
            std::exchange(asked, nullptr)(b->GetBody());
        return b2ContactFilter::ShouldCollide(a, b);
    }
    void EndContact(b2Contact *contact) override {
        if (told && !contact->GetFixtureA()->GetBody()->GetWorld()->IsLocked())
            std::exchange(told, nullptr)();
    }
};

/// What happens to, and what the world is stepped with from then on.
struct Game {
    Meddler meddler; ///< in the world where something is to be done
    b2World world{b2Vec2(0.0f, -10.0f)};
    b2Body *box, *wheel, *bullet; ///< in the middle of the others
    b2Body *sensor;               ///< through which they fall
    float timeStep = 1.0f / 60.0f;
    int32 velocityIterations = 8, positionIterations = 3;

    /// Few bodies: where a box is no number it overlaps all others.
    Game() {
        for (int i = 0; i < 3; ++i) {
            const float x = static_cast<float>(i);
            AddBox(world, b2_staticBody, {6.0f * (x - 1.0f), -x}, {3.5f, 0.2f}, 0.15f * (x - 1.0f));
        }
        sensor = AddBox(world, b2_staticBody, {0.0f, 5.0f}, {12.0f, 0.5f}, 0.0f, true);
        for (int i = 0; i < 10; ++i)
            AddBox(world, b2_dynamicBody, {1.3f * static_cast<float>(i - 5), 9.0f}, {0.4f, 0.3f},
                   0.3f * static_cast<float>(i));
        AddWheel(world, {1.2f, 3.0f}, 5, 1.0f);
        wheel = AddWheel(world, {3.0f, 4.0f}, 5, 1.0f);
        box = AddBox(world, b2_dynamicBody, {0.0f, 7.0f}, {0.5f, 0.5f}, 0.1f);
        bullet = AddBox(world, b2_dynamicBody, {1.2f, 7.0f}, {0.2f, 0.2f}, 0.0f);
        bullet->SetBullet(true);
        bullet->SetLinearVelocity({0.0f, -100.0f});
    }
    b2PolygonShape &Polygon(const b2Body *body) const {
        return *static_cast<b2PolygonShape *>(const_cast<b2Fixture *>(body->GetFixtureList())->GetShape());
    }
    /// For the box and a part of the wheel, in their places.
    void Edit(const std::function<void(b2PolygonShape &)> &edit) const {
        edit(Polygon(box));
        edit(Polygon(wheel));
    }
    /// In the box of a slanted plank, of which the filter is then asked, and apart from the plank itself.
    void DropNearPlank(std::function<void(b2Body *)> asked) {
        meddler.asked = std::move(asked);
        world.SetContactFilter(&meddler);
        AddBox(world, b2_dynamicBody, {-3.0f, 0.5f}, {0.1f, 0.1f}, 0.0f);
    }
    /// A box near a wall and in a sensor, which came later. When its first contact ends, the world is
    /// stepped.
    b2Body *AddInSensor() {
        AddBox(world, b2_staticBody, {1.1f, 20.0f}, {0.5f, 0.5f}, 0.0f);
        b2Body *const body = AddBox(world, b2_dynamicBody, {0.0f, 20.1f}, {0.5f, 0.5f}, 0.0f);
        world.Step(0.0f, 8, 3);
        AddBox(world, b2_staticBody, {0.0f, 20.0f}, {0.5f, 0.5f}, 0.0f, true);
        world.Step(0.0f, 8, 3);
        meddler.told = [this] { world.Step(timeStep, 8, 3); };
        world.SetContactListener(&meddler);
        return body;
    }
    void Drop(const b2PolygonShape &shape, float density = 1.0f) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = {0.5f, 8.0f};
        world.CreateBody(&def)->CreateFixture(&shape, density);
    }
    void DropPoints(std::initializer_list<b2Vec2> points) {
        b2PolygonShape shape;
        shape.Set(points.begin(), static_cast<int32>(points.size()));
        Drop(shape);
    }
    void DropBox(float halfWidth, float halfHeight) {
        b2PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight);
        Drop(shape);
    }
    void Define(const std::function<void(b2BodyDef *)> &spoil) {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.position = {0.5f, 8.0f};
        spoil(&def);
        b2Body *body = world.CreateBody(&def);
        b2PolygonShape shape;
        shape.SetAsBox(0.5f, 0.5f);
        body->CreateFixture(&shape, 1.0f);
    }
};

struct BadThing {
    const char *name;
    void (*happen)(Game *);
};

const BadThing kBadThings[] = {
    {"nothing", [](Game *) {}},
    // Where bodies are.
    {"a body is moved to NaN", [](Game *g) { g->box->SetTransform({kNone, 7.0f}, 0.0f); }},
    {"a body is moved to infinity", [](Game *g) { g->box->SetTransform({0.0f, kInfinite}, 0.0f); }},
    {"a body is moved to 1e38", [](Game *g) { g->box->SetTransform({1e38f, 7.0f}, 0.0f); }},
    {"a body is moved to 1e9", [](Game *g) { g->box->SetTransform({1e9f, 7.0f}, 0.0f); }},
    {"a body is moved to 1e-38", [](Game *g) { g->box->SetTransform({1e-38f, 7.0f}, 0.0f); }},
    {"a body is turned to NaN", [](Game *g) { g->box->SetTransform({0.0f, 7.0f}, kNone); }},
    {"a body is turned to infinity", [](Game *g) { g->box->SetTransform({0.0f, 7.0f}, kInfinite); }},
    {"a body is turned to 1e38", [](Game *g) { g->box->SetTransform({0.0f, 7.0f}, 1e38f); }},
    {"a body of many fixtures is moved to NaN", [](Game *g) { g->wheel->SetTransform({kNone, kNone}, 0.0f); }},
    {"a body of many fixtures is turned to NaN", [](Game *g) { g->wheel->SetTransform({0, 4}, kNone); }},
    {"a body of many fixtures is moved to 1e38", [](Game *g) { g->wheel->SetTransform({0, -1e38f}, 0.0f); }},
    {"a body of many fixtures is put into others",
     [](Game *g) { g->wheel->SetTransform(g->box->GetPosition(), 0.0f); }},
    {"a bullet is moved to NaN", [](Game *g) { g->bullet->SetTransform({kNone, 7.0f}, 0.0f); }},
    {"a body is moved to NaN, and back",
     [](Game *g) {
         g->box->SetTransform({kNone, 7.0f}, kNone);
         g->box->SetTransform({0.0f, 7.0f}, 0.0f);
     }},
    {"without continuous physics a body is moved to NaN",
     [](Game *g) {
         g->world.SetContinuousPhysics(false);
         g->box->SetTransform({kNone, 7.0f}, 0.0f);
         g->wheel->SetTransform({kNone, 4.0f}, kNone);
     }},
    {"the origin is shifted to NaN", [](Game *g) { g->world.ShiftOrigin({kNone, 0.0f}); }},
    {"the origin is shifted to 1e38", [](Game *g) { g->world.ShiftOrigin({1e38f, 0.0f}); }},
    // How they move.
    {"a velocity of NaN", [](Game *g) { g->box->SetLinearVelocity({kNone, 0.0f}); }},
    {"an infinite velocity", [](Game *g) { g->box->SetLinearVelocity({0.0f, -kInfinite}); }},
    {"a velocity of 1e38", [](Game *g) { g->box->SetLinearVelocity({1e38f, -1e38f}); }},
    {"a velocity of 1e-38", [](Game *g) { g->box->SetLinearVelocity({1e-38f, -1e-38f}); }},
    {"a bullet's velocity of NaN", [](Game *g) { g->bullet->SetLinearVelocity({kNone, kNone}); }},
    {"a bullet's velocity of 1e38", [](Game *g) { g->bullet->SetLinearVelocity({1e38f, 0.0f}); }},
    {"a spin of NaN", [](Game *g) { g->box->SetAngularVelocity(kNone); }},
    {"an infinite spin", [](Game *g) { g->wheel->SetAngularVelocity(kInfinite); }},
    {"a spin of 1e38", [](Game *g) { g->wheel->SetAngularVelocity(1e38f); }},
    {"without continuous physics a velocity of NaN",
     [](Game *g) {
         g->world.SetContinuousPhysics(false);
         g->box->SetLinearVelocity({kNone, 0.0f});
         g->wheel->SetAngularVelocity(kNone);
     }},
    {"a force of NaN", [](Game *g) { g->box->ApplyForceToCenter({kNone, 0.0f}, true); }},
    {"an impulse of 1e38", [](Game *g) { g->box->ApplyLinearImpulseToCenter({1e38f, 0.0f}, true); }},
    {"a gravity of NaN", [](Game *g) { g->world.SetGravity({kNone, 0.0f}); }},
    {"a gravity of 1e38", [](Game *g) { g->world.SetGravity({0.0f, -1e38f}); }},
    {"a damping of NaN", [](Game *g) { g->box->SetLinearDamping(kNone); }},
    {"a damping below 0", [](Game *g) { g->box->SetLinearDamping(-100.0f); }},
    {"a friction of NaN", [](Game *g) { g->box->GetFixtureList()->SetFriction(kNone); }},
    {"a restitution of 1e38", [](Game *g) { g->box->GetFixtureList()->SetRestitution(1e38f); }},
    {"a mass of NaN",
     [](Game *g) {
         const b2MassData mass = {kNone, {0.0f, 0.0f}, 1.0f};
         g->box->SetMassData(&mass);
     }},
    {"an inertia that its centre makes negative",
     [](Game *g) {
         const b2MassData mass = {1.0f, {5.0f, 0.0f}, 1.0f};
         g->box->SetMassData(&mass);
     }},
    // Time.
    {"time steps of 0", [](Game *g) { g->timeStep = 0.0f; }},
    {"time steps of 1e9", [](Game *g) { g->timeStep = 1e9f; }},
    {"time steps of 1e-38", [](Game *g) { g->timeStep = 1e-38f; }},
    {"time steps of 1e38", [](Game *g) { g->timeStep = 1e38f; }},
    {"negative time steps", [](Game *g) { g->timeStep = -1.0f / 60.0f; }},
    {"time steps of NaN", [](Game *g) { g->timeStep = kNone; }},
    {"infinite time steps", [](Game *g) { g->timeStep = kInfinite; }},
    {"no iterations", [](Game *g) { g->velocityIterations = g->positionIterations = 0; }},
    {"negative numbers of iterations", [](Game *g) { g->velocityIterations = g->positionIterations = -7; }},
    // Skins.
    {"a negative radius", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = -0.1f; }); }},
    {"a negative radius larger than the polygon",
     [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = -10.0f; }); }},
    {"a radius of NaN", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = kNone; }); }},
    {"a radius of 0", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = 0.0f; }); }},
    {"a radius of 1e-38", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = 1e-38f; }); }},
    {"a radius of 1e38", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_radius = 1e38f; }); }},
    // Vertices that are changed in place.
    {"a vertex becomes NaN", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_vertices[1].x = kNone; }); }},
    {"a vertex becomes infinite",
     [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_vertices[2].y = kInfinite; }); }},
    {"a vertex becomes 1e38", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_vertices[1].x = 1e38f; }); }},
    {"a normal becomes NaN", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_normals[0].x = kNone; }); }},
    {"all vertices become equal",
     [](Game *g) {
         g->Edit([](b2PolygonShape &s) {
             for (b2Vec2 &v : s.m_vertices)
                 v = s.m_vertices[0];
         });
     }},
    {"all vertices come onto one line",
     [](Game *g) {
         g->Edit([](b2PolygonShape &s) {
             for (b2Vec2 &v : s.m_vertices)
                 v.y = 0.0f;
         });
     }},
    {"the order becomes clockwise",
     [](Game *g) {
         g->Edit([](b2PolygonShape &s) { std::reverse(s.m_vertices, s.m_vertices + s.m_count); });
     }},
    {"two vertices are exchanged",
     [](Game *g) { g->Edit([](b2PolygonShape &s) { std::swap(s.m_vertices[0], s.m_vertices[1]); }); }},
    {"a vertex makes a dent", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_vertices[1] *= -0.5f; }); }},
    {"all vertices shrink to 1e-38",
     [](Game *g) {
         g->Edit([](b2PolygonShape &s) {
             for (b2Vec2 &v : s.m_vertices)
                 v *= 1e-38f;
         });
     }},
    {"all vertices grow to 1e38",
     [](Game *g) {
         g->Edit([](b2PolygonShape &s) {
             for (b2Vec2 &v : s.m_vertices)
                 v *= 1e38f;
         });
     }},
    {"a count of 2", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_count = 2; }); }},
    {"a count of 1", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_count = 1; }); }},
    {"a count of 0", [](Game *g) { g->Edit([](b2PolygonShape &s) { s.m_count = 0; }); }},
    // The same of a sensor.
    {"a sensor's radius becomes NaN", [](Game *g) { g->Polygon(g->sensor).m_radius = kNone; }},
    {"a sensor's radius becomes negative", [](Game *g) { g->Polygon(g->sensor).m_radius = -0.6f; }},
    {"a sensor's vertex becomes NaN", [](Game *g) { g->Polygon(g->sensor).m_vertices[1].x = kNone; }},
    {"a sensor's vertex becomes 1e38", [](Game *g) { g->Polygon(g->sensor).m_vertices[1].x = 1e38f; }},
    {"a sensor's vertex makes a dent", [](Game *g) { g->Polygon(g->sensor).m_vertices[2].Set(0.0f, -0.4f); }},
    {"a sensor's vertices are exchanged",
     [](Game *g) { std::swap(g->Polygon(g->sensor).m_vertices[0], g->Polygon(g->sensor).m_vertices[1]); }},
    {"a sensor's vertices become equal",
     [](Game *g) {
         for (b2Vec2 &v : g->Polygon(g->sensor).m_vertices)
             v = g->Polygon(g->sensor).m_vertices[0];
     }},
    {"a sensor's normals become NaN",
     [](Game *g) {
         for (b2Vec2 &n : g->Polygon(g->sensor).m_normals)
             n.Set(kNone, kNone);
     }},
    {"a sensor's normals are turned round",
     [](Game *g) {
         for (b2Vec2 &n : g->Polygon(g->sensor).m_normals)
             n = -n;
     }},
    {"a sensor has a count of 1", [](Game *g) { g->Polygon(g->sensor).m_count = 1; }},
    // `Set`, and what comes of it.
    {"`Set` of 2 points", [](Game *g) { g->DropPoints({{0, 0}, {1, 0}}); }},
    {"`Set` of 3 points on a line", [](Game *g) { g->DropPoints({{0, 0}, {1, 1}, {2, 2}}); }},
    {"`Set` of 9 points",
     [](Game *g) {
         g->DropPoints({{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 3}, {0, 3}, {-1, 2}, {-1, 1}, {-0.5f, 0.5f}});
     }},
    {"`Set` of points that are there twice",
     [](Game *g) { g->DropPoints({{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}); }},
    {"`Set` in clockwise order", [](Game *g) { g->DropPoints({{0, 0}, {0, 1}, {1, 1}, {1, 0}}); }},
    {"`Set` with a dent", [](Game *g) { g->DropPoints({{0, 0}, {0.5f, 0.4f}, {1, 0}, {1, 1}, {0, 1}}); }},
    {"`Set` with a NaN", [](Game *g) { g->DropPoints({{0, 0}, {1, kNone}, {1, 1}, {0, 1}}); }},
    {"`Set` with an infinity", [](Game *g) { g->DropPoints({{0, 0}, {kInfinite, 0}, {1, 1}, {0, 1}}); }},
    {"`Set` of a square of 1e38", [](Game *g) { g->DropPoints({{0, 0}, {1e38f, 0}, {1e38f, 1e38f}, {0, 1e38f}}); }},
    {"`Set` of a square of 1e-38",
     [](Game *g) { g->DropPoints({{0, 0}, {1e-38f, 0}, {1e-38f, 1e-38f}, {0, 1e-38f}}); }},
    {"`SetAsBox` of NaN", [](Game *g) { g->DropBox(kNone, 1.0f); }},
    {"`SetAsBox` of a negative width", [](Game *g) { g->DropBox(-0.5f, 0.5f); }},
    {"`SetAsBox` of 0", [](Game *g) { g->DropBox(0.0f, 0.5f); }},
    {"`SetAsBox` of 1e-38", [](Game *g) { g->DropBox(1e-38f, 0.5f); }},
    {"`SetAsBox` of 1e9", [](Game *g) { g->DropBox(1e9f, 0.5f); }},
    {"`SetAsBox` of 1e38", [](Game *g) { g->DropBox(1e38f, 1e38f); }},
    // Definitions.
    {"a body defined at NaN", [](Game *g) { g->Define([](b2BodyDef *d) { d->position.x = kNone; }); }},
    {"a body defined with an angle of NaN", [](Game *g) { g->Define([](b2BodyDef *d) { d->angle = kNone; }); }},
    {"a body defined with a velocity of NaN",
     [](Game *g) { g->Define([](b2BodyDef *d) { d->linearVelocity.y = kNone; }); }},
    {"a body defined at 1e38", [](Game *g) { g->Define([](b2BodyDef *d) { d->position.x = 1e38f; }); }},
    {"a gravity scale of NaN", [](Game *g) { g->Define([](b2BodyDef *d) { d->gravityScale = kNone; }); }},
    {"a density of NaN",
     [](Game *g) {
         b2PolygonShape shape;
         shape.SetAsBox(0.5f, 0.5f);
         g->Drop(shape, kNone);
     }},
    {"a negative density",
     [](Game *g) {
         b2PolygonShape shape;
         shape.SetAsBox(0.5f, 0.5f);
         g->Drop(shape, -1.0f);
     }},
    // What Box2D asserts in its loops over contacts.
    {"a filter puts the body out of the world that gets a contact",
     [](Game *g) { g->DropNearPlank([](b2Body *b) { b->SetEnabled(false); }); }},
    {"a filter makes the body kinematic that gets a contact with a static one",
     [](Game *g) { g->DropNearPlank([](b2Body *b) { b->SetType(b2_kinematicBody); }); }},
    {"a listener steps the world while a body is put out of it",
     [](Game *g) { g->AddInSensor()->SetEnabled(false); }},
    {"a listener steps the world while a body becomes kinematic",
     [](Game *g) { g->AddInSensor()->SetType(b2_kinematicBody); }},
};

void Say(const Hash &hash) {
    char line[32];
    const int length = std::snprintf(line, sizeof line, "%016" PRIx64 "\n", hash.Value());
    if (write(STDOUT_FILENO, line, static_cast<size_t>(length)) != length)
        std::_Exit(3);
}

void Play(Game *game, int steps, Hash *hash) {
    for (int i = 0; i < steps; ++i) {
        game->world.Step(game->timeStep, game->velocityIterations, game->positionIterations);
        hash->Add(game->world);
        Say(*hash);
    }
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 2) {
        for (const BadThing &thing : kBadThings)
            std::printf("%s\n", thing.name);
        return 0;
    }
    const auto number = static_cast<size_t>(std::atoi(argv[1]));
    if (number >= std::size(kBadThings))
        return 2;
    Game game;
    Hash hash;
    Play(&game, 20, &hash);
    kBadThings[number].happen(&game);
    Play(&game, 25, &hash);
    // On in a good way.
    game.timeStep = 1.0f / 60.0f;
    game.velocityIterations = 8;
    game.positionIterations = 3;
    Play(&game, 5, &hash);
    return 0;
}
