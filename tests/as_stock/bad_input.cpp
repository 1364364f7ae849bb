// SPDX-License-Identifier: MIT
// Worlds to which one bad thing happens, with a number that is none, say. What they do then may mean nothing,
// and is stock's, unless one of Box2D's assertions ends the program: then it is as safe as with stock.
#include <csignal>
#include <set>

#include "as_stock.h"

using namespace as_stock;

namespace {

/// What values are called: a name of a bad thing has them in the place of its *.
struct Value {
    const char *name;
    float number;
};
const Value kNone = {"NaN", NAN}, kInfinite = {"infinity", INFINITY}, kZero = {"0", 0.0f},
            kHuge = {"1e38", 1e38f}, kLarge = {"1e9", 1e9f}, kTiny = {"1e-38", 1e-38f},
            kMinus = {"-100", -100.0f};

/// What happens to, and what the world is stepped with from then on.
struct BadGame : Game {
    b2Body *box, *wheel, *bullet; ///< in the middle of the others
    b2Body *sensor;               ///< through which they fall
    float timeStep = 1.0f / 60.0f;
    int32 velocityIterations = 8, positionIterations = 3;

    /// Few bodies: where a box is no number it overlaps all others.
    explicit BadGame(Run &run) : Game(run, {0.0f, -10.0f}) {
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
    void Drop(const b2PolygonShape &shape, float density = 1.0f) {
        AddBody(world, b2_dynamicBody, {0.5f, 8.0f})->CreateFixture(&shape, density);
    }
};

struct BadThing {
    std::string name;
    std::function<void(BadGame &)> happen;
};
std::vector<BadThing> badThings;

void Happens(const std::string &name, std::function<void(BadGame &)> happen) {
    badThings.push_back({name, std::move(happen)});
}

/// The same with each of the values.
void Each(const std::string &name, const std::vector<Value> &values, void (*happen)(BadGame &, float)) {
    for (const Value &value : values) {
        const size_t star = name.find('*');
        Happens(name.substr(0, star) + value.name + name.substr(star + 1),
                [happen, value](BadGame &g) { happen(g, value.number); });
    }
}

/// In its place: the polygon of the box and of a part of the wheel; and that of the sensor.
void Edit(const std::string &name, void (*edit)(b2PolygonShape &)) {
    Happens(name, [edit](BadGame &g) {
        edit(*PolygonOf(g.box));
        edit(*PolygonOf(g.wheel));
    });
    Happens(name + ", of a sensor", [edit](BadGame &g) { edit(*PolygonOf(g.sensor)); });
}

void Scale(b2PolygonShape &shape, float x, float y) {
    for (b2Vec2 &v : shape.m_vertices)
        v.Set(x * v.x, y * v.y);
}

void SetPoints(const char *name, const std::vector<b2Vec2> &points) {
    Happens(name, [points](BadGame &g) {
        b2PolygonShape shape;
        shape.Set(points.data(), static_cast<int32>(points.size()));
        g.Drop(shape);
    });
}

void DropBox(BadGame &g, float halfWidth, float halfHeight, float density = 1.0f) {
    b2PolygonShape shape;
    shape.SetAsBox(halfWidth, halfHeight);
    g.Drop(shape, density);
}

void Define(const char *name, const std::vector<Value> &values, void (*spoil)(b2BodyDef &, float)) {
    for (const Value &value : values)
        Happens(name + std::string(value.name), [spoil, value](BadGame &g) {
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = {0.5f, 8.0f};
            spoil(def, value.number);
            g.Box(g.world.CreateBody(&def), 0.5f, 0.5f);
        });
}

void ListPlacesAndMotions() {
    Happens("nothing", [](BadGame &) {});
    Each("a body is moved to *", {kNone, kInfinite, kHuge, kLarge, kTiny}, [](BadGame &g, float v) {
        g.box->SetTransform({v, 7.0f}, 0.0f);
    });
    Each("a body is turned to *", {kNone, kInfinite, kHuge}, [](BadGame &g, float v) {
        g.box->SetTransform({0.0f, 7.0f}, v);
    });
    Each("a body of many fixtures is moved to *", {kNone, kHuge}, [](BadGame &g, float v) {
        g.wheel->SetTransform({v, -v}, 0.0f);
    });
    Each("a body of many fixtures is turned to *", {kNone}, [](BadGame &g, float v) {
        g.wheel->SetTransform({0.0f, 4.0f}, v);
    });
    Happens("a body of many fixtures is put into others",
            [](BadGame &g) { g.wheel->SetTransform(g.box->GetPosition(), 0.0f); });
    Each("a bullet is moved to *", {kNone}, [](BadGame &g, float v) {
        g.bullet->SetTransform({v, 7.0f}, 0.0f);
    });
    Each("a body is moved to *, and back", {kNone}, [](BadGame &g, float v) {
        g.box->SetTransform({v, 7.0f}, v);
        g.box->SetTransform({0.0f, 7.0f}, 0.0f);
    });
    Each("without continuous physics a body is moved to *", {kNone}, [](BadGame &g, float v) {
        g.world.SetContinuousPhysics(false);
        g.box->SetTransform({v, 7.0f}, 0.0f);
        g.wheel->SetTransform({v, 4.0f}, v);
    });
    Each("the origin is shifted to *", {kNone, kHuge}, [](BadGame &g, float v) {
        g.world.ShiftOrigin({v, 0.0f});
    });
    Each("a velocity of *", {kNone, kInfinite, kHuge, kTiny}, [](BadGame &g, float v) {
        g.box->SetLinearVelocity({v == INFINITY ? 0.0f : v, -v});
    });
    Each("a bullet's velocity of *", {kNone, kHuge}, [](BadGame &g, float v) {
        g.bullet->SetLinearVelocity({v, 0.0f});
    });
    Each("a spin of *", {kNone, kInfinite, kHuge},
         [](BadGame &g, float v) { (v != v ? g.box : g.wheel)->SetAngularVelocity(v); });
    Each("without continuous physics a velocity of *", {kNone}, [](BadGame &g, float v) {
        g.world.SetContinuousPhysics(false);
        g.box->SetLinearVelocity({v, 0.0f});
        g.wheel->SetAngularVelocity(v);
    });
    Each("a force of *", {kNone}, [](BadGame &g, float v) { g.box->ApplyForceToCenter({v, 0.0f}, true); });
    Each("an impulse of *", {kHuge}, [](BadGame &g, float v) {
        g.box->ApplyLinearImpulseToCenter({v, 0.0f}, true);
    });
    Each("a gravity of *", {kNone, kHuge}, [](BadGame &g, float v) {
        g.world.SetGravity({v == v ? 0.0f : v, -v});
    });
    Each("a damping of *", {kNone, kMinus}, [](BadGame &g, float v) { g.box->SetLinearDamping(v); });
    Each("a friction of *", {kNone}, [](BadGame &g, float v) { g.box->GetFixtureList()->SetFriction(v); });
    Each("a restitution of *", {kHuge},
         [](BadGame &g, float v) { g.box->GetFixtureList()->SetRestitution(v); });
    Each("a mass of *", {kNone}, [](BadGame &g, float v) {
        const b2MassData mass = {v, {0.0f, 0.0f}, 1.0f};
        g.box->SetMassData(&mass);
    });
    Happens("an inertia that its centre makes negative", [](BadGame &g) {
        const b2MassData mass = {1.0f, {5.0f, 0.0f}, 1.0f};
        g.box->SetMassData(&mass);
    });
    Each("time steps of *", {kZero, kLarge, kTiny, kHuge, kNone, kInfinite, {"-1/60", -1.0f / 60.0f}},
         [](BadGame &g, float v) { g.timeStep = v; });
    Each("numbers of iterations of *", {kZero, {"-7", -7.0f}},
         [](BadGame &g, float v) { g.velocityIterations = g.positionIterations = static_cast<int32>(v); });
}

void ListEdits() {
    Edit("a radius of NaN", [](b2PolygonShape &s) { s.m_radius = NAN; });
    Edit("a radius of 0", [](b2PolygonShape &s) { s.m_radius = 0.0f; });
    Edit("a radius of 1e-38", [](b2PolygonShape &s) { s.m_radius = 1e-38f; });
    Edit("a radius of 1e38", [](b2PolygonShape &s) { s.m_radius = 1e38f; });
    Edit("a radius of -0.1", [](b2PolygonShape &s) { s.m_radius = -0.1f; });
    Edit("a negative radius larger than the polygon", [](b2PolygonShape &s) { s.m_radius = -10.0f; });
    Edit("a vertex becomes NaN", [](b2PolygonShape &s) { s.m_vertices[1].x = NAN; });
    Edit("a vertex becomes infinite", [](b2PolygonShape &s) { s.m_vertices[2].y = INFINITY; });
    Edit("a vertex becomes 1e38", [](b2PolygonShape &s) { s.m_vertices[1].x = 1e38f; });
    Edit("a vertex makes a dent", [](b2PolygonShape &s) { s.m_vertices[1] *= -0.5f; });
    Edit("two vertices are exchanged",
         [](b2PolygonShape &s) { std::swap(s.m_vertices[0], s.m_vertices[1]); });
    Edit("all vertices become equal",
         [](b2PolygonShape &s) { std::fill_n(s.m_vertices, s.m_count, b2Vec2(s.m_vertices[0])); });
    Edit("all vertices come onto one line", [](b2PolygonShape &s) { Scale(s, 1.0f, 0.0f); });
    Edit("all vertices shrink to 1e-38", [](b2PolygonShape &s) { Scale(s, 1e-38f, 1e-38f); });
    Edit("all vertices grow to 1e38", [](b2PolygonShape &s) { Scale(s, 1e38f, 1e38f); });
    Edit("the order becomes clockwise",
         [](b2PolygonShape &s) { std::reverse(s.m_vertices, s.m_vertices + s.m_count); });
    Edit("a normal becomes NaN", [](b2PolygonShape &s) { s.m_normals[0].x = NAN; });
    Edit("all normals become NaN",
         [](b2PolygonShape &s) { std::fill_n(s.m_normals, s.m_count, b2Vec2(NAN, NAN)); });
    Edit("all normals are turned round", [](b2PolygonShape &s) {
        for (b2Vec2 &n : s.m_normals)
            n = -n;
    });
    Edit("a count of 2", [](b2PolygonShape &s) { s.m_count = 2; });
    Edit("a count of 1", [](b2PolygonShape &s) { s.m_count = 1; });
    Edit("a count of 0", [](b2PolygonShape &s) { s.m_count = 0; });
}

void ListDefinitions() {
    SetPoints("Set of 2 points", {{0, 0}, {1, 0}});
    SetPoints("Set of 3 points on a line", {{0, 0}, {1, 1}, {2, 2}});
    SetPoints("Set of 9 points",
              {{0, 0}, {1, 0}, {2, 1}, {2, 2}, {1, 3}, {0, 3}, {-1, 2}, {-1, 1}, {-0.5f, 0.5f}});
    SetPoints("Set of points that are there twice", {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}});
    SetPoints("Set in clockwise order", {{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    SetPoints("Set with a dent", {{0, 0}, {0.5f, 0.4f}, {1, 0}, {1, 1}, {0, 1}});
    SetPoints("Set with a NaN", {{0, 0}, {1, NAN}, {1, 1}, {0, 1}});
    SetPoints("Set with an infinity", {{0, 0}, {INFINITY, 0}, {1, 1}, {0, 1}});
    SetPoints("Set of a square of 1e38", {{0, 0}, {1e38f, 0}, {1e38f, 1e38f}, {0, 1e38f}});
    SetPoints("Set of a square of 1e-38", {{0, 0}, {1e-38f, 0}, {1e-38f, 1e-38f}, {0, 1e-38f}});
    Each("SetAsBox of *", {kNone, kMinus, kZero, kTiny, kLarge, kHuge},
         [](BadGame &g, float v) { DropBox(g, v, v == 1e38f ? v : 0.5f); });
    Define("a body defined at ", {kNone, kHuge}, [](b2BodyDef &d, float v) { d.position.x = v; });
    Define("a body defined with an angle of ", {kNone}, [](b2BodyDef &d, float v) { d.angle = v; });
    Define("a body defined with a velocity of ", {kNone},
           [](b2BodyDef &d, float v) { d.linearVelocity.y = v; });
    Define("a gravity scale of ", {kNone}, [](b2BodyDef &d, float v) { d.gravityScale = v; });
    Each("a density of *", {kNone, {"-1", -1.0f}}, [](BadGame &g, float v) { DropBox(g, 0.5f, 0.5f, v); });
}

/// Which of them Box2D's assertions do not let pass.
const std::set<std::string> kAborts = {"a mass of NaN",
                                       "an inertia that its centre makes negative",
                                       "a radius of NaN",
                                       "a vertex becomes infinite",
                                       "all vertices grow to 1e38",
                                       "a count of 0",
                                       "a count of 0, of a sensor",
                                       "Set of 2 points",
                                       "Set of 3 points on a line",
                                       "Set of 9 points",
                                       "Set with a NaN",
                                       "Set with an infinity",
                                       "Set of a square of 1e-38",
                                       "SetAsBox of NaN",
                                       "SetAsBox of -100",
                                       "SetAsBox of 0",
                                       "SetAsBox of 1e-38",
                                       "a body defined at NaN",
                                       "a body defined with an angle of NaN",
                                       "a body defined with a velocity of NaN"};

Run *playing; ///< in this process
bool mayAbort;

void SayThatItAborts(int) {
    playing->Print("Box2D aborts");
    playing->Stage(mayAbort, "Box2D lets it pass");
    playing->~Run();
    test_leave(0);
}

/// Is the x of a body no number? It never gets one again, and each time of impact with it takes Box2D all
/// the iterations that it allows itself.
bool HasNowhere(const b2World &world) {
    for (const b2Body *b = world.GetBodyList(); b != nullptr; b = b->GetNext())
        if (!b2IsValid(b->GetPosition().x))
            return true;
    return false;
}

/// A step with such a body counts for four.
void Play(BadGame *game, int steps) {
    for (int left = steps; left > 0; left -= HasNowhere(game->world) ? 4 : 1) {
        game->world.Step(game->timeStep, game->velocityIterations, game->positionIterations);
        game->WriteDown();
    }
}

void PlayWith(const BadThing &thing, Run &run) {
    playing = &run;
    mayAbort = kAborts.count(thing.name) != 0;
    std::signal(SIGABRT, SayThatItAborts);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) // Box2D's assertions
        run.Print("!stderr stays");
    BadGame game(run);
    Play(&game, 20);
    if (mayAbort)
        run.BreaksRules();
    thing.happen(game);
    Play(&game, 25);
    // On in a good way.
    game.timeStep = 1.0f / 60.0f;
    game.velocityIterations = 8;
    game.positionIterations = 3;
    Play(&game, 5);
    run.Stage(!mayAbort || run.HasPlugin(), "Box2D ends the program");
}

} // namespace

TEST_CASE("bad input: a world does what stock's does, whatever happens to it") {
    ListPlacesAndMotions();
    ListEdits();
    ListDefinitions();
    std::set<std::string> played;
    constexpr size_t kEvery = 4; // of them is looked at once more
    for (size_t i = 0; i < badThings.size(); ++i) {
        CAPTURE(badThings[i].name);
        const Scenario play = [i](Run &run) { PlayWith(badThings[i], run); };
        AsStock(play);
        if (i % kEvery == 0)
            played.insert(InChild(play));
    }
    CHECK(played.size() >
          badThings.size() / kEvery / 2); // (a number that is none spreads, and is one number)
}
