// SPDX-License-Identifier: MIT
// How worlds of polygons of any size behave: piles rest and gain no energy, stacks stand, wheels roll like
// discs. The same worlds of many stock fixtures and of circles are the controls.
#include "boomerang/convex_shape.h"
#include "box2d_shapes.h"
#include "cases.h"
#include "small_world.h"

namespace {

enum class Kind { One, Many, Circle };

/// What Box2D keeps between two polygons that touch.
constexpr float kSkins = 2.0f * b2_polygonRadius;
/// Box2D itself leaves one; a pile has a weight besides.
constexpr float kMostOverlap = 2.5f * b2_linearSlop;

/// A disc-like shape of either kind, made once for many bodies.
class Coin {
public:
    Coin(Kind kind, int vertices, float radius, float phase = 0.0f) : m_kind(kind) {
        const std::vector<b2Vec2> circle = shapes::Circle(vertices, double{radius}, 0.0, 0.0, double{phase});
        m_circle.m_radius = radius;
        if (kind == Kind::One)
            REQUIRE(m_one.Set(circle.data(), vertices) == BMR_OK);
        for (int first = 1; kind == Kind::Many && first < vertices - 1; first += 6) {
            std::vector<b2Vec2> piece = {circle[0]};
            for (int i = first; i <= std::min(first + 6, vertices - 1); ++i)
                piece.push_back(circle[static_cast<size_t>(i)]);
            m_pieces.emplace_back().Set(piece.data(), static_cast<int32>(piece.size()));
        }
    }

    b2Body *AddTo(b2World &world, b2Vec2 at, float angle, float friction) const {
        b2Body *body = AddBody(world, b2_dynamicBody, at, angle);
        b2FixtureDef fixture;
        fixture.density = 1.0f;
        fixture.friction = friction;
        auto add = [&](const b2Shape &shape) {
            fixture.shape = &shape;
            body->CreateFixture(&fixture);
        };
        if (m_kind == Kind::One)
            add(m_one);
        else if (m_kind == Kind::Circle)
            add(m_circle);
        for (const b2PolygonShape &piece : m_pieces)
            add(piece);
        return body;
    }

private:
    Kind m_kind;
    bmr::ConvexShape m_one;
    b2CircleShape m_circle;
    std::vector<b2PolygonShape> m_pieces;
};

void AddGround(b2World &world, b2Vec2 half, b2Vec2 at, float angle, float friction) {
    AddBox(world, b2_staticBody, at, half, angle)->GetFixtureList()->SetFriction(friction);
}

void Step(b2World &world) {
    world.Step(1.0f / 60.0f, 8, 3);
}

bool AllSleep(const b2World &world) {
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        if (body->GetType() == b2_dynamicBody && body->IsAwake())
            return false;
    return true;
}

float DeepestOverlap(const b2World &world) {
    float deepest = 0.0f;
    for (const b2Contact *contact = world.GetContactList(); contact != nullptr;
         contact = contact->GetNext()) {
        b2WorldManifold points;
        contact->GetWorldManifold(&points);
        for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            deepest = std::max(deepest, -points.separations[i]);
    }
    return deepest;
}

double EnergyOf(const b2World &world) {
    double energy = 0.0;
    for (const b2Body *body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
        if (body->GetType() != b2_dynamicBody)
            continue;
        const auto mass = double{body->GetMass()}, spin = double{body->GetAngularVelocity()};
        energy += 0.5 * mass * double{body->GetLinearVelocity().LengthSquared()} +
                  0.5 * double{body->GetInertia()} * spin * spin -
                  mass * double{b2Dot(world.GetGravity(), body->GetPosition())};
    }
    return energy;
}

struct Rest {
    int step = -1; ///< from which on all slept
    float overlap = 0.0f;
    double gain = 0.0; ///< the most that the energy rose above what it was at first
};

constexpr int kMostSteps = 4000;

/// `coins` fall into a trough, which is narrow, so that they lie on each other.
Rest DropPile(Kind kind, int vertices, int coins, bool forget = false) {
    constexpr float radius = 0.5f, spacing = 1.1f;
    // Six coins deep: what lies lower carries more, and overlaps by that.
    const int columns = std::max(4, coins / 6);
    const float halfWidth = 0.5f * spacing * static_cast<float>(columns) + 0.4f;
    b2World world(b2Vec2(0.0f, -10.0f));
    AddGround(world, {halfWidth + 1.0f, 1.0f}, {0.0f, -1.0f}, 0.0f, 0.3f);
    for (const float side : {-1.0f, 1.0f})
        AddGround(world, {1.0f, 30.0f}, {side * (halfWidth + 1.0f), 29.0f}, 0.0f, 0.3f);
    const Coin coin(kind, vertices, radius);
    shapes::Engine engine(7);
    for (int i = 0; i < coins; ++i) {
        const float column = static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1),
                    shift = shapes::UniformF(engine, -0.04, 0.04);
        coin.AddTo(world, {spacing * column + shift, 0.7f + spacing * static_cast<float>(i / columns)},
                   shapes::UniformF(engine, -3.0, 3.0), 0.3f);
    }
    Rest rest;
    const double start = EnergyOf(world);
    for (int step = 0; step < kMostSteps && rest.step < 0; ++step) {
        Step(world);
        rest.gain = std::max(rest.gain, EnergyOf(world) - start);
        if (AllSleep(world))
            rest.step = step;
        // The control: what a contact remembers of its points is not what it finds in the next step.
        for (b2Contact *contact = world.GetContactList(); forget && contact != nullptr;
             contact = contact->GetNext())
            for (b2ManifoldPoint &point : contact->GetManifold()->points)
                point.normalImpulse = point.tangentImpulse = 0.0f;
    }
    rest.overlap = DeepestOverlap(world);
    return rest;
}

