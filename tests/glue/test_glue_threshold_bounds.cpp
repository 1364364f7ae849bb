// SPDX-License-Identifier: MIT
// The thresholds re-derived (box2d_glue/glue/proofs/thresholds.md) by interval arithmetic: what Box2D's float
// arithmetic, and the glue's own, may be off by, for all rotations and directions at once, is no more than
// thresholds.h leaves.
//
// Angles are covered by cells. Sizes need none: every bound here is a sum of lengths of linear functions of
// the sizes, so it is sublinear in them, f(x + y) <= f(x) + f(y) and f(k x) = k f(x), and what is left for it
// is linear. So the corners of the sizes' range decide.
#include "cases.h"
#include "glue/proofs/thresholds.h"
#include "random.h"

// --- Intervals of reals, rounded outwards, and what float arithmetic makes of a real that lies in one. ---

namespace interval {

inline double Up(double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
}
inline double Down(double x) {
    return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

struct Interval {
    double low, high;

    Interval(double x) : low(x), high(x) {} // NOLINT(google-explicit-constructor): numbers are intervals
    Interval(double from, double to) : low(from), high(to) {}

    double Largest() const { return std::max(std::fabs(low), std::fabs(high)); }
    bool Holds(double x) const { return low <= x && x <= high; }
};

inline Interval operator+(Interval a, Interval b) {
    return {Down(a.low + b.low), Up(a.high + b.high)};
}
inline Interval operator-(Interval a) {
    return {-a.high, -a.low};
}
inline Interval operator-(Interval a, Interval b) {
    return a + -b;
}
inline Interval operator*(Interval a, Interval b) {
    const double p[] = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
    return {Down(*std::min_element(p, p + 4)), Up(*std::max_element(p, p + 4))};
}
/// `b` without zero.
inline Interval operator/(Interval a, Interval b) {
    return a * Interval(Down(1.0 / b.high), Up(1.0 / b.low));
}
inline Interval Abs(Interval a) {
    return {a.low > 0.0 ? a.low : a.high < 0.0 ? -a.high : 0.0, a.Largest()};
}
inline Interval Union(Interval a, Interval b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

/// Sine and cosine of the angles from k to k + 1 of n equal parts of a turn. (n a multiple of 4: no extreme
/// lies inside a part.)
struct Directions {
    Interval c, s;

    Directions(int k, int n) : c(Of(k, k + 1, n, true)), s(Of(k, k + 1, n, false)) {}

private:
    static Interval Of(int from, int to, int n, bool cosine) {
        const auto at = [n, cosine](int k) {
            const double angle = 6.283185307179586 * k / n;
            const double x = cosine ? std::cos(angle) : std::sin(angle);
            return Interval(x - 1e-15, x + 1e-15);
        };
        return Union(at(from), at(to));
    }
};

/// Half a unit in the last place of 1, what one float operation may be off by relatively.
constexpr double kUnit = 0x1p-24;

/// A float that stands for a real: the real lies in `exact`, the float is within `error` of it.
struct Value {
    Interval exact;
    double error;

    Value(Interval real, double off = 0.0) : exact(real), error(off) {} // NOLINT(google-explicit-constructor)

    /// Of the float.
    double Largest() const { return Up(exact.Largest() + error); }
};

/// The result of one float operation: what came in was off, and it is rounded.
inline Value RoundedOnce(Interval exact, double inherited) {
    return {exact, Up(inherited + Up(kUnit * Up(exact.Largest() + inherited)))};
}
inline Value operator+(Value a, Value b) {
    return RoundedOnce(a.exact + b.exact, Up(a.error + b.error));
}
inline Value operator-(Value a) {
    return {-a.exact, a.error};
}
inline Value operator-(Value a, Value b) {
    return a + -b;
}
inline Value operator*(Value a, Value b) {
    const double inherited = Up(Up(a.exact.Largest() * b.error) + Up(b.Largest() * a.error));
    return RoundedOnce(a.exact * b.exact, inherited);
}

struct Vector {
    Value x, y;
};

/// Length of what a vector of floats is off by.
inline double Off(const Vector &v) {
    return Up(std::hypot(v.x.error, v.y.error));
}
inline Vector operator+(const Vector &a, const Vector &b) {
    return {a.x + b.x, a.y + b.y};
}
inline Vector operator-(const Vector &a, const Vector &b) {
    return {a.x - b.x, a.y - b.y};
}
inline Value Dot(const Vector &a, const Vector &b) {
    return a.x * b.x + a.y * b.y;
}
/// Turned by the rotation (c, s), as it is.
inline Vector Turned(const Directions &q, const Vector &v) {
    const Value c(q.c), s(q.s);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

} // namespace interval

namespace {

using namespace interval;

constexpr int kParts = 48; // of a turn

/// Sine and cosine of the library are off by less than a unit in the last place: 2 units of themselves.
constexpr double kLibrary = 2.0 * kUnit;

template <typename Of> double LargestOfTwo(Of of) {
    double most = 0.0;
    for (int i = 0; i < kParts; ++i)
        for (int j = 0; j < kParts; ++j)
            most = std::max(most, of(Directions(i, kParts), Directions(j, kParts)));
    return most;
}

Vector Along(const Directions &d, double length) {
    return {Value(Interval(length) * d.c), Value(Interval(length) * d.s)};
}
Vector Anywhere(double coordinate) {
    return {Value(Interval(-coordinate, coordinate)), Value(Interval(-coordinate, coordinate))};
}
/// What is given is exact, whatever made it.
Vector Given(const Vector &v) {
    return {Value(v.x.exact), Value(v.y.exact)};
}

/// A vertex `far` from its body's origin, that within `place` (each coordinate): turned and moved.
double PlaceError(double place, double far) {
    return LargestOfTwo([=](const Directions &q, const Directions &v) {
        return Off(Turned(q, Along(v, far)) + Anywhere(place));
    });
}

/// A unit vector's product with such a vertex, as it was rounded.
double DotError(double place, double far) {
    return LargestOfTwo([=](const Directions &n, const Directions &v) {
        return Dot(Along(n, 1.0), Given(Along(v, far) + Anywhere(place))).error;
    });
}

/// How long such a vertex may be.
double Length(double place, double far) {
    return Up(Up(1.41421356237309515 * place) + far);
}

/// A direction after each of its coordinates was rounded so often: two factors turn it by half of what they
/// differ.
double TiltOfRoundings(int count) {
    double most = 0.0;
    for (int i = 0; i < kParts; ++i) {
        const Directions d(i, kParts);
        most = std::max(most, (Interval(2.0 * count * kUnit) * interval::Abs(d.c * d.s)).high);
    }
    return most;
}

/// A length whose square is a sum of two rounded squares.
constexpr double kRootRoundings = 2.0;
/// A unit vector made by 1 / length: length, quotient, product; its coordinates are the edge's, rounded.
constexpr double kUnitVectorRoundings = kRootRoundings + 3.0;

// ---------------------------------------------------------------------------- points of b2CollidePolygons

struct Size {
    double place, far;
};

/// What clipping may be off by: sidewards, and along the normal of the reference face.
struct Clipping {
    double side, front;
};

Clipping ClippingError(Size reference, Size incident) {
    // Edges are no longer than twice the farthest vertex is far.
    const double referenceEdge = 2.0 * reference.far, incidentEdge = 2.0 * incident.far;
    const double length = Length(incident.place, incident.far),
                 referenceLength = Length(reference.place, reference.far);
    const double placed =
        PlaceError(reference.place, reference.far) + PlaceError(incident.place, incident.far);
    const double products = DotError(reference.place, reference.far) + DotError(incident.place, incident.far);
    // A clipped point: a difference, a product and a sum. And where on the edge: two roundings of both sides'
    // distances, of their difference, of the quotient.
    const double cut = kUnit * (2.0 * incidentEdge + length), slid = 4.0 * kUnit * incidentEdge;
    // The tangent: difference and product with the inverse length turn it, and so does the rotation.
    const double tilt = TiltOfRoundings(2) + PlaceError(0.0, 1.0);
    Clipping off;
    off.side = placed + products + kUnit * referenceLength + slid + cut; // the second cut sees the first's
    off.front = placed + products + 2.0 * cut + tilt * referenceEdge;
    return off;
}

/// Rotations are off unit length by less than this: half the square's, whose parts are each off by twice
/// kLibrary. (glibc's are off by 0.56 units in the last place: 1.12 units of themselves.)
constexpr double kLengthOfRotation = 1.2 * kUnit;

/// What the pair's own poses are off by: it takes rotations for such.
double PoseError(Size a, Size b) {
    return kLengthOfRotation * (2.0 * (a.far + b.far) + 4.0 * std::max(a.far, b.far));
}

/// Separations by a face, in the other polygon's frame.
double SeparationError(double between, double far, double otherFar) {
    const double rotation = LargestOfTwo([](const Directions &a, const Directions &b) {
        return Off({Value(a.c) * Value(b.c) + Value(a.s) * Value(b.s),
                    Value(a.c) * Value(b.s) - Value(a.s) * Value(b.c)});
    });
    const double turned = PlaceError(0.0, 1.0);
    const double normal = (kUnitVectorRoundings + 1.0) * kUnit + rotation + turned;
    // The origin of one as seen from the other: a difference, turned.
    const double origin = (kUnit + turned) * between;
    const double vertex = origin + (rotation + turned) * far + kUnit * (between + far);
    const double reach = between + far + otherFar;
    const double scale = 2.0 * kLengthOfRotation * reach;
    return vertex + (normal + 3.0 * kUnit) * reach + scale; // 3: the difference and the product
}

/// No vertex of a hull is farther than this part of what counts as its reach: twice the extent, which is the
/// largest coordinate.
constexpr double kFarOfReach = 0.70710678118654757;
/// Corners of the range of hulls that the glue answers for: place + kReachOfExtent * reach <= kReach.
const Size kCorners[] = {{1.0, 0.0}, {0.0, kFarOfReach / bmr::kReachOfExtent}};

/// The largest error of a clipped corner, in metres at `reach`.
double WorstClipping(double reach) {
    double most = 0.0;
    for (const Size &a : kCorners) {
        for (const Size &b : kCorners) {
            const Clipping off =
                ClippingError({reach * a.place, reach * a.far}, {reach * b.place, reach * b.far});
            const double pose = PoseError({reach * a.place, reach * a.far}, {reach * b.place, reach * b.far});
            most = std::max(most, Up(Up(std::hypot(off.side, off.front)) + pose));
        }
    }
    return most;
}

/// Of a face's separation, the polygons being next to each other.
double WorstDepth(double reach) {
    const double far = kFarOfReach / bmr::kReachOfExtent * reach;
    return SeparationError(2.0 * far, far, far);
}

// ------------------------------------------------------------------ b2TimeOfImpact, b2Distance and the glue

/// A moving shape: where its centre of mass may be (each coordinate), how far that is from the body's origin
/// and how far a point is from it.
struct Moving {
    double centre, origin, radius;

    double Coordinate() const { return centre + radius; }
    double Reach() const { return radius + origin; }
};
const Moving kRays[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};

/// What the shapes turn by where nothing but rounding keeps a proof from being wrong: with more, a proof by
/// the length of the way, or none, is asked for, and that is longer than the chord by more than all of this.
constexpr double kLargestTurn = 0.25;

constexpr double kTwoPi = 6.283185307179586, kOffTwoPi = 1.8e-7; // 2 b2_pi is off by less

/// b2Sweep::Normalize, then the angle in between.
double AngleError(double angle, double least, double most) {
    const Value turns(Interval(0.0, angle / kTwoPi + 1.0));
    const Value off = Value(Interval(kTwoPi), kOffTwoPi) * Value(turns.exact);
    const auto normalised = [&](double more) {
        return RoundedOnce(Interval(least - more, most + more), off.error);
    };
    const Value beta(Interval(0.0, 1.0)), start = normalised(0.001), end = normalised(0.001 + kLargestTurn);
    // The weights' sum is one: the larger of both errors, and its own roundings.
    const Value between = (Value(Interval(1.0)) - beta) * Value(start.exact) + beta * Value(end.exact);
    return Up(between.error + std::max(start.error, end.error));
}

/// A point at a time of b2Sweep::GetTransform's: all roundings but the angle's.
double SweptPlaceError(const Moving &m) {
    constexpr int kBetas = 16;
    double most = 0.0;
    for (int i = 0; i < kBetas; ++i) {
        const Value beta(Interval(1.0 * i / kBetas, 1.0 * (i + 1) / kBetas));
        const Value rest = Value(Interval(1.0)) - beta;
        const Vector start = Anywhere(m.centre), end = Anywhere(m.centre);
        const Vector centre = {rest * start.x + beta * end.x, rest * start.y + beta * end.y};
        // The centre's place in the body, and the point's from there: a direction each.
        most = std::max(most, LargestOfTwo([&](const Directions &q, const Directions &v) {
                            const Vector origin = centre - Turned(q, Along(v, m.origin));
                            return Off(Turned(q, Along(v, m.radius)) + origin);
                        }));
    }
    // Turning the point's share of `origin` as well: sublinear, so added.
    return Up(most + PlaceError(0.0, m.origin));
}

/// A weighted mean of two computed points, the closest one: two products and a sum.
double MeanError(double place, double far) {
    return LargestOfTwo([=](const Directions &v, const Directions &w) {
        const Value weight(Interval(0.0, 1.0)), rest(Interval(0.0, 1.0));
        const Vector a = Given(Along(v, far) + Anywhere(place)), b = Given(Along(w, far) + Anywhere(place));
        const Value x = weight * a.x, y = weight * a.y, u = rest * b.x, t = rest * b.y;
        // The weights' sum is one, so the mean is no larger than the points.
        const double products = Up(std::hypot(std::max(x.error, u.error), std::max(y.error, t.error)));
        return Up(products + kUnit * Length(place, far));
    });
}

/// b2DistanceProxy::GetSupport takes the wrong one of two points: a turned direction, two products.
double SupportError(double far) {
    return 2.0 * (PlaceError(0.0, 1.0) * far + 2.0 * kUnit * far);
}

/// A product of a separation function's axis with the difference of two points, this shape's part of it: the
/// axis turned and made of unit length (its length is the distance's), the middle of a side, the difference,
/// the product. The points of one shape are as far apart as twice their reach.
double AxisError(double far) {
    const double axis = PlaceError(0.0, 1.0) + TiltOfRoundings(2), width = 2.0 * far;
    return (axis + 3.0 * kUnit) * width + kUnit * far;
}

/// bmr_swept32_find_apart's own: points as seen from the centre, turned and turned back, products with a
/// direction.
double OwnPlaceError(double radius) {
    const double turned = PlaceError(0.0, 1.0);
    // turn_back: the angle, a series for sine and cosine (seven roundings of parts no larger than the
    // angle's, a tail below 2e-8), a rotation.
    const double series = kUnit * (kLargestTurn + 2.0 + 7.0 * kLargestTurn) + 2e-8;
    const double points = kUnit + turned + kLibrary + series + turned;
    const double products = 2.0 * kUnit, difference = 2.0 * kUnit; // of the least and the most
    const double swing = 8.0 * kUnit * kLargestTurn;
    return (points + products + difference + swing) * radius;
}

/// One shape's part of what the difference of the centres, of their ways, and their products are off by.
double OwnCentreError(double centre) {
    double most = 0.0;
    for (int i = 0; i < kParts; ++i) {
        const Vector n = Along(Directions(i, kParts), 1.0);
        const Vector at = Anywhere(centre);
        const Vector between = at - at, back = (at - at) - (at - at);
        const Value sum = Dot(n, between) + Dot(n, back);
        most = std::max(most, sum.error);
    }
    return 0.5 * most; // two shapes
}

/// All of it for one shape, the distance's part aside. The larger of what the two ways to say "touching"
/// need.
double ImpactError(const Moving &m, double angle) {
    const double turning = (AngleError(angle, 0.0, kTwoPi) + kLibrary) * m.radius, far = m.Reach();
    const double place = SweptPlaceError(m) + turning;
    const double own = OwnPlaceError(m.radius) + OwnCentreError(m.centre);
    const double byDistance = MeanError(m.Coordinate(), 0.0);
    const double byAxis = PlaceError(m.Coordinate(), far) + SupportError(far) + AxisError(far);
    return Up(place + own + std::max(byDistance, byAxis));
}

/// What the distance is multiplied by. An axis or a direction of about unit length (length, inverse,
/// product), products and a difference; on our side the length and quotient of the direction, three sums, and
/// five of the distance asked for.
double DistanceError() {
    const double theirs = PlaceError(0.0, 1.0) + (kRootRoundings + 2.0 + 3.0) * kUnit;
    const double ours = (kRootRoundings + 1.0 + 3.0 + 5.0) * kUnit;
    return theirs + ours;
}

/// How far a side's direction may be off, times its length: this shape's part.
double TiltError(double coordinate, double far) {
    const double points = 2.0 * PlaceError(coordinate, 0.0) + 2.0 * PlaceError(0.0, far);
    const double difference = 2.0 * kUnit * 2.0 * far;
    return points + difference + SupportError(far);
}

/// What kErrorPer.. leave.
double Left(const Moving &m, double angle, double share) {
    return share * kUnit *
           (double{bmr::kErrorPerCoordinate} * m.Coordinate() + double{bmr::kErrorPerReach} * m.Reach() +
            double{bmr::kErrorPerAngle} * angle * m.radius);
}

/// Is all of it within a share of what thresholds.h leaves?
bool ImpactHolds(double share) {
    bool holds = true;
    for (const Moving &m : kRays)
        for (const double angle : {0.0, double{bmr::kSweepAngle}})
            holds = holds && ImpactError(m, angle) <= Left(m, angle, share);
    return holds;
}

} // namespace

TEST_CASE("an interval holds what it should, and a value's error what rounding does") {
    const Interval third = Interval(1.0) / Interval(3.0);
    CHECK(third.low < third.high);
    CHECK((Interval(3.0) * third).Holds(1.0));
    for (int i = 0; i < kParts; ++i) {
        const Directions d(i, kParts);
        const double angle = 6.283185307179586 * (i + 0.37) / kParts;
        CHECK(d.c.Holds(std::cos(angle)));
        CHECK(d.s.Holds(std::sin(angle)));
    }
    const float x = 0.1f, y = 0.7f;
    const Value product = Value(Interval(0.1), 2e-9) * Value(Interval(0.7), 2e-8);
    CHECK(std::fabs(double{x * y} - 0.07) <= product.error);
}

TEST_CASE("kRoundingMargin holds what clipping is off by, up to kReach") {
    MESSAGE("of the margin: ", WorstClipping(bmr::kReach) / bmr::kRoundingMargin);
    CHECK(WorstClipping(bmr::kReach) <= bmr::kRoundingMargin);
    // Controls: half the margin, four times the reach.
    CHECK(WorstClipping(bmr::kReach) > 0.5 * bmr::kRoundingMargin);
    CHECK(WorstClipping(4.0 * bmr::kReach) > bmr::kRoundingMargin);
}

TEST_CASE("BandMargin holds what clipping and b2TestOverlap are off by, as far as each band reaches") {
    constexpr double kBand0 = double{bmr::kBandReach}, kFarthest = kBand0 / double{bmr::kBandReachOfExtent};
    // The table goes by the farthest vertex where the hulls go by the largest coordinate.
    CHECK(double{bmr::kBandReachOfExtent} >= bmr::kReachOfExtent / kFarOfReach);
    for (int band = 0; band < bmr::kBands; ++band) {
        const double reach = std::ldexp(kBand0, band);
        // Corners of place + kBandReachOfExtent * far <= reach, far <= that of band 0.
        const Size corners[] = {{reach, 0.0}, {reach - kBand0, kFarthest}, {0.0, kFarthest}};
        double clipping = 0.0;
        for (const Size &a : corners) {
            for (const Size &b : corners) {
                const Clipping off = ClippingError(a, b);
                clipping = std::max(clipping, Up(Up(std::hypot(off.side, off.front)) + PoseError(a, b)));
            }
        }
        const double overlap = 2.0 * (PlaceError(reach, 0.0) + MeanError(reach, 0.0) + OwnCentreError(reach));
        MESSAGE("band ", band, ", of the margin: ", clipping / bmr::BandMargin(band), ", ",
                overlap / bmr::BandMargin(band));
        CHECK(clipping <= bmr::BandMargin(band));
        // Controls: a fifth of the margin; for overlaps half of it. (Near the origin they need the radii.)
        CHECK(clipping > 0.2 * bmr::BandMargin(band));
        if (band > 0) {
            CHECK(overlap <= bmr::BandMargin(band));
            CHECK(overlap > 0.5 * bmr::BandMargin(band));
        }
    }
    // What is off by parts of the extent alone is no more than anywhere near the origin.
    CHECK(SeparationError(2.0 * kFarthest, kFarthest, kFarthest) <= WorstDepth(bmr::kReach));
}

TEST_CASE("ContactMargin holds however small the radii are, and however large") {
    // A face that is worse than the best one by Box2D's tolerance may be the reference; of two separations.
    const double depth = 0.1 * b2_linearSlop + 2.0 * WorstDepth(bmr::kReach);
    MESSAGE("depth of a point behind its face: ", depth);
    const double least = (bmr::ContactMargin(0.0) - bmr::kRoundingMargin) / std::sqrt(2.0);
    CHECK(depth <= least);
    for (const double r : {0.0, 1e-4, 0.02, 1.0, 100.0}) {
        // The radii's own roundings: the offset, the comparison, the tangent's length, twice.
        const double off = (3.0 + 2.0 * (kUnitVectorRoundings + 3.0)) * kUnit * r;
        CHECK(bmr::ContactMargin(r) - bmr::kRoundingMargin >= std::sqrt(2.0) * (r + off));
    }
}

TEST_CASE("kRoundingMargin holds what a face's separation is off by, up to kReach") {
    double most = 0.0;
    for (const double a : {0.0, 1.0})
        for (const double b : {0.0, 1.0})
            if (a + b <= 1.0)
                most = std::max(
                    most, SeparationError((1.0 - a - b) * bmr::kReach, a * bmr::kReach, b * bmr::kReach));
    MESSAGE("of the margin: ", most / bmr::kRoundingMargin);
    CHECK(most <= bmr::kRoundingMargin);
    CHECK(most > 0.25 * bmr::kRoundingMargin);
    CHECK(SeparationError(4.0 * bmr::kReach, 0.0, 0.0) > bmr::kRoundingMargin);
}

TEST_CASE("kErrorPer.. leave what b2TimeOfImpact and the glue's own proof may be off by") {
    for (const Moving &m : kRays) {
        CAPTURE(m.centre);
        CAPTURE(m.origin);
        CAPTURE(m.radius);
        for (const double angle : {0.0, double{bmr::kSweepAngle}}) {
            MESSAGE("off by units: ", ImpactError(m, angle) / kUnit, " of ", Left(m, angle, 1.0) / kUnit);
            CHECK(ImpactError(m, angle) <= Left(m, angle, 1.0));
        }
    }
    MESSAGE("per distance: ", DistanceError() / kUnit);
    CHECK(DistanceError() <= kUnit * double{bmr::kErrorPerDistance});
    CHECK(ImpactHolds(1.0));
    CHECK_FALSE(ImpactHolds(0.5)); // the control
    CHECK(DistanceError() > 0.5 * kUnit * double{bmr::kErrorPerDistance});
}

TEST_CASE("kTiltPer.. leave what the direction of a side may be off by") {
    const double coordinate = TiltError(1.0, 0.0) / kUnit, reach = TiltError(0.0, 1.0) / kUnit;
    MESSAGE("units: ", coordinate, " and ", reach);
    CHECK(coordinate <= double{bmr::kTiltPerCoordinate});
    CHECK(reach <= double{bmr::kTiltPerReach});
    CHECK(coordinate > 0.5 * double{bmr::kTiltPerCoordinate});
    CHECK(reach > 0.5 * double{bmr::kTiltPerReach});
    // The difference of two points that are the distance apart is rounded once each.
    CHECK(2.0 <= double{bmr::kTiltPerDistance});
}

TEST_CASE("the same leave what b2TestOverlap's distance may be off by") {
    // Two shapes at rest, where their transforms put them: x and reach are the larger of both shapes'.
    for (const Moving &m : kRays) {
        if (m.radius > 0.0)
            continue; // a point of the shape is at `origin`
        const double off = 2.0 * (PlaceError(m.centre, m.origin) + MeanError(m.centre, m.origin) +
                                  OwnCentreError(m.centre) + OwnPlaceError(m.origin));
        // overlap.cpp: x holds the diagonal of the reach.
        const double left = 2.0 * Left({m.centre, m.origin, 0.0}, 0.0, 1.0);
        MESSAGE("units: ", off / kUnit, " of ", left / kUnit);
        CHECK(off <= left);
    }
}

TEST_CASE("rotations are off unit length by less than is allowed for") {
    test_random random = {44};
    double most = 0.0;
    for (size_t i = 0; i < test_scaled(300000); ++i) {
        const auto angle = static_cast<float>(std::pow(10.0, test_random_uniform(&random, -3.0, 6.0)));
        const b2Rot q(angle);
        const double s = q.s, c = q.c;
        most = std::max(most, std::fabs(std::sqrt(s * s + c * c) - 1.0));
        const double off = std::hypot(s - std::sin(double{angle}), c - std::cos(double{angle}));
        REQUIRE(off < 1.2 * double{bmr::kUnit});
    }
    MESSAGE("units: ", most / double{bmr::kUnit});
    CHECK(most < 1.2 * double{bmr::kUnit});
}
