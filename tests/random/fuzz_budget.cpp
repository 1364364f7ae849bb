// SPDX-License-Identifier: MIT
// Budgets of motion: two bodies of a few points that drift, leap, turn, grow and are marked as the bytes say,
// with numbers of any kind. In rational arithmetic: no point goes farther than is counted, the pair is apart
// while it is not due, its line's gap is there, and no sweep leaves its bound. Counts and gaps are hardly
// more and less than they must be.
#include <cmath>
#include <vector>

#include "boomerang/budget.h"
#include "bytes.h"
#include "exact_motion.h"
#include "harness.h"

namespace {

using namespace exact;

/// Beyond these the oracle's own doubles overflow or underflow when they are squared.
constexpr double kLarge = 1e100, kSmall = 1e-100, kLargeScale = 1e50;
/// What may go by between two questions (budget.h).
constexpr uint64_t kMostMoved = uint64_t{1} << 31, kMostTurned = kMostMoved - BMR_BUDGET_MARK;

/// For points, directions and lengths.
double Tame(double x) {
    return std::fabs(x) <= kLarge && std::fabs(x) >= kSmall ? x : 0.0;
}

bool IsFinite(const bmr_pose &q) {
    return std::isfinite(q.position.x) && std::isfinite(q.position.y) && std::isfinite(q.c) &&
           std::isfinite(q.s);
}
bool IsTame(const bmr_pose &q) {
    return std::fabs(q.position.x) <= kLarge && std::fabs(q.position.y) <= kLarge &&
           std::fabs(q.c) <= kLargeScale && std::fabs(q.s) <= kLargeScale;
}

/// Of a script: what takes more finds no more.
constexpr int kMostSteps = 80;

struct Body {
    std::vector<bmr_vec2> points;
    bmr_pose pose;
    bmr_mover mover;
    uint64_t moved = 0, turned = 0; ///< since the deadline and the line were made; do not wrap
};

class Script {
public:
    explicit Script(fuzz_bytes *bytes) : bytes_(bytes) {
        const double all[] = {65536.0, 1.0, 1000.0, 3e5, 0x1p-20, 0x1p60, 1e-60};
        units_ = all[fuzz_below(bytes, 7)];
        for (Body &body : bodies_) {
            body.pose = ReadPose();
            const bmr_vec2 pivot = ReadPoint();
            for (uint32_t i = 1 + fuzz_below(bytes, 3); i > 0; --i)
                body.points.push_back(ReadPoint());
            bmr_mover_start(&body.mover, &body.pose, pivot, exact::ReachOf(body.points, pivot), units_);
            body.mover.moved = fuzz_u32(bytes);
            body.mover.turned = fuzz_u32(bytes);
        }
    }
    void Run() {
        for (int step = 0; step < kMostSteps && !fuzz_done(bytes_); ++step) {
            Body &body = bodies_[fuzz_u8(bytes_) % 2];
            switch (fuzz_below(bytes_, 9)) {
            case 0:
            case 1:
                Update(&body, NextPose(body));
                break;
            case 2:
                HeadOn(&body, &body == &bodies_[0] ? bodies_[1] : bodies_[0]);
                break;
            case 3:
                bmr_mover_mark(&body.mover);
                body.moved += BMR_BUDGET_MARK;
                FUZZ_CHECK(!known_ || bodies_[0].moved + bodies_[1].moved > kMostMoved || IsDue(),
                           "a mark, and the pair is not due");
                break;
            case 4:
                Grow(&body);
                break;
            case 5:
                Extend(&body);
                break;
            case 6:
                MakeDeadline();
                break;
            case 7:
                MakeLine();
                break;
            default:
                Sweep(body);
                break;
            }
            Ask();
        }
    }

private:
    double Number() { return Tame(fuzz_number(bytes_)); }
    bmr_vec2 ReadPoint() {
        const double x = Number();
        return {x, Number()};
    }
    bmr_pose ReadPose() {
        bmr_pose pose;
        pose.position.x = fuzz_number(bytes_);
        pose.position.y = fuzz_number(bytes_);
        const double angle = fuzz_in(bytes_, -3.2, 3.2);
        pose.c = std::cos(angle);
        pose.s = std::sin(angle);
        const uint8_t how = fuzz_u8(bytes_);
        if (how < 32) {
            pose.c = fuzz_number(bytes_);
            pose.s = fuzz_number(bytes_);
        } else if (how >= 224) { // a body that is scaled
            pose.c = std::ldexp(pose.c, how % 21 - 10);
            pose.s = std::ldexp(pose.s, how % 21 - 10);
        }
        return pose;
    }
    bmr_pose NextPose(const Body &body) {
        bmr_pose pose = body.pose;
        const uint8_t how = fuzz_u8(bytes_);
        if (how % 8 == 0)
            return ReadPose();
        if (how % 2 != 0) {
            const double angle = how < 128 ? fuzz_in(bytes_, -0.1, 0.1) : fuzz_in(bytes_, -3.2, 3.2);
            const double c = std::cos(angle), s = std::sin(angle);
            pose.c = body.pose.c * c - body.pose.s * s;
            pose.s = body.pose.s * c + body.pose.c * s;
        }
        if (how / 2 % 2 != 0)
            pose.position.x += fuzz_number(bytes_) / units_ * (how < 64 ? 1.0 : 1000.0);
        if (how / 4 % 2 != 0)
            pose.position.y += fuzz_number(bytes_);
        return pose;
    }

