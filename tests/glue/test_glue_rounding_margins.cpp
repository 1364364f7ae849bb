// SPDX-License-Identifier: MIT
// What Box2D's three tests are really off by, from the origin to 10 km and at angles to a million radians:
// random poses about the threshold, and from each a climb towards larger errors. Within the reach the largest
// must stay below what thresholds.h leaves; beyond, it is recorded, and the glue must not answer.
// box2d_glue/glue/proofs/thresholds.md has a table of a long run.
#include <box2d/b2_distance.h>
#include <box2d/b2_time_of_impact.h>

#include "box2d_shapes.h"
#include "cases.h"
#include "exact_polygons.h"
#include "glue/proofs/overlap.h"
#include "glue/proofs/sweep_apart.h"
#include "glue/proofs/thresholds.h"

extern B2_API int32 b2_gjkMaxIters;

namespace {

using namespace shapes;

constexpr double kExtent = 5.0;

/// A few must always run, or the controls see nothing.
size_t Rounds(size_t count) {
    return std::max<size_t>(test_scaled(count), 60);
}

/// How far out, and turned how far.
struct Decade {
    double far, angle;
    bool within; ///< the reach
};
constexpr Decade kPlaces[] = {{1.0, 4.0, true},     {10.0, 4.0, true},    {100.0, 4.0, true},
                              {450.0, 4.0, true},   {1000.0, 4.0, false}, {3000.0, 4.0, false},
                              {10000.0, 4.0, false}};
constexpr Decade kAngles[] = {
    {10.0, 40.0, true}, {10.0, 400.0, true}, {10.0, 1e4, false}, {10.0, 1e6, false}};

/// Two polygons, each at an angle somewhere.
struct Pair {
    b2PolygonShape a, b;
    b2Vec2 placeA, placeB;
    float angleA, angleB;
    float wayX = 0.0f, wayY = 0.0f, turn = 0.0f; ///< of b, up to there

