// SPDX-License-Identifier: MIT
#include "exact_distance.h"

#include "motions.h"

namespace exact {

namespace {

/// A vector, each of whose coordinates is off by less than `off`.
struct Rough {
    long double x, y, off;

    long double Size() const { return std::fabs(x) + std::fabs(y); }
};

/// Of the sizes that are added up: more than three roundings, in whichever direction.
constexpr long double kRounding = 0x1p-61L;

Rough Sum(const Rough &a, const Rough &b) {
    return {a.x + b.x, a.y + b.y, a.off + b.off + kRounding * (a.Size() + b.Size())};
}

mpq_class Cross(const Place &a, const Place &b) {
    return a.x * b.y - a.y * b.x;
}

/// The sign of the cross product. `exactly` returns the two as fractions.
template <class Exactly> int CrossSign(const Rough &a, const Rough &b, const Exactly &exactly) {
    const long double left = a.x * b.y, right = a.y * b.x, value = left - right;
    const long double off = kRounding * (std::fabs(left) + std::fabs(right)) +
                            2.0L * a.off * (b.Size() + b.off) + 2.0L * b.off * a.Size();
    if (std::fabs(value) > off)
        return value > 0.0L ? 1 : -1;
    const std::pair<Place, Place> v = exactly();
    return sgn(Cross(v.first, v.second));
}

/// One of the two polygons that are added up, B or -A, and how far the way around its border has come.
class Chain {
public:
    Chain(const Posed &posed, double sign) : m_points(posed.points), m_pose(posed.pose) {
        m_pose.c *= sign;
        m_pose.s *= sign;
        m_pose.position = {sign * m_pose.position.x, sign * m_pose.position.y};
        m_rounding = kRounding * (std::fabs(m_pose.c) + std::fabs(m_pose.s));
        const size_t n = m_points.size();
        m_count = n > 1 ? n : 0; // a point has no edge
        // The way begins with the first edge that goes up, or straight to the right.
        bool wasLower = m_count > 0 && IsLower(n - 1);
        for (size_t i = 0; i < m_count; ++i) {
            const bool isLower = IsLower(i);
            if (wasLower && !isLower)
                m_at = i;
            m_uppers += isLower ? 0 : 1;
            wasLower = isLower;
        }
        Update();
    }
    size_t Count() const { return m_count; }
    size_t At() const { return m_at; }
    bool IsDone() const { return m_passed == m_count; }
    void Pass() {
        m_at = m_at + 1 < m_points.size() ? m_at + 1 : 0;
        ++m_passed;
        Update();
    }

    Place Point(size_t i) const { return exact::At(m_pose, m_points[i]); }
    Place Edge(size_t i) const {
        const Place way = Way(PlaceOf(m_points[i]), PlaceOf(Next(i)));
        return Turned(mpq_class(m_pose.c), mpq_class(m_pose.s), way);
    }
    const Rough &RoughPoint() const { return m_point; }
    const Rough &RoughEdge() const { return m_edge; }
    /// Does the edge go down, or straight to the left?
    bool IsLower() const { return m_passed >= m_uppers; }

private:
    const bmr_vec2 &Next(size_t i) const { return m_points[i + 1 < m_points.size() ? i + 1 : 0]; }
    bool IsLower(size_t i) const {
        const bmr_vec2 &from = m_points[i], &to = Next(i);
        const double sx = m_pose.s * (to.x - from.x), cy = m_pose.c * (to.y - from.y), y = sx + cy;
        // Four roundings; small numbers are left to the fractions.
        if (std::fabs(y) > 0x1p-50 * (std::fabs(sx) + std::fabs(cy)) && std::fabs(y) > 1e-250)
            return y < 0.0;
        const Place edge = Edge(i);
        return edge.y < 0 || (edge.y == 0 && edge.x < 0);
    }
    Rough RoughlyTurned(long double x, long double y) const {
        const long double cx = m_pose.c * x, sy = m_pose.s * y, sx = m_pose.s * x, cy = m_pose.c * y;
        return {cx - sy, sx + cy, m_rounding * (std::fabs(x) + std::fabs(y))};
    }
    void Update() {
        const bmr_vec2 &from = m_points[m_at], &to = Next(m_at);
        m_point = Sum(RoughlyTurned(from.x, from.y), {m_pose.position.x, m_pose.position.y, 0.0L});
        m_edge =
            RoughlyTurned(static_cast<long double>(to.x) - from.x, static_cast<long double>(to.y) - from.y);
    }