/// How far a wheel rolls in so many steps down a slope, from rest.
double RollDown(Kind kind, int vertices, float phase) {
    constexpr float slope = 0.15f, radius = 0.5f;
    constexpr int steps = 300;
    b2World world(b2Vec2(0.0f, -10.0f));
    const b2Rot along(-slope);
    AddGround(world, {60.0f, 1.0f}, b2Mul(along, b2Vec2(0.0f, -1.0f)), -slope, 0.9f);
    const float height = radius + (kind == Kind::Circle ? b2_polygonRadius : kSkins);
    b2Body *wheel =
        Coin(kind, vertices, radius).AddTo(world, b2Mul(along, b2Vec2(-30.0f, height)), phase, 0.9f);
    const b2Vec2 start = wheel->GetPosition();
    for (int i = 0; i < steps; ++i)
        Step(world);
    return double{b2Distance(start, wheel->GetPosition())};
}

/// The same of a disc that rolls without slipping on its skin, with Box2D's own way to integrate.
double IdealRoll(float skin) {
    constexpr double slope = 0.15, radius = 0.5, dt = 1.0 / 60.0;
    constexpr int steps = 300;
    const double rolling = radius + double{skin};
    const double acceleration = 10.0 * std::sin(slope) / (1.0 + 0.5 * radius * radius / (rolling * rolling));
    return acceleration * dt * dt * 0.5 * steps * (steps + 1);
}

double MeanRoll(Kind kind, int vertices) {
    constexpr int wheels = 4;
    double sum = 0.0;
    for (int i = 0; i < wheels; ++i)
        sum += RollDown(kind, vertices, 0.37f * static_cast<float>(i));
    return sum / wheels;
}

} // namespace

TEST_CASE("piles of polygons of any size come to rest, and do not sink into each other") {
    const auto coins = static_cast<int>(std::clamp<size_t>(test_scaled(24), 8, 200));
    for (const int vertices : {9, 16, 64, 256, 1024, 4096}) {
        CAPTURE(vertices);
        const Rest rest = DropPile(Kind::One, vertices, coins);
        CHECK(rest.step >= 0);
        CHECK(rest.overlap <= kMostOverlap);
        CHECK(rest.gain <= 0.0);
        MESSAGE(vertices << " vertices: asleep at step " << rest.step << ", overlap " << rest.overlap);
    }
}

TEST_CASE("control: a pile whose impulses are forgotten neither rests as soon nor lies as high") {
    const Rest kept = DropPile(Kind::One, 64, 24), forgotten = DropPile(Kind::One, 64, 24, true);
    MESSAGE("kept: step " << kept.step << ", overlap " << kept.overlap << "; forgotten: step "
                          << forgotten.step << ", overlap " << forgotten.overlap);
    const bool worse = forgotten.step < 0 || forgotten.overlap > kMostOverlap;
    CHECK(worse);
}

TEST_CASE("ten 64-gons stand on each other and sleep; many fixtures do not stand so still") {
    constexpr int vertices = 64, coins = 10;
    constexpr float radius = 0.5f;
    const auto turn = static_cast<float>(M_PI / vertices);
    const float apothem = radius * std::cos(turn);
    auto drift = [&](Kind kind, int *asleepFrom) {
        b2World world(b2Vec2(0.0f, -10.0f));
        AddGround(world, {20.0f, 1.0f}, {0.0f, -1.0f}, 0.0f, 0.6f);
        const Coin coin(kind, vertices, radius, -0.5f * b2_pi + turn);
        std::vector<b2Body *> bodies;
        for (int i = 0; i < coins; ++i)
            bodies.push_back(coin.AddTo(
                world, {0.0f, apothem + kSkins + static_cast<float>(i) * (2.0f * apothem + kSkins)}, 0.0f,
                0.6f));
        *asleepFrom = -1;
        for (int step = 0; step < 600; ++step) {
            Step(world);
            if (AllSleep(world) && *asleepFrom < 0)
                *asleepFrom = step;
        }
        float most = 0.0f;
        for (const b2Body *body : bodies)
            most = std::max(most, std::fabs(body->GetPosition().x));
        return most;
    };
    int one = 0, many = 0;
    const float ofOne = drift(Kind::One, &one), ofMany = drift(Kind::Many, &many);
    MESSAGE("one: drift " << ofOne << ", asleep from " << one << "; many: " << ofMany << ", " << many);
    CHECK(ofOne < 1e-3f);
    CHECK(one >= 0);
    CHECK(ofMany > ofOne);
}

