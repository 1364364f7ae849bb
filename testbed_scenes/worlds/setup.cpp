// SPDX-License-Identifier: MIT
#include "worlds/world.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include "boomerang/families.h"

namespace testbed {
namespace {

constexpr int kTries = 3000;
/// Between any two, in their radii: a start that is not yet near.
constexpr double kApart = 1.01;

/// Disks of radii up to `largest` and from half of that, in cells twice as wide as that.
class Layer {
public:
    explicit Layer(double largest) : m_largest(largest) {}

    void Add(bmr_vec2 at, double radius) { m_cells[CellOf(at.x, at.y)].push_back({at, radius}); }

    bool IsFree(bmr_vec2 at, double radius) const {
        const double reach = kApart * (radius + m_largest);
        const auto [left, bottom] = CellOf(at.x - reach, at.y - reach);
        const auto [right, top] = CellOf(at.x + reach, at.y + reach);
        for (int64_t column = left; column <= right; ++column)
            for (int64_t row = bottom; row <= top; ++row) {
                const auto cell = m_cells.find({column, row});
                if (cell == m_cells.end())
                    continue;
                for (const auto &[other, its] : cell->second)
                    if (std::hypot(other.x - at.x, other.y - at.y) < kApart * (its + radius))
                        return false;
            }
        return true;
    }

private:
    std::pair<int64_t, int64_t> CellOf(double x, double y) const {
        return {static_cast<int64_t>(std::floor(0.5 * x / m_largest)),
                static_cast<int64_t>(std::floor(0.5 * y / m_largest))};
    }