    const std::vector<bmr_vec2> &m_points;
    bmr_pose m_pose;
    long double m_rounding; ///< of a size that is turned
    Rough m_point, m_edge;  ///< where the way has come to
    size_t m_count, m_uppers = 0, m_at = 0, m_passed = 0;
};

/// How far the origin is from the segment from p to p + e.
long double FromOrigin(const Rough &p, const Rough &e) {
    const long double along = -(p.x * e.x + p.y * e.y), square = e.x * e.x + e.y * e.y;
    if (!(along > 0.0L))
        return std::sqrt(p.x * p.x + p.y * p.y);
    if (along >= square)
        return std::sqrt((p.x + e.x) * (p.x + e.x) + (p.y + e.y) * (p.y + e.y));
    return std::fabs(p.x * e.y - p.y * e.x) / std::sqrt(square);
}

struct Nearest {
    Place place;
    bool corner;
};

Nearest NearestToOrigin(const Place &p, const Place &e) {
    const mpq_class along = -Product(p, e), square = Square(e);
    if (along <= 0)
        return {p, true};
    const bool end = along >= square;
    const mpq_class part = end ? mpq_class(1) : mpq_class(along / square);
    return {{p.x + part * e.x, p.y + part * e.y}, end};
}

/// A segment: an edge of a ring. Or one of the difference: an edge of the one, from a corner of the other.
struct Step {
    size_t a, b;
    bool ofB;
    long double distance, off; ///< of the origin
};

/// The segments around a border. The end of each is where the next begins.
class Steps {
public:
    void Add(size_t edge, size_t corner, bool ofB, const Rough &p, const Rough &e) {
        const long double off = p.off + e.off + kRounding * (p.Size() + e.Size());
        // Where the end is the nearest for certain, it is left to the next.
        const long double behind = (p.x + e.x) * e.x + (p.y + e.y) * e.y;
        if (behind < -8.0L * off * (p.Size() + e.Size()))
            return;
        // Where its beginning is, and farther away than another, no root is taken.
        const long double far = m_high + 4.0L * off, square = p.x * p.x + p.y * p.y;
        if (p.x * e.x + p.y * e.y >= 0.0L && square > far * far * (1.0L + 8.0L * kRounding))
            return;
        const Step step = {ofB ? corner : edge, ofB ? edge : corner, ofB, FromOrigin(p, e), 4.0L * off};
        m_low = std::min(m_low, step.distance - step.off);
        m_high = std::min(m_high, step.distance + step.off);
        if (step.distance - step.off <= m_high)
            m_steps.push_back(step);
    }

    /// The least distance is between them.
    long double Low() const { return m_low; }
    long double High() const { return m_high; }

    /// The nearest point to the origin. `exactly` returns where a segment begins and the way along it.
    template <class Exactly> Nearest Find(const Exactly &exactly) const {
        Nearest nearest;
        mpq_class least = -1;
        for (const Step &step : m_steps) {
            if (step.distance - step.off > m_high)
                continue;
            const std::pair<Place, Place> segment = exactly(step.a, step.b, step.ofB);
            const Nearest found = NearestToOrigin(segment.first, segment.second);
            const mpq_class square = Square(found.place);
            if (least < 0 || square < least) {
                nearest = found;
                least = square;
            }
        }
        return nearest;
    }

private:
    std::vector<Step> m_steps; ///< that may have the nearest point
    long double m_low = INFINITY, m_high = INFINITY;
};

/// The difference's border, once around.
class Border {
public:
    Border(const Posed &a, const Posed &b) : m_a(a, -1.0), m_b(b, 1.0) {
        m_inside = m_a.Count() + m_b.Count() > 0;
        if (!m_inside) // both are points
            m_steps.Add(0, 0, true, Sum(m_a.RoughPoint(), m_b.RoughPoint()), {0.0L, 0.0L, 0.0L});
        while (!m_a.IsDone() || !m_b.IsDone())
            Take();
    }
    bool IsInside() const { return m_inside; }
    const Steps &GetSteps() const { return m_steps; }
    Nearest NearestPoint() const {
        return m_steps.Find([this](size_t atA, size_t atB, bool ofB) { return Segment(atA, atB, ofB); });
    }

private:
    std::pair<Place, Place> Segment(size_t atA, size_t atB, bool ofB) const {
        const Place a = m_a.Point(atA), b = m_b.Point(atB);
        return {{a.x + b.x, a.y + b.y}, ofB ? m_b.Edge(atB) : m_a.Edge(atA)};
    }

    /// Does B's edge come before the one of -A, by direction?
    bool IsNextOfB() const {
        if (m_a.IsDone() || m_b.IsDone())
            return m_a.IsDone();
        if (m_a.IsLower() != m_b.IsLower())
            return m_a.IsLower();
        return CrossSign(m_b.RoughEdge(), m_a.RoughEdge(),
                         [&] { return std::make_pair(m_b.Edge(m_b.At()), m_a.Edge(m_a.At())); }) >= 0;
    }