    b2Transform At(bool ofB) const {
        b2Transform xf;
        xf.Set(ofB ? placeB : placeA, ofB ? angleB : angleA);
        return xf;
    }
    /// Where the transforms put them, in double (ConfirmDistance).
    double Distance() const { return shapes::Measure(a, At(false), b, At(true)).distance; }
    float RadiusSum() const { return a.m_radius + b.m_radius; }
    double Reach() const {
        float most = 0.0f;
        for (const b2PolygonShape *shape : {&a, &b})
            for (int32 i = 0; i < shape->m_count; ++i)
                most = std::max({most, std::fabs(shape->m_vertices[i].x), std::fabs(shape->m_vertices[i].y)});
        return double{most};
    }
};

/// Either way, by half of it at least.
float RandomAngle(Engine &engine, double most) {
    const float angle = UniformF(engine, 0.5 * most, most);
    return Below(engine, 2) == 0 ? angle : -angle;
}

Pair RandomPair(Engine &engine, const Decade &decade) {
    Pair pair;
    pair.a = shapes::RandomPolygon(engine, kExtent);
    pair.b = shapes::RandomPolygon(engine, kExtent);
    const double along = Uniform(engine, -decade.far, decade.far);
    const double far = Below(engine, 2) == 0 ? decade.far : -decade.far;
    pair.placeA.Set(static_cast<float>(Below(engine, 2) == 0 ? far : along), static_cast<float>(far));
    pair.placeB = pair.placeA;
    pair.angleA = RandomAngle(engine, decade.angle);
    pair.angleB = RandomAngle(engine, decade.angle);
    if (Below(engine, 2) == 0) // a side of each in line
        pair.angleB = pair.angleA;
    return pair;
}

float Nudged(Engine &engine, float x) {
    if (Below(engine, 3) == 0)
        return std::nextafterf(x, Below(engine, 2) == 0 ? -1e9f : 1e9f);
    const double step = std::pow(10.0, Uniform(engine, -8.0, -3.0));
    return x + static_cast<float>((Below(engine, 2) == 0 ? step : -step));
}

void Nudge(Engine &engine, Pair *pair) {
    float *const numbers[] = {&pair->placeB.x, &pair->placeB.y, &pair->placeA.x, &pair->placeA.y,
                              &pair->angleA,   &pair->angleB,   &pair->turn};
    float &number = *numbers[Below(engine, pair->turn != 0.0f ? 7 : 6)];
    number = Nudged(engine, number);
}

struct Record {
    double error = 0.0, share = -INFINITY; ///< of what is left for it
    size_t asked = 0, answered = 0;        ///< by the glue
};

/// What one look found. -infinity where Box2D says what it should.
struct Look {
    double error, share;
};

/// What the looks take for the distance is the exact one.
void ConfirmDistance(const Pair &pair) {
    exact::Places points[2];
    for (const bool ofB : {false, true}) {
        const b2PolygonShape &shape = ofB ? pair.b : pair.a;
        const b2Transform xf = pair.At(ofB);
        for (int32 i = 0; i < shape.m_count; ++i)
            points[ofB].push_back(exact::At(bmr_pose{{xf.p.x, xf.p.y}, xf.q.c, xf.q.s},
                                            bmr_vec2{shape.m_vertices[i].x, shape.m_vertices[i].y}));
    }
    const double truth = std::sqrt(exact::SquaredDistance(points[0], points[1]).get_d());
    CHECK(std::fabs(truth - pair.Distance()) < 1e-10);
}

/// Climbs from a start.
template <typename Measure>
void Climb(Engine &engine, Pair pair, int steps, Measure measure, Record *record) {
    Look best = measure(pair);
    for (int i = 0; i < steps; ++i) {
        Pair next = pair;
        Nudge(engine, &next);
        const Look look = measure(next);
        ++record->asked;
        if (look.share >= best.share) {
            best = look;
            pair = next;
        }
    }
    if (best.share > record->share) {
        ConfirmDistance(pair);
        record->share = best.share;
        record->error = best.error;
    }
}

/// Moves b off along a line to where `says` turns false, from the near side.
template <typename Says> void MoveToTheEdge(Engine &engine, Pair *pair, Says says) {
    const double way = Uniform(engine, -3.2, 3.2);
    const b2Vec2 start = pair->placeB,
                 along(static_cast<float>(std::cos(way)), static_cast<float>(std::sin(way)));
    float near = 0.0f, far = 6.0f * static_cast<float>(kExtent);
    for (int i = 0; i < 30; ++i) {
        const float middle = 0.5f * (near + far);
        pair->placeB = start + middle * along;
        (says(*pair) ? near : far) = middle;
    }
    pair->placeB = start + near * along;
}

constexpr Look kNothing = {-INFINITY, -INFINITY};

int Points(const Pair &pair) {
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &pair.a, pair.At(false), &pair.b, pair.At(true));
    return manifold.pointCount;
}

/// How far beyond the diagonal of the radii b2CollidePolygons still gives points.
Look LookAtPoints(const Pair &pair) {
    if (Points(pair) == 0)
        return kNothing;
    const double over = pair.Distance() - std::sqrt(2.0) * double{pair.RadiusSum()};
    return {over, over / bmr::kRoundingMargin};
}

/// A corner of b diagonally before the end of a side of a.
bool PlaceDiagonally(Engine &engine, Pair *pair) {
    for (int tries = 0; tries < 200; ++tries) {
        const int side = Below(engine, pair->a.m_count), end = Below(engine, 2);
        const b2Transform xfA = pair->At(false);
        const b2Vec2 n = b2Mul(xfA.q, pair->a.m_normals[side]);
        const b2Vec2 t(-n.y, n.x); // along the side
        const float r =
            pair->RadiusSum() * (1.0f - static_cast<float>(std::pow(10.0, Uniform(engine, -6.0, -1.0))));
        const b2Vec2 corner =
            b2Mul(xfA, pair->a.m_vertices[(side + end) % pair->a.m_count]) + r * n + (end == 1 ? r : -r) * t;
        pair->angleB = UniformF(engine, -3.2, 3.2);
        const b2Vec2 mine = b2Mul(pair->At(true).q, pair->b.m_vertices[Below(engine, pair->b.m_count)]);
        pair->placeB = corner - mine;
        if (Points(*pair) > 0 && pair->Distance() > double{pair->RadiusSum()})
            return true;
    }
    return false;
}