    double m_largest;
    std::map<std::pair<int64_t, int64_t>, std::vector<std::pair<bmr_vec2, double>>> m_cells;
};

/// Places for disks of these radii in a box, drawn one by one, the largest first, so that no two meet, nor
/// one and a side of the box (in a periodic box: nor one and another's image). False where there was no room
/// after many tries: equal disks take about half of the box. O(disks) for sizes of any ratio.
bool PlaceDisks(const std::vector<double> &radii, bmr_vec2 low, bmr_vec2 high, bool periodic, Dice &dice,
                std::vector<bmr_vec2> *places) {
    const bmr_vec2 size = bmr_sub(high, low);
    std::vector<size_t> order(radii.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return radii[a] > radii[b]; });
    places->assign(radii.size(), low);
    std::map<int, Layer> layers; // by the power of two of the radius
    for (const size_t index : order) {
        const double radius = radii[index], border = periodic ? 0.0 : kApart * radius;
        if (2.0 * border >= std::min(size.x, size.y))
            return false;
        bool placed = false;
        for (int i = 0; i < kTries && !placed; ++i) {
            const bmr_vec2 at =
                bmr_vec2_make(dice.Uniform(border, size.x - border), dice.Uniform(border, size.y - border));
            if (!std::all_of(layers.begin(), layers.end(),
                             [&](const auto &layer) { return layer.second.IsFree(at, radius); }))
                continue;
            int power = 0;
            std::frexp(radius, &power);
            Layer &layer = layers.try_emplace(power, std::ldexp(1.0, power)).first->second;
            const int images = periodic ? 1 : 0; // on each side
            for (int x = -images; x <= images; ++x)
                for (int y = -images; y <= images; ++y)
                    layer.Add(bmr_add(at, bmr_vec2_make(x * size.x, y * size.y)), radius);
            (*places)[index] = bmr_add(low, at);
            placed = true;
        }
        if (!placed)
            return false;
    }
    return true;
}

constexpr double kPi = 3.14159265358979323846;
/// A swarm's bodies change their plans about so often, in crossings of a body's own disk.
constexpr double kCrossingsAPlan = 3.0;
/// How much faster the fast body is than the crowd would be.
constexpr double kFast = 100.0;

WorldScene Scene(const char *name, const char *description, size_t bodies, double seconds) {
    WorldScene scene = {description, {}};
    WorldChoice &choice = scene.choice;
    choice.scene = name;
    choice.bodies = bodies;
    choice.shape = "mixed";
    choice.fewestVertices = 8;
    choice.mostVertices = 64;
    choice.density = 0.2;
    choice.seconds = seconds;
    choice.structure = "hybrid";
    return scene;
}

std::vector<WorldScene> MakeScenes() {
    std::vector<WorldScene> scenes = {
        Scene("gas", "polygons that collide elastically between four walls", 200, 20.0),
        Scene("cooling", "a granular gas in a periodic box: each collision takes energy, and clusters grow",
              200, 40.0),
        Scene("swarm", "bodies that change their plans again and again, accelerate and coast", 200, 10.0),
        Scene("asteroids", "sizes from 1 to 1000 in a periodic box, all of the same energy on average", 200,
              50.0),
        Scene("bullet", "one fast body through a crowd at rest", 200, 4.0)};
    scenes[0].choice.sizes = 2.0;
    scenes[1].choice.boundary = BMR_PERIODIC;
    scenes[1].choice.response.restitution = 0.9;
    scenes[1].choice.zeno = BMR_ZENO_ELASTIC;
    scenes[2].choice.density = 0.1;
    scenes[3].choice.boundary = BMR_PERIODIC;
    scenes[3].choice.sizes = 1000.0;
    scenes[3].choice.density = 0.05;
    return scenes;
}

/// Vertices of a polygon about their centre of mass, in a disk of the given radius about that.
std::vector<bmr_vec2> CentredPoints(bmr_ngon kind, size_t vertices, uint64_t seed, double radius) {
    std::vector<bmr_vec2> points(vertices);
    Require(bmr_ngon_points(kind, vertices, seed, points.data()), bmr_ngon_name(kind));
    const Body rough(points, Body::Hierarchies::None);
    bmr_mass mass;
    Require(bmr_polygon_mass(rough.Polygon(), &mass), bmr_ngon_name(kind));
    double reach = 0.0;
    for (bmr_vec2 &point : points) {
        point = bmr_sub(point, mass.centroid);
        reach = std::max(reach, std::hypot(point.x, point.y));
    }
    for (bmr_vec2 &point : points)
        point = bmr_scale(radius / reach, point);
    return points;
}

bmr_ngon NgonOf(const WorldChoice &choice, size_t index) {
    for (int kind = 0; kind < BMR_NGON_COUNT; ++kind)
        if (choice.shape == bmr_ngon_name(static_cast<bmr_ngon>(kind)))
            return static_cast<bmr_ngon>(kind);
    return static_cast<bmr_ngon>(index % BMR_NGON_COUNT);
}

/// The largest and the smallest first; the others evenly on the scale of logarithms.
double RadiusOf(const WorldChoice &choice, Dice &dice, size_t index) {
    if (choice.sizes <= 1.0)
        return 1.0;
    if (index < 2)
        return index == 0 ? choice.sizes : 1.0;
    return std::pow(choice.sizes, dice.Uniform(0.0, 1.0));
}

void MakePolygons(WorldSetup *setup, Dice &dice) {
    const WorldChoice &choice = setup->choice;
    const bmr_kds_info *structure = nullptr;
    Require(bmr_kds_find(choice.structure.c_str(), &structure), choice.structure);
    const Body::Hierarchies hierarchies =
        structure->hierarchy < 0 ? Body::Hierarchies::None : Body::Hierarchies::All;
    for (size_t i = 0; i < choice.bodies; ++i) {
        WorldBody body;
        body.radius = RadiusOf(choice, dice, i);
        const size_t vertices =
            choice.fewestVertices + dice.Index(choice.mostVertices - choice.fewestVertices + 1);
        body.polygon = std::make_unique<Body>(
            CentredPoints(NgonOf(choice, i), vertices, dice.Index(1U << 30U), body.radius), hierarchies);
        bmr_mass mass;
        Require(bmr_polygon_mass(body.polygon->Polygon(), &mass), "a body");
        body.area = mass.area;
        setup->bodies.push_back(std::move(body));
    }
}

void MakeBox(WorldSetup *setup) {
    double area = 0.0;
    for (const WorldBody &body : setup->bodies)
        area += body.area;
    const double half = 0.5 * std::sqrt(area / setup->choice.density);
    setup->low = bmr_vec2_make(-half, -half);
    setup->high = bmr_vec2_make(half, half);
}

void PlaceBodies(WorldSetup *setup, Dice &dice) {
    std::vector<double> radii;
    for (const WorldBody &body : setup->bodies)
        radii.push_back(body.radius);
    std::vector<bmr_vec2> places;
    if (!PlaceDisks(radii, setup->low, setup->high, setup->choice.boundary == BMR_PERIODIC, dice, &places))
        throw WorldChoiceError(
            "there is no room for these bodies at a density of " + std::to_string(setup->choice.density) +
            ": their disks must not meet at the beginning; choose less, or rounder shapes");
    for (size_t i = 0; i < places.size(); ++i)
        setup->bodies[i].pose = bmr_pose_from_angle(places[i], dice.Uniform(-kPi, kPi));
}

void SetGoing(WorldSetup *setup, Dice &dice) {
    const WorldChoice &choice = setup->choice;
    const bool crowd = choice.scene == "bullet";
    for (size_t i = 0; i < setup->bodies.size(); ++i) {
        WorldBody &body = setup->bodies[i];
        // The energy is the same on average: the smaller, the faster. The largest have the speed 1.
        const double speed = choice.sizes / body.radius * dice.Uniform(0.5, 1.5);
        const double spin = dice.Uniform(-1.0, 1.0) * speed / body.radius;
        const bmr_vec2 way = dice.Direction();
        if (crowd && i > 0)
            continue;
        body.velocity = bmr_scale(crowd ? kFast : speed, way);
        body.spin = spin;
    }
    if (choice.scene == "swarm")
        setup->planEvery = kCrossingsAPlan * 2.0;
}

} // namespace