    void Take() {
        const bool ofB = IsNextOfB();
        Chain &chain = ofB ? m_b : m_a;
        const Rough p = Sum(m_a.RoughPoint(), m_b.RoughPoint()), &e = chain.RoughEdge();
        m_steps.Add(chain.At(), (ofB ? m_a : m_b).At(), ofB, p, e);
        // Not with p + e: an edge may be nothing beside p.
        m_inside = m_inside && CrossSign(p, e, [&] { return Segment(m_a.At(), m_b.At(), ofB); }) > 0;
        chain.Pass();
    }

    Chain m_a, m_b;
    Steps m_steps;
    bool m_inside;
};

long double Rounded(const mpf_class &x) {
    const double high = x.get_d();
    return static_cast<long double>(high) + mpf_class(x - high).get_d();
}

long double RoundedRoot(const mpq_class &square) {
    return Rounded(sqrt(mpf_class(square, 128)));
}

/// The largest <sign d, p> of a point.
mpq_class Farthest(bmr_vec2 d, double sign, const Posed &posed) {
    const bmr_pose &q = posed.pose;
    // The direction, in the frame of the points.
    const long double x = sign * (static_cast<long double>(q.c) * d.x + static_cast<long double>(q.s) * d.y),
                      y = sign * (static_cast<long double>(q.c) * d.y - static_cast<long double>(q.s) * d.x);
    const long double off = 4.0L * kRounding * (std::fabs(q.c) + std::fabs(q.s)) *
                            (std::fabs(d.x) + std::fabs(static_cast<long double>(d.y)));
    const auto along = [&](const bmr_vec2 &p) { return x * p.x + y * p.y; };
    const auto error = [&](const bmr_vec2 &p) { return off * (std::fabs(p.x) + std::fabs(p.y)); };
    long double bound = -INFINITY;
    for (const bmr_vec2 &p : posed.points)
        bound = std::max(bound, along(p) - error(p));
    const Place exactly = PlaceOf({sign * d.x, sign * d.y});
    bool any = false;
    mpq_class most;
    for (const bmr_vec2 &p : posed.points) {
        if (along(p) + error(p) < bound)
            continue;
        const mpq_class value = Product(exactly, At(q, p));
        if (!any || value > most)
            most = value;
        any = true;
    }
    return most;
}

} // namespace

Gap GapOf(const Posed &a, const Posed &b) {
    const Border border(a, b);
    const Nearest nearest = border.NearestPoint();
    return {nearest.place, border.IsInside(), nearest.corner};
}

double Distance(const Posed &a, const Posed &b) {
    const Border border(a, b);
    if (border.IsInside())
        return 0.0;
    const auto low = static_cast<double>(border.GetSteps().Low()),
               high = static_cast<double>(border.GetSteps().High());
    return low == high ? low : static_cast<double>(RoundedRoot(Square(border.NearestPoint().place)));
}

long double SignedDistance(const Posed &a, const Posed &b) {
    const Gap gap = GapOf(a, b);
    return gap.overlap ? -RoundedRoot(Square(gap.way)) : RoundedRoot(Square(gap.way));
}

long double DistanceToRing(bmr_vec2 p, const std::vector<bmr_vec2> &ring) {
    const auto next = [&ring](size_t i) { return ring[i + 1 < ring.size() ? i + 1 : 0]; };
    const auto way = [](bmr_vec2 from, bmr_vec2 to) {
        const long double x = static_cast<long double>(to.x) - from.x,
                          y = static_cast<long double>(to.y) - from.y;
        return Rough{x, y, kRounding * (std::fabs(x) + std::fabs(y))};
    };
    Steps steps;
    for (size_t i = 0; i < ring.size(); ++i)
        steps.Add(i, 0, false, way(p, ring[i]), way(ring[i], next(i)));
    const Nearest nearest = steps.Find([&](size_t i, size_t, bool) {
        const Place from = PlaceOf(ring[i]);
        return std::make_pair(Way(PlaceOf(p), from), Way(from, PlaceOf(next(i))));
    });
    return RoundedRoot(Square(nearest.place));
}

long double SeparationAlong(bmr_vec2 d, const Posed &a, const Posed &b) {
    const mpq_class along = -Farthest(d, -1.0, b) - Farthest(d, 1.0, a);
    return Rounded(mpf_class(along, 128)) /
           std::hypot(static_cast<long double>(d.x), static_cast<long double>(d.y));
}

long double NearDistance(const Posed &a, const Posed &b) {
    const Border border(a, b);
    return border.IsInside() ? 0.0L : border.GetSteps().High();
}

} // namespace exact

double test_distance(const bmr_polygon *a, const bmr_polygon *b, const bmr_pose *b_in_a) {
    return exact::Distance(exact::PosedOf(a), exact::PosedOf(b, *b_in_a));
}