Record MeasurePoints(const Decade &decade) {
    Engine engine(41);
    Record record;
    for (size_t i = 0; i < std::max<size_t>(test_scaled(800), 300); ++i) {
        Pair pair = RandomPair(engine, decade);
        if (PlaceDiagonally(engine, &pair))
            Climb(engine, pair, 400, LookAtPoints, &record);
    }
    return record;
}

double Gjk(const Pair &pair) {
    b2DistanceInput input;
    input.proxyA.Set(&pair.a, 0);
    input.proxyB.Set(&pair.b, 0);
    input.transformA = pair.At(false);
    input.transformB = pair.At(true);
    input.useRadii = false;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    return double{output.distance};
}

/// What overlap.cpp leaves.
double OverlapRounding(const Pair &pair) {
    const auto coordinate = [](b2Vec2 p) { return double{std::max(std::fabs(p.x), std::fabs(p.y))}; };
    const double reach = 1.41422 * pair.Reach(),
                 x = std::max(coordinate(pair.placeA), coordinate(pair.placeB)) + reach;
    return 2.0 * double{bmr::kUnit} *
           (double{bmr::kErrorPerCoordinate} * x + double{bmr::kErrorPerReach} * reach);
}

/// b2TestOverlap's distance against the true one. (Where they overlap by less than rounding it may be
/// anything as small.)
Look LookAtDistance(const Pair &pair) {
    const double off = std::fabs(Gjk(pair) - pair.Distance());
    return {off, off / OverlapRounding(pair)};
}

bmr::Overlap Ours(const Pair &pair) {
    return bmr::CertainOverlap(pair.a, 0, pair.b, 0, pair.At(false), pair.At(true));
}

Record MeasureOverlaps(const Decade &decade) {
    Engine engine(42);
    Record record;
    for (size_t i = 0; i < Rounds(150); ++i) {
        Pair pair = RandomPair(engine, decade);
        record.answered += Ours(pair) != bmr::Overlap::kUnknown;
        MoveToTheEdge(engine, &pair,
                      [](const Pair &p) { return b2TestOverlap(&p.a, 0, &p.b, 0, p.At(false), p.At(true)); });
        record.answered += Ours(pair) != bmr::Overlap::kUnknown;
        Climb(engine, pair, 150, LookAtDistance, &record);
    }
    return record;
}

b2TOIInput Input(const Pair &pair) {
    b2TOIInput in;
    in.proxyA.Set(&pair.a, 0);
    in.proxyB.Set(&pair.b, 0);
    for (const bool ofB : {false, true}) {
        b2Sweep &sweep = ofB ? in.sweepB : in.sweepA;
        sweep.localCenter = (ofB ? pair.b : pair.a).m_centroid;
        sweep.c = ofB ? pair.placeB : pair.placeA;
        sweep.a = ofB ? pair.angleB : pair.angleA;
        sweep.c0 = sweep.c + (ofB ? b2Vec2(pair.wayX, pair.wayY) : b2Vec2_zero);
        sweep.a0 = sweep.a + (ofB ? pair.turn : 0.0f);
        sweep.alpha0 = 0.0f;
    }
    in.tMax = 1.0f;
    return in;
}

bool Touches(const Pair &pair) {
    const b2TOIInput in = Input(pair);
    b2TOIOutput output;
    b2TimeOfImpact(&output, &in);
    return output.state == b2TOIOutput::e_touching;
}

