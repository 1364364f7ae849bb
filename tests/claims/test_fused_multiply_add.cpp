// SPDX-License-Identifier: MIT
// bmr_exact32_separates_contracted and bmr_exact32_face_contracted against every way to fuse the products and
// sums of a separation, and against rational arithmetic.
#include <array>

#include <gmpxx.h>

#include "cases.h"
#include "convex32_poses.h"
#include "exact32/exact32.h"
#include "test_scale.h"

namespace {

constexpr double kUnit = 0x1p-24;
constexpr float kInfinity = std::numeric_limits<float>::infinity(),
                kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kBad[] = {kNan, kInfinity, -kInfinity, 3e38f, -3e38f};

/// One edge against the vertices of another polygon: all that a separation is made of.
struct Case {
    bmr_vec32 vertex, normal, points[8];
    int32_t count;
    bmr_transform32 reference, other;
};

/// Which products go into their sum unrounded, and in which order three numbers are added: two bits for each
/// formula.
struct Contraction {
    uint64_t choices;
    unsigned Next() {
        const auto choice = static_cast<unsigned>(choices & 3u);
        choices = choices >> 2 | choices << 62;
        return choice;
    }
    float Sum(float a, float b, float c, float d) { // a b + c d
        switch (Next()) {
        case 0:
            return std::fma(a, b, c * d);
        case 1:
            return std::fma(c, d, a * b);
        default:
            return a * b + c * d;
        }
    }
    float Sum(float a, float b, float c, float d, float e) { // a b + c d + e
        if (Next() == 0)                                     // as -ffast-math may add
            return std::fma(a, b, std::fma(c, d, e));
        const float sum = Sum(a, b, c, d);
        return sum + e;
    }
};
constexpr Contraction kNone = {~uint64_t{0}};

/// b2FindMaxSeparation's separation of this edge.
float Evaluate(const Case &at, Contraction how) {
    const bmr_transform32 &from = at.reference, &to = at.other;
    const float dx = from.p.x - to.p.x, dy = from.p.y - to.p.y;
    const float s = how.Sum(to.c, from.s, -to.s, from.c), c = how.Sum(to.c, from.c, to.s, from.s);
    const float px = how.Sum(to.c, dx, to.s, dy), py = how.Sum(-to.s, dx, to.c, dy);
    const float nx = how.Sum(c, at.normal.x, -s, at.normal.y), ny = how.Sum(s, at.normal.x, c, at.normal.y);
    const float vx = how.Sum(c, at.vertex.x, -s, at.vertex.y, px),
                vy = how.Sum(s, at.vertex.x, c, at.vertex.y, py);
    const unsigned dot = how.Next();
    float least = FLT_MAX;
    for (int32_t i = 0; i < at.count; ++i) {
        Contraction same = {dot};
        const float separation = same.Sum(nx, at.points[i].x - vx, ny, at.points[i].y - vy);
        least = separation < least ? separation : least;
    }
    return least;
}

/// The same in any arithmetic, of magnitudes or of the numbers themselves.
template <typename Number> Number Exactly(const Case &at, bool magnitudes) {
    const auto number = [magnitudes](float x) { return Number(double{magnitudes ? std::fabs(x) : x}); };
    const Number sign = magnitudes ? Number(1.0) : Number(-1.0);
    const bmr_transform32 &from = at.reference, &to = at.other;
    const Number ts = number(to.s), tc = number(to.c), fs = number(from.s), fc = number(from.c);
    Number dx = Number(double{from.p.x}) - Number(double{to.p.x}),
           dy = Number(double{from.p.y}) - Number(double{to.p.y});
    for (Number *way : {&dx, &dy})
        if (magnitudes && *way < Number(0.0))
            *way = -*way;
    const Number s = tc * fs + sign * ts * fc, c = tc * fc + ts * fs;
    const Number px = tc * dx + ts * dy, py = sign * ts * dx + tc * dy;
    const Number nx = c * number(at.normal.x) + sign * s * number(at.normal.y),
                 ny = s * number(at.normal.x) + c * number(at.normal.y);
    const Number vx = c * number(at.vertex.x) + sign * s * number(at.vertex.y) + px,
                 vy = s * number(at.vertex.x) + c * number(at.vertex.y) + py;
    Number found = Number(0.0);
    for (int32_t i = 0; i < at.count; ++i) {
        const Number along =
            nx * (number(at.points[i].x) + sign * vx) + ny * (number(at.points[i].y) + sign * vy);
        if (i == 0 || (magnitudes ? found < along : along < found))
            found = along;
    }
    return found;
}

/// What all roundings are a part of.
double SizeOf(const Case &at) {
    // The largest x and the largest y may be of two points.
    Case largest = at;
    largest.count = 1;
    for (int32_t i = 1; i < at.count; ++i) {
        largest.points[0].x = std::max(std::fabs(largest.points[0].x), std::fabs(at.points[i].x));
        largest.points[0].y = std::max(std::fabs(largest.points[0].y), std::fabs(at.points[i].y));
    }
    return Exactly<double>(largest, true);
}

bool Claims(const Case &at, float beyond) {
    return bmr_exact32_separates_contracted(&at.vertex, &at.normal, &at.reference, at.points, at.count,
                                            &at.other, beyond);
}

/// The claim with another margin, in units of the size.
bool Claims(const Case &at, float beyond, double units) {
    return double{Evaluate(at, kNone)} - units * kUnit * SizeOf(at) > double{beyond};
}

enum Range { kNear, kFar, kLarge, kTiny, kApart, kStretched, kLoose, kRanges };

Case RandomCase(dice *d, Range range) {
    // Where the two are, how far from each other, how large.
    static const double place[kRanges] = {10.0, 1e5, 1000.0, 1e-3, 1e4, 10.0, 100.0},
                        between[kRanges] = {2.0, 2.0, 1000.0, 1e-3, 1e4, 5.0, 3.0},
                        extent[kRanges] = {1.0, 1.0, 1000.0, 1e-4, 1.0, 1.0, 2.0};
    Case at = {};
    const double size = extent[range] * std::pow(10.0, dice_in(d, -1.0, 0.0));
    const auto vector = [d](double most) {
        return bmr_vec32{static_cast<float>(dice_in(d, -most, most)),
                         static_cast<float>(dice_in(d, -most, most))};
    };
    at.reference = random_pose32(d, place[range]);
    at.other = random_pose32(d, 0.0);
    const bmr_vec32 away = vector(between[range]);
    at.other.p = {at.reference.p.x + away.x, at.reference.p.y + away.y};
    at.count = static_cast<int32_t>(1 + dice_below(d, 8));
    at.vertex = vector(size);
    const double turn = dice_in(d, -3.2, 3.2),
                 length = range == kLoose ? std::pow(10.0, dice_in(d, -3.0, 3.0)) : 1.0;
    at.normal = {static_cast<float>(length * std::cos(turn)), static_cast<float>(length * std::sin(turn))};
    for (bmr_vec32 &point : at.points) // (also past the count, where nothing may be taken from)
        point = vector(extent[range]);
    if (range == kStretched) { // no rotations
        at.reference.s *= static_cast<float>(dice_in(d, 0.0, 3.0));
        at.other.c *= static_cast<float>(dice_in(d, 0.0, 1e3));
    }
    return at;
}

uint64_t Bits(dice *d) {
    return static_cast<uint64_t>(dice_roll(d)) << 32 | dice_roll(d);
}

/// How far apart two evaluations are, in units of the size.
double Between(const Case &at, Contraction one) {
    return std::fabs(double{Evaluate(at, one)} - double{Evaluate(at, kNone)}) / (kUnit * SizeOf(at));
}

/// All of one point; a point is behind everything else.
std::array<float *, 14> NumbersOf(Case *at) {
    return {&at->vertex.x,      &at->vertex.y,    &at->normal.x,    &at->normal.y,   &at->reference.p.x,
            &at->reference.p.y, &at->reference.s, &at->reference.c, &at->other.p.x,  &at->other.p.y,
            &at->other.s,       &at->other.c,     &at->points[0].x, &at->points[0].y};
}

/// Changes a number of it by a few units in the last place, or by some part.
void Nudge(dice *d, Case *at) {
    float &x = *NumbersOf(at)[dice_below(d, 14)];
    const double part = std::pow(10.0, dice_in(d, -8.0, -0.5));
    x *= static_cast<float>(1.0 + dice_in(d, -part, part));
}

/// Climbs to ever larger differences; from there is asked.
Case Worsened(dice *d, Case at, Contraction *how, int steps) {
    at.count = 1;
    double worst = Between(at, *how);
    for (int step = 0; step < steps; ++step) {
        Case next = at;
        Contraction other = *how;
        Nudge(d, &next);
        if (dice_below(d, 4) == 0)
            other.choices ^= uint64_t{1} << dice_below(d, 64);
        const double found = Between(next, other);
        if (found >= worst) {
            worst = found;
            at = next;
            *how = other;
        }
    }
    return at;
}

/// Two polygons, most of them with a face of one towards a face of the other, as they lie on each other.
struct Lying {
    bmr_vec32 vertices[2][8], normals[2][8];
    int32_t count[2];
    bmr_transform32 pose[2];
    float radiusSum = 0.02f, tolerance = 0.0005f;
};

Lying RandomLying(dice *d) {
    Lying lying = {};
    bmr_convex32_block *blocks[2];
    for (int side = 0; side < 2; ++side) {
        do
            blocks[side] = random_convex32(d, random_kind(d), 3 + dice_below(d, 6));
        while (blocks[side]->polygon.count > 8);
        const bmr_convex32 &polygon = blocks[side]->polygon;
        lying.count[side] = static_cast<int32_t>(polygon.count);
        std::copy_n(polygon.vertices, polygon.count, lying.vertices[side]);
        std::copy_n(polygon.normals, polygon.count, lying.normals[side]);
    }
    lying.pose[0] = random_pose32(d, dice_below(d, 3) == 0 ? 1e4 : 10.0);
    lying.pose[1] = pose_against(d, &blocks[0]->polygon, &lying.pose[0], &blocks[1]->polygon, 0.02);
    for (bmr_convex32_block *block : blocks)
        bmr_convex32_destroy(block, nullptr);
    return lying;
}

/// b2FindMaxSeparation of this side's edges.
float MostOf(const Lying &lying, int side, Contraction how, int32_t *edge) {
    float most = -FLT_MAX;
    *edge = 0;
    Case at = {};
    at.count = lying.count[1 - side];
    std::copy_n(lying.vertices[1 - side], 8, at.points);
    at.reference = lying.pose[side];
    at.other = lying.pose[1 - side];
    for (int32_t i = 0; i < lying.count[side]; ++i) {
        at.vertex = lying.vertices[side][i];
        at.normal = lying.normals[side][i];
        const float separation = Evaluate(at, how);
        if (separation > most) {
            most = separation;
            *edge = i;
        }
    }
    return most;
}

/// What b2CollidePolygons goes by: a face, or BMR_SEPARATES32.
int32_t FaceOf(const Lying &lying, Contraction ofA, Contraction ofB) {
    int32_t edgeA, edgeB;
    const float a = MostOf(lying, 0, ofA, &edgeA), b = MostOf(lying, 1, ofB, &edgeB);
    if (a > lying.radiusSum || b > lying.radiusSum)
        return BMR_SEPARATES32;
    return b > a + lying.tolerance ? BMR_EDGES_OF_B32 + edgeB : edgeA;
}

int32_t ClaimedFace(const Lying &lying) {
    const bmr_polygon32 a = {lying.vertices[0], lying.normals[0], lying.count[0]},
                        b = {lying.vertices[1], lying.normals[1], lying.count[1]};
    return bmr_exact32_face_contracted(&a, &lying.pose[0], &b, &lying.pose[1], lying.radiusSum,
                                       lying.tolerance);
}

} // namespace