TEST_CASE("wheels of many vertices roll as discs do") {
    const double ideal = IdealRoll(b2_polygonRadius);
    for (const int vertices : {1024, 4096}) {
        CAPTURE(vertices);
        const double rolled = MeanRoll(Kind::One, vertices);
        MESSAGE(vertices << " vertices: " << rolled << " of " << ideal);
        CHECK(std::fabs(rolled / ideal - 1.0) < 0.02);
    }
    // The circle is the check of the ideal; an octagon, which rolls like none, that of the check.
    CHECK(std::fabs(RollDown(Kind::Circle, 0, 0.0f) / IdealRoll(0.0f) - 1.0) < 0.02);
    CHECK(MeanRoll(Kind::Many, 8) < 0.9 * ideal);
}

TEST_CASE("wheels of fewer vertices roll no worse than those of many fixtures") {
    const double ideal = IdealRoll(b2_polygonRadius);
    for (const int vertices : {64, 256}) {
        CAPTURE(vertices);
        const double one = MeanRoll(Kind::One, vertices), many = MeanRoll(Kind::Many, vertices);
        MESSAGE(vertices << " vertices: one " << one << ", many " << many << " of " << ideal);
        CHECK(std::fabs(one - ideal) <= std::fabs(many - ideal));
    }
}

namespace {

struct Ride {
    float lowest = 10.0f, highest = 0.0f; ///< of the wheel's middle, once it has settled
    float speed = 0.0f;                   ///< at the end
};

/// A wheel rolls at 10 m/s over a flat chain of links of 1 m, whose edges are one-sided and know their
/// neighbours.
Ride RideChain(Kind kind, int vertices) {
    constexpr float speed = 10.0f, radius = 0.5f;
    constexpr int steps = 600, settled = 20, links = 140;
    b2World world(b2Vec2(0.0f, -10.0f));
    std::vector<b2Vec2> line;
    for (int i = links; i >= -5; --i)
        line.emplace_back(static_cast<float>(i), 0.0f);
    b2ChainShape chain;
    chain.CreateChain(line.data(), static_cast<int32>(line.size()), line.front() + b2Vec2(1.0f, 0.0f),
                      line.back() - b2Vec2(1.0f, 0.0f));
    b2FixtureDef ground;
    ground.shape = &chain;
    ground.friction = 1.0f;
    const b2BodyDef still;
    world.CreateBody(&still)->CreateFixture(&ground);
    b2Body *wheel = Coin(kind, vertices, radius).AddTo(world, {0.0f, radius + b2_polygonRadius}, 0.0f, 1.0f);
    wheel->SetLinearVelocity({speed, 0.0f});
    wheel->SetAngularVelocity(-speed / (radius + b2_polygonRadius));
    Ride ride;
    for (int i = 0; i < steps; ++i) {
        Step(world);
        if (i < settled)
            continue;
        ride.lowest = std::min(ride.lowest, wheel->GetPosition().y);
        ride.highest = std::max(ride.highest, wheel->GetPosition().y);
    }
    ride.speed = wheel->GetLinearVelocity().x;
    return ride;
}

} // namespace

TEST_CASE("a wheel of many vertices rolls over the joints of a flat chain as over a plane") {
    const Ride circle = RideChain(Kind::Circle, 0);
    for (const int vertices : {1024, 4096}) {
        CAPTURE(vertices);
        const Ride one = RideChain(Kind::One, vertices);
        MESSAGE(vertices << " vertices: height " << one.lowest << " to " << one.highest << ", " << one.speed
                         << " m/s; circle: " << circle.speed);
        CHECK(one.highest - one.lowest < 2.0f * b2_linearSlop);
        CHECK(one.speed > 0.98f * circle.speed);
    }
    // The control: of many fixtures, each under Box2D's own rule, it stumbles.
    const Ride many = RideChain(Kind::Many, 64), few = RideChain(Kind::Many, 8);
    MESSAGE("many fixtures: 64 vertices " << many.lowest << " to " << many.highest << ", " << many.speed
                                          << " m/s; 8: " << few.lowest << " to " << few.highest);
    CHECK(many.highest - many.lowest > 4.0f * b2_linearSlop);
    CHECK(few.highest - few.lowest > 4.0f * b2_linearSlop);
}