/// Where a sweep puts a point at a time, of the angle itself and not of a normalised one.
shapes::Point Swept(const b2Sweep &sweep, b2Vec2 v, double t) {
    const double angle = (1.0 - t) * double{sweep.a0} + t * double{sweep.a};
    const double s = std::sin(angle), c = std::cos(angle);
    const double x = double{v.x} - double{sweep.localCenter.x}, y = double{v.y} - double{sweep.localCenter.y};
    return {(1.0 - t) * double{sweep.c0.x} + t * double{sweep.c.x} + c * x - s * y,
            (1.0 - t) * double{sweep.c0.y} + t * double{sweep.c.y} + s * x + c * y};
}

double SweptDistance(const Pair &pair, double t) {
    const b2TOIInput in = Input(pair);
    std::vector<Point> points[2];
    for (const bool ofB : {false, true}) {
        const b2PolygonShape &shape = ofB ? pair.b : pair.a;
        for (int i = 0; i < shape.m_count; ++i)
            points[ofB].push_back(Swept(ofB ? in.sweepB : in.sweepA, shape.m_vertices[i], t));
    }
    return Measure(points[0], points[1]).distance;
}

/// Of the motions that are tried, which are short, the least of some times is the least to 1e-6 of the way.
double LeastSweptDistance(const Pair &pair) {
    if (pair.turn == 0.0f && pair.wayX == 0.0f && pair.wayY == 0.0f)
        return SweptDistance(pair, 1.0);
    double least = INFINITY, at = 0.0;
    for (int i = 0; i <= 16; ++i) {
        const double d = SweptDistance(pair, i / 16.0);
        if (d < least) {
            least = d;
            at = i / 16.0;
        }
    }
    for (double step = 1.0 / 32.0; step > 1e-5; step *= 0.5)
        for (const double t : {at - step, at + step})
            if (t >= 0.0 && t <= 1.0 && SweptDistance(pair, t) < least) {
                least = SweptDistance(pair, t);
                at = t;
            }
    return least;
}

/// What sweep_apart.cpp leaves, anywhere.
double ImpactRounding(const Pair &pair) {
    const b2TOIInput in = Input(pair);
    double sum = 0.0;
    for (const b2Sweep *sweep : {&in.sweepA, &in.sweepB}) {
        const double far = 1.41422 * pair.Reach() * 2.0;
        const double x = std::max(
            {std::fabs(sweep->c.x), std::fabs(sweep->c.y), std::fabs(sweep->c0.x), std::fabs(sweep->c0.y)});
        sum += double{bmr::kErrorPerCoordinate} * x + double{bmr::kErrorPerReach} * far +
               double{bmr::kErrorPerAngle} * std::fabs(double{sweep->a}) * far;
    }
    return sum * double{bmr::kUnit};
}

/// The margin itself, of the bodies in their reach.
double LeftForImpact(const Pair &pair) {
    const b2TOIInput in = Input(pair);
    const bmr::SweptShape a = bmr::Sweep(in.proxyA, in.sweepA, b2Rot(in.sweepA.a)),
                          b = bmr::Sweep(in.proxyB, in.sweepB, b2Rot(in.sweepB.a));
    const double left = double{a.rounding} + double{b.rounding};
    return std::isfinite(left) ? left : ImpactRounding(pair);
}

/// How far beyond ImpactDistance b2TimeOfImpact still says "touching".
Look LookAtImpact(const Pair &pair) {
    if (!Touches(pair))
        return kNothing;
    const double over = LeastSweptDistance(pair) - double{bmr::ImpactDistance(pair.RadiusSum())};
    return {over, over / LeftForImpact(pair)};
}

bool GlueAnswers(const Pair &pair) {
    return bmr::NeverTouch(Input(pair));
}