    void Update(Body *body, const bmr_pose &to) {
        const bmr_pose from = body->pose;
        const bmr_vec2 center = body->mover.center;
        const uint32_t begin = body->mover.turned;
        uint32_t moved = bmr_mover_update(&body->mover, &to, units_);
        const uint32_t turned = body->mover.turned - begin;
        FUZZ_CHECK(moved <= BMR_BUDGET_MARK && turned <= BMR_BUDGET_TURN, "an update adds %u, %u", moved,
                   turned);
        body->pose = to;
        body->moved += moved;
        body->turned += turned;
        if (moved == BMR_BUDGET_MARK)
            return;
        FUZZ_CHECK(IsFinite(from) && IsFinite(to), "from or to nowhere counts %u", moved);
        // A unit each is what rounding up costs.
        const double turning = body->mover.reach * std::hypot(to.c - from.c, to.s - from.s) * units_;
        const double way = std::hypot((body->mover.center.x - center.x) * units_,
                                      (body->mover.center.y - center.y) * units_);
        FUZZ_CHECK(moved + (fuzz_control("waste") ? 2.0 : 0.0) <= (way + turning) * (1 + 1e-12) + 1.0 &&
                       turned <= turning * (1 + 1e-12) + 1.0,
                   "%g of way and %g of turning count as %u, %u", way, turning, moved, turned);
        if (fuzz_control("motion"))
            moved /= 2;
        const Place about = PlaceOf(body->mover.pivot);
        const mpq_class dc = mpq_class(to.c) - mpq_class(from.c), ds = mpq_class(to.s) - mpq_class(from.s);
        for (const bmr_vec2 &point : body->points) {
            const Place gone = Way(exact::At(from, point), exact::At(to, point));
            FUZZ_CHECK(InUnits(gone, mpq_class(moved) + mpq_class(1, 16)), "a point moved farther than %u",
                       moved);
            FUZZ_CHECK(InUnits(exact::Turned(dc, ds, Way(about, PlaceOf(point))), turned),
                       "a point turned farther than %u", turned);
        }
    }
    /// Is the vector no longer than so many units?
    bool InUnits(const Place &way, const mpq_class &most) const {
        return IsAtMost(Square(way) * Square(mpq_class(units_)), most);
    }

    /// Straight at the other, by about what is left.
    void HeadOn(Body *body, const Body &other) {
        const uint32_t moved[2] = {bodies_[0].mover.moved, bodies_[1].mover.moved};
        const bool due = bmr_budget_is_due(deadline_, moved[0], moved[1]);
        const double by = (due ? 0u : deadline_ - moved[0] - moved[1]) + fuzz_in(bytes_, -3.0, 3.0);
        const bmr_vec2 p = bmr_transform(&body->pose, body->points[0]),
                       q = bmr_transform(&other.pose, other.points[0]), way = bmr_sub(q, p);
        const double length = std::hypot(way.x, way.y);
        bmr_pose to = body->pose;
        if (std::isfinite(length) && length > 0.0)
            to.position = bmr_add(to.position, bmr_scale(by / units_ / length, way));
        Update(body, to);
    }