TEST_CASE("no way to fuse gives less than what is claimed, in any range") {
    dice d = {3};
    size_t cases = 0, denied = 0, deniedToLess = 0, claimed = 0;
    double worst = 0.0;
    const auto ask = [&](const Case &at, Contraction how) {
        const float other = Evaluate(at, how);
        ++cases;
        denied += Claims(at, other);
        deniedToLess += Claims(at, other, 2.0);
        worst = std::max(worst, Between(at, how));
        // It is claimed as soon as it can be, nearly: else nothing claimed would pass, too.
        const auto less = static_cast<float>(double{Evaluate(at, kNone)} - 36.0 * kUnit * SizeOf(at));
        claimed += Claims(at, less);
    };
    for (int range = 0; range < kRanges; ++range)
        for (size_t i = 0; i < test_scaled(100000); ++i) {
            const Case at = RandomCase(&d, static_cast<Range>(range));
            for (int ways = 0; ways < 4; ++ways)
                ask(at, {Bits(&d)});
        }
    for (int range = 0; range < kRanges; ++range)
        for (size_t i = 0; i < test_scaled(400); ++i) {
            Contraction how = {Bits(&d)};
            const Case at = Worsened(&d, RandomCase(&d, static_cast<Range>(range)), &how, 1000);
            ask(at, how);
        }
    std::printf("worst difference of two evaluations: %.2f units of the size\n", worst);
    CHECK(cases > 1000);
    CHECK(denied == 0);
    CHECK(claimed == cases);
    CHECK(deniedToLess > 0); // the control: a sixteenth of the margin would be denied
}