Record MeasureImpacts(const Decade &decade) {
    Engine engine(43);
    Record record;
    for (size_t i = 0; i < Rounds(120); ++i) {
        Pair pair = RandomPair(engine, decade);
        if (i % 2 == 0) {
            pair.turn = UniformF(engine, -0.1, 0.1);
            pair.wayX = UniformF(engine, -0.3, 0.3);
            pair.wayY = UniformF(engine, -0.3, 0.3);
        }
        Pair away = pair;
        away.placeB.x += 20.0f;
        record.answered += GlueAnswers(away);
        // An overlap at the start is no touch: from where both are none.
        MoveToTheEdge(engine, &pair,
                      [](const Pair &p) { return Touches(p) || LeastSweptDistance(p) <= 0.0; });
        for (int tries = 0; tries < 20 && !Touches(pair); ++tries)
            Nudge(engine, &pair);
        Climb(engine, pair, i % 2 == 0 ? 60 : 150, LookAtImpact, &record);
    }
    return record;
}

void Tell(const char *test, const Decade &decade, const Record &record) {
    char line[160];
    std::snprintf(line, sizeof line, "| %s | %g m | %g rad | %.2g m | %.3f | %s |", test, decade.far,
                  decade.angle, record.error, record.share, decade.within ? "within" : "beyond");
    MESSAGE(line);
}

} // namespace

TEST_CASE("b2CollidePolygons gives no points farther beyond the diagonal than the margin, within the reach") {
    double most = 0.0;
    for (const Decade &decade : kPlaces) {
        const Record record = MeasurePoints(decade);
        Tell("points", decade, record);
        CHECK(record.asked > 0);
        if (decade.within)
            CHECK(record.share < 1.0);
        most = std::max(most, record.share);
    }
    CHECK(most > 0.02); // the control: rounding is seen
}

/// Within the reach the margin holds and we answer; beyond it all is left to Box2D.
void Judge(const Decade &decade, const Record &record) {
    if (decade.within) {
        CHECK(record.share < 1.0);
        CHECK(record.answered > 0);
    } else {
        CHECK(record.answered == 0);
    }
}

/// The proofs take b2Distance to end by itself, before its 20 steps.
void TellSteps(const Decade &decade) {
    MESSAGE("b2Distance took steps: ", b2_gjkMaxIters);
    if (decade.within)
        CHECK(b2_gjkMaxIters < 20);
    b2_gjkMaxIters = 0;
}

TEST_CASE("b2TestOverlap's distance is off by less than the margin, within the reach") {
    for (const Decade &decade : kPlaces) {
        const Record record = MeasureOverlaps(decade);
        Tell("overlap", decade, record);
        TellSteps(decade);
        Judge(decade, record);
        CHECK(record.share > 0.005);
    }
}

TEST_CASE("b2TimeOfImpact touches no farther away than the margin, within the reach") {
    for (const Decade &decade : kPlaces) {
        const Record record = MeasureImpacts(decade);
        Tell("impact", decade, record);
        TellSteps(decade);
        Judge(decade, record);
    }
}

TEST_CASE("the same of large angles") {
    for (const Decade &decade : kAngles) {
        const Record record = MeasureImpacts(decade);
        Tell("impact", decade, record);
        TellSteps(decade);
        Judge(decade, record);
    }
}

TEST_CASE("rotations are off unit length by less than is allowed for") {
    Engine engine(44);
    double most = 0.0;
    for (size_t i = 0; i < test_scaled(300000); ++i) {
        const auto angle = static_cast<float>(std::pow(10.0, Uniform(engine, -3.0, 6.0)));
        const b2Rot q(angle);
        const double s = q.s, c = q.c;
        most = std::max(most, std::fabs(std::sqrt(s * s + c * c) - 1.0));
        const double off = std::hypot(s - std::sin(double{angle}), c - std::cos(double{angle}));
        REQUIRE(off < 1.2 * double{bmr::kUnit});
    }
    MESSAGE("units: ", most / double{bmr::kUnit});
    CHECK(most < 1.2 * double{bmr::kUnit});
}