    void Grow(Body *body) {
        const double by = fuzz_number(bytes_);
        const uint32_t before = body->mover.moved;
        bmr_mover_grow(&body->mover, by, units_);
        const uint32_t grown = body->mover.moved - before;
        FUZZ_CHECK(grown <= BMR_BUDGET_MARK, "a growth adds %u", grown);
        body->moved += grown;
        if (by <= 0.0) {
            FUZZ_CHECK(grown == 0, "to shrink costs %u", grown);
        } else if (std::isfinite(by)) {
            threshold_ += mpq_class(by);
            FUZZ_CHECK(grown == BMR_BUDGET_MARK || mpq_class(by) * mpq_class(units_) < grown,
                       "grown by %g costs %u", by, grown);
        } else {
            FUZZ_CHECK(grown == BMR_BUDGET_MARK, "grown by %g costs %u", by, grown);
        }
    }

    void Extend(Body *body) {
        body->points.push_back(ReadPoint());
        bmr_mover_extend(&body->mover, exact::ReachOf(body->points, body->mover.pivot));
        bmr_mover_extend(&body->mover, fuzz_in(bytes_, -1.0, 0.0));
        known_ = has_line_ = false;
    }

    bool BothAreTame() const { return IsTame(bodies_[0].pose) && IsTame(bodies_[1].pose); }
    Places PlacesOf(int side) const { return exact::At(bodies_[side].pose, bodies_[side].points); }
    bool IsDue() const {
        return bmr_budget_is_due(deadline_, bodies_[0].mover.moved, bodies_[1].mover.moved);
    }

    void MakeDeadline() {
        if (!BothAreTame())
            return;
        threshold_ = mpq_class(std::fabs(Number()));
        const double root = exact::RootAtMost(exact::LeastSquare(PlacesOf(0), PlacesOf(1)));
        Renew(exact::AtMost(mpq_class(root) - threshold_));
    }
    void Renew(double slack) {
        deadline_ = bmr_budget_deadline(slack, bodies_[0].mover.moved, bodies_[1].mover.moved, units_);
        if (fuzz_control("deadline"))
            deadline_ += 1000;
        known_ = true;
        bodies_[0].moved = bodies_[1].moved = 0;
    }

    void MakeLine() {
        if (!BothAreTame())
            return;
        const bmr_vec2 d = ReadPoint();
        const double gap = exact::AtMost(exact::LeastAlong(PlaceOf(d), PlacesOf(0), PlacesOf(1)));
        line_ = bmr_budget_line_make(d, gap, &bodies_[0].mover, &bodies_[1].mover, units_);
        const Place normal = {mpq_class(line_.normal[0]), mpq_class(line_.normal[1])};
        FUZZ_CHECK(Square(normal) <= 1, "a normal of length %g",
                   std::hypot(line_.normal[0], line_.normal[1]));
        has_line_ = Square(normal) > 0;
        bodies_[0].turned = bodies_[1].turned = 0;
        if (has_line_)
            CheckLoss(normal);
    }
    /// What it costs a new line to be sure: three units, and what its floats are off by.
    void CheckLoss(const Place &normal) {
        double claim = bmr_budget_line_gap(&line_, &bodies_[0].mover, &bodies_[1].mover, units_);
        FUZZ_CHECK(std::isfinite(claim), "a new line claims %g", claim);
        if (fuzz_control("loss"))
            claim -= 4.0 / units_;
        double reaches = 0.0;
        for (const Body &body : bodies_)
            reaches += body.mover.reach * std::hypot(body.pose.c, body.pose.s) * units_;
        const mpq_class lost = exact::LeastAlong(normal, PlacesOf(0), PlacesOf(1)) - mpq_class(claim);
        FUZZ_CHECK(lost.get_d() * units_ <= 0x1p-22 * (std::fabs(claim) * units_ + 2.0 * reaches) + 3.0,
                   "a new line loses %g units", lost.get_d() * units_);
    }