TEST_CASE("an evaluation is off by no more than twelve roundings of its size") {
    dice d = {5};
    double worst = 0.0;
    size_t beyond = 0;
    for (int range = 0; range < kRanges; ++range)
        for (size_t i = 0; i < test_scaled(2000); ++i) {
            Contraction how = {Bits(&d)};
            const Case at =
                Worsened(&d, RandomCase(&d, static_cast<Range>(range)), &how, i % 10 == 0 ? 100 : 0);
            const mpq_class wanted = Exactly<mpq_class>(at, false), size = Exactly<mpq_class>(at, true);
            for (const Contraction ways : {how, kNone}) {
                const mpq_class off = abs(mpq_class(Evaluate(at, ways)) - wanted);
                CHECK((off <= 12.001 * kUnit * size));
                beyond += off > kUnit * size; // the control: one rounding is not enough
                worst = std::max(worst, mpq_class(off / (kUnit * size)).get_d());
            }
        }
    std::printf("worst error: %.2f units of the size\n", worst);
    CHECK(beyond > 0);
}

TEST_CASE("numbers that are none, and what overflows, are claimed nowhere") {
    dice d = {7};
    for (size_t i = 0; i < test_scaled(20000); ++i) {
        Case at = RandomCase(&d, kNear);
        const auto which = dice_below(&d, 14), how = dice_below(&d, 5);
        // (A point that is no number is passed over by Box2D, as here: its others decide.)
        *NumbersOf(&at)[which] = kBad[which >= 12 && how == 0 ? 1 : how];
        if (Claims(at, 0.01f)) {
            CHECK(Evaluate(at, {Bits(&d)}) > 0.01f);
            CHECK(how >= 3); // large, and no more than that
        }
    }
}