const std::vector<WorldScene> &WorldScenes() {
    static const std::vector<WorldScene> scenes = MakeScenes();
    return scenes;
}

WorldSetup MakeWorld(const WorldChoice &choice) {
    WorldSetup setup;
    setup.choice = choice;
    Dice dice(choice.seed);
    MakePolygons(&setup, dice);
    MakeBox(&setup);
    const double width = setup.high.x - setup.low.x;
    if (choice.boundary == BMR_PERIODIC && 8.0 * choice.sizes >= width)
        throw WorldChoiceError(
            "a periodic box must be more than four of its largest bodies wide: more --bodies, a "
            "lower --density or --boundary walls");
    PlaceBodies(&setup, dice);
    SetGoing(&setup, dice);
    return setup;
}

/// xoshiro256** (Blackman, Vigna), seeded by splitmix64.
Dice::Dice(uint64_t seed) {
    for (uint64_t &word : m_state) {
        seed += 0x9e3779b97f4a7c15U;
        uint64_t mixed = seed;
        mixed = (mixed ^ (mixed >> 30U)) * 0xbf58476d1ce4e5b9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94d049bb133111ebU;
        word = mixed ^ (mixed >> 31U);
    }
}

uint64_t Dice::Next() {
    const auto turned = [](uint64_t word, unsigned by) { return (word << by) | (word >> (64U - by)); };
    const uint64_t result = turned(m_state[1] * 5U, 7) * 9U, shifted = m_state[1] << 17U;
    m_state[2] ^= m_state[0];
    m_state[3] ^= m_state[1];
    m_state[1] ^= m_state[2];
    m_state[0] ^= m_state[3];
    m_state[2] ^= shifted;
    m_state[3] = turned(m_state[3], 45);
    return result;
}

double Dice::Uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(Next() >> 11U) * 0x1p-53);
}

size_t Dice::Index(size_t count) {
    return static_cast<size_t>(Next() % count);
}

bmr_vec2 Dice::Direction() {
    const double angle = Uniform(-kPi, kPi);
    return bmr_vec2_make(std::cos(angle), std::sin(angle));
}

} // namespace testbed