    /// The pair, and its line.
    void Ask() {
        if (bodies_[0].moved + bodies_[1].moved > kMostMoved)
            known_ = false;
        if (bodies_[0].turned + bodies_[1].turned > kMostTurned)
            has_line_ = false;
        if (known_ && !IsDue()) {
            FUZZ_CHECK(IsFinite(bodies_[0].pose) && IsFinite(bodies_[1].pose),
                       "apart, and somewhere is nowhere");
            FUZZ_CHECK(exact::IsMoreThan(exact::LeastSquare(PlacesOf(0), PlacesOf(1)), threshold_),
                       "not due, and nearer than %g", threshold_.get_d());
        }
        if (!has_line_)
            return;
        double claim = bmr_budget_line_gap(&line_, &bodies_[0].mover, &bodies_[1].mover, units_);
        if (!(claim > 0.0)) {
            has_line_ = false;
            return;
        }
        if (fuzz_control("line"))
            claim += 4.0 / units_;
        bodies_[0].turned = bodies_[1].turned = 0;
        FUZZ_CHECK(IsFinite(bodies_[0].pose) && IsFinite(bodies_[1].pose), "a line of what is nowhere");
        const Places a = PlacesOf(0), b = PlacesOf(1);
        const Place normal = {mpq_class(line_.normal[0]), mpq_class(line_.normal[1])};
        FUZZ_CHECK(exact::LeastAlong(normal, a, b) >= claim, "a line claims %g", claim);
        FUZZ_CHECK(exact::LeastSquare(a, b) >= Square(mpq_class(claim)), "not so far apart as %g", claim);
        // As an engine does it: a pair that is due is renewed along its line.
        if (known_ && IsDue() && threshold_ < kLarge)
            Renew(exact::AtMost(mpq_class(claim) - threshold_));
    }

    void Sweep(const Body &body) {
        const bmr_vec2 to = {fuzz_number(bytes_), fuzz_number(bytes_)};
        const bmr_vec2 from = fuzz_u8(bytes_) < 200 ? body.mover.center : bmr_vec2{fuzz_number(bytes_), 0.0};
        const double half = fuzz_in(bytes_, -1.0, 1.0); // the tangent of half the turn
        const double turn = 2.0 * std::atan(half) * (1.0 + 0x1p-50);
        uint32_t bound = bmr_mover_sweep(&body.mover, from, to, turn, units_);
        FUZZ_CHECK(bound <= BMR_BUDGET_MARK, "a sweep adds %u", bound);
        if (bound == BMR_BUDGET_MARK)
            return;
        FUZZ_CHECK(IsFinite(body.pose) && std::isfinite(from.x + from.y + to.x + to.y),
                   "a sweep from or to nowhere is %u", bound);
        if (fuzz_control("sweep"))
            bound /= 2;
        const mpq_class t = mpq_class(fuzz_u8(bytes_)) / 255, q = half;
        const mpq_class c = (1 - q * q) / (1 + q * q), s = 2 * q / (1 + q * q);
        const Place center = {mpq_class(from.x) + t * (mpq_class(to.x) - mpq_class(from.x)),
                              mpq_class(from.y) + t * (mpq_class(to.y) - mpq_class(from.y))};
        for (const bmr_vec2 &point : body.points) {
            const Place arm = Way(PlaceOf(body.mover.pivot), PlaceOf(point));
            const Place turned =
                exact::Turned(c, s, exact::Turned(mpq_class(body.pose.c), mpq_class(body.pose.s), arm));
            const Place there = {center.x + turned.x, center.y + turned.y};
            FUZZ_CHECK(InUnits(Way(exact::At(body.pose, point), there), mpq_class(bound) + mpq_class(1, 32)),
                       "a sweep goes farther than %u", bound);
        }
    }

    fuzz_bytes *bytes_;
    double units_;
    Body bodies_[2];
    mpq_class threshold_;
    uint32_t deadline_ = 0;
    bmr_budget_line line_ = {{0.0f, 0.0f}, 0};
    bool known_ = false, has_line_ = false;
};

} // namespace

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_bytes bytes = fuzz_bytes_make(data, size);
    Script(&bytes).Run();
    return 0;
}