TEST_CASE("what lies past the count changes neither claims nor faces") {
    dice d = {9};
    for (size_t i = 0; i < test_scaled(20000); ++i) {
        Case at = RandomCase(&d, kNear);
        Case other = at;
        for (int32_t past = at.count; past < 8; ++past)
            other.points[past] = {1e30f, kNan};
        const float beyond =
            Evaluate(at, {Bits(&d)}) - static_cast<float>(dice_in(&d, 0.0, 64.0) * kUnit * SizeOf(at));
        CHECK(Claims(at, beyond) == Claims(other, beyond));
        const Lying lying = RandomLying(&d);
        Lying otherwise = lying;
        for (int side = 0; side < 2; ++side)
            for (int32_t past = lying.count[side]; past < 8; ++past)
                otherwise.vertices[side][past] = otherwise.normals[side][past] = {1e30f, kNan};
        CHECK(ClaimedFace(lying) == ClaimedFace(otherwise));
    }
}

TEST_CASE("no way to fuse makes another face the reference than the one that is claimed") {
    dice d = {11};
    const size_t pairs = test_scaled(100000);
    size_t ofA = 0, ofB = 0, apart = 0, denied = 0, deniedPlain = 0;
    for (size_t i = 0; i < pairs; ++i) {
        Lying lying = RandomLying(&d);
        // Some of which one way of rounding, and not another, is just at what is compared with.
        int32_t edge;
        const float a = MostOf(lying, 0, kNone, &edge), b = MostOf(lying, 1, kNone, &edge);
        if (i % 16 == 0)
            lying.radiusSum = a;
        else if (i % 16 == 1)
            lying.tolerance = b - a;
        const int32_t claimed = ClaimedFace(lying), plain = FaceOf(lying, kNone, kNone);
        ofA += claimed >= 0 && claimed < BMR_EDGES_OF_B32;
        ofB += claimed >= BMR_EDGES_OF_B32 && claimed < BMR_SEPARATES32;
        apart += claimed >= BMR_SEPARATES32;
        for (int ways = 0; ways < 4; ++ways) {
            const int32_t found = FaceOf(lying, {Bits(&d)}, {Bits(&d)});
            deniedPlain += found != plain;
            if (claimed != BMR_NO_EDGE32)
                denied += found != std::min<int32_t>(claimed, BMR_SEPARATES32);
        }
    }
    std::printf("of %zu pairs %zu faces of A, %zu of B, %zu apart\n", pairs, ofA, ofB, apart);
    CHECK(denied == 0);
    // It is claimed of most, of each kind: else nothing claimed would pass, too.
    CHECK(4 * (ofA + ofB + apart) > 3 * pairs);
    CHECK(20 * std::min({ofA, ofB, apart}) > pairs);
    CHECK(deniedPlain > 0); // the control: the face that one way of rounding takes is not that of all
}

TEST_CASE("of numbers that are none no face is claimed but where Box2D takes it") {
    dice d = {13};
    size_t left = 0;
    for (size_t i = 0; i < test_scaled(20000); ++i) {
        Lying lying = RandomLying(&d);
        const auto side = dice_below(&d, 2), which = dice_below(&d, 6);
        const auto of = dice_below(&d, static_cast<uint32_t>(lying.count[side]));
        float *const numbers[] = {
            &lying.vertices[side][of].x, &lying.normals[side][of].y, &lying.pose[side].p.x,
            &lying.pose[side].s,         &lying.radiusSum,           &lying.tolerance};
        *numbers[which] = kBad[dice_below(&d, 5)];
        const int32_t claimed = ClaimedFace(lying);
        left += claimed == BMR_NO_EDGE32;
        if (claimed != BMR_NO_EDGE32)
            CHECK(FaceOf(lying, {Bits(&d)}, {Bits(&d)}) == std::min<int32_t>(claimed, BMR_SEPARATES32));
    }
    CHECK(left > 0);
}
