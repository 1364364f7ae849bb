// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>

#include "drawing/surface.h"

namespace testbed {
namespace {

struct Colour {
    double red, green, blue;
};

// Those of Box2D's testbed (b2World::DebugDraw and the testbed's own draw.cpp).
constexpr Colour kBackground = {0.15, 0.15, 0.16};
constexpr Colour kStrip = {0.1, 0.1, 0.11};
constexpr Colour kJoint = {0.5, 0.8, 0.8};
// Ours: what stands out against those.
constexpr Colour kCertified = {0.25, 0.85, 1.0};
constexpr Colour kUnproved = {1.0, 0.75, 0.2};
constexpr Colour kNear = {0.75, 0.75, 0.75};
constexpr Colour kContact = {1.0, 0.35, 0.3};
constexpr Colour kText = {0.86, 0.86, 0.86};

struct StateColour {
    const char *state;
    Colour colour;
};
constexpr std::array<StateColour, 6> kStates = {{{"dynamic", {0.9, 0.7, 0.7}},
                                                 {"sleeping", {0.6, 0.6, 0.6}},
                                                 {"kinematic", {0.5, 0.5, 0.9}},
                                                 {"static", {0.5, 0.9, 0.5}},
                                                 {"sensor", {0.85, 0.8, 0.45}},
                                                 {"disabled", {0.5, 0.5, 0.3}}}};

constexpr double kFillOpacity = 0.42, kSensorOpacity = 0.45;
/// In pixels of a picture 1200 wide.
constexpr double kEdgeWidth = 0.9, kChainWidth = 1.6;
/// The picture's height is kept between these multiples of its width.
constexpr double kFlattest = 0.35, kTallest = 1.1;
/// Share of the frame left empty around what it shows.
constexpr double kMargin = 0.04;
/// Bodies outside of the middle part of all, widened by kReach of its size, are taken for runaways.
constexpr double kMiddleFrom = 0.05, kReach = 0.3;
/// So many strokes across gaps may be opaque; more are made fainter, or they would hide the bodies.
constexpr double kOpaquePairs = 400.0;

const Colour &ColourOf(const std::string &state) {
    for (const StateColour &entry : kStates)
        if (state == entry.state)
            return entry.colour;
    return kStates[0].colour;
}

struct Box {
    double left = std::numeric_limits<double>::max(), bottom = std::numeric_limits<double>::max();
    double right = std::numeric_limits<double>::lowest(), top = std::numeric_limits<double>::lowest();

    void Add(double x, double y) {
        left = std::min(left, x);
        right = std::max(right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    }
    void Add(const Box &other) {
        Add(other.left, other.bottom);
        Add(other.right, other.top);
    }
    bool IsEmpty() const { return left > right || bottom > top; }
    double Width() const { return right - left; }
    double Height() const { return top - bottom; }
    Box Intersected(const Box &other) const {
        Box box;
        box.left = std::max(left, other.left);
        box.bottom = std::max(bottom, other.bottom);
        box.right = std::min(right, other.right);
        box.top = std::min(top, other.top);
        return box;
    }
    Box Widened(double share) const {
        const double by = share * std::max(Width(), Height());
        Box box;
        box.Add(left - by, bottom - by);
        box.Add(right + by, top + by);
        return box;
    }
};

Box BoxOf(const Outline::Shape &shape) {
    Box box;
    for (const Point &point : shape.points) {
        box.Add(point.x - shape.radius, point.y - shape.radius);
        box.Add(point.x + shape.radius, point.y + shape.radius);
    }
    return box;
}

double Quantile(std::vector<double> values, double share) {
    const auto index = static_cast<size_t>(std::lround(share * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
    return values[index];
}

/// Where the scene happens: around the moving bodies without runaways, with as much of the ground as lies
/// near.
Box FrameOf(const Outline &outline) {
    std::vector<Box> moving, resting;
    for (const Outline::Shape &shape : outline.shapes)
        (shape.state == "static" ? resting : moving).push_back(BoxOf(shape));
    if (moving.empty())
        std::swap(moving, resting);
    auto quantile = [&moving](double Box::*side, double share) {
        std::vector<double> values;
        values.reserve(moving.size());
        for (const Box &box : moving)
            values.push_back(box.*side);
        return Quantile(std::move(values), share);
    };
    Box middle;
    middle.Add(quantile(&Box::left, kMiddleFrom), quantile(&Box::bottom, kMiddleFrom));
    middle.Add(quantile(&Box::right, 1.0 - kMiddleFrom), quantile(&Box::top, 1.0 - kMiddleFrom));
    const Box reach = middle.Widened(kReach);
    Box frame = middle;
    for (const std::vector<Box> *boxes : {&moving, &resting})
        for (const Box &box : *boxes)
            if (const Box seen = box.Intersected(reach); !seen.IsEmpty())
                frame.Add(seen);
    return frame.Widened(kMargin);
}

class Painter {
public:
    Painter(cairo_t *cairo, const Outline &outline, const Box &frame, double width, double height)
        : m_cairo(cairo), m_outline(outline), m_frame(frame), m_scale(width / frame.Width()), m_width(width),
          m_height(height), m_unit(width / 1200.0) {}

    void Paint(const std::string &title, double stripHeight) {
        SetColour(kBackground, 1.0);
        cairo_paint(m_cairo);
        cairo_save(m_cairo);
        cairo_rectangle(m_cairo, 0.0, 0.0, m_width, m_height);
        cairo_clip(m_cairo);
        cairo_set_line_join(m_cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(m_cairo, CAIRO_LINE_CAP_ROUND);
        // What stands still first, so that what moves lies on top.
        PaintShapes([](const std::string &state) { return state == "static"; });
        PaintShapes([](const std::string &state) { return state != "static"; });
        PaintPairs();
        PaintJoints();
        PaintContacts();
        cairo_restore(m_cairo);
        PaintStrip(title, stripHeight);
    }

private:
    void SetColour(const Colour &colour, double opacity) {
        cairo_set_source_rgba(m_cairo, colour.red, colour.green, colour.blue, opacity);
    }
    Point OnPaper(const Point &point) const {
        return {(point.x - m_frame.left) * m_scale, (m_frame.top - point.y) * m_scale};
    }
    void MoveTo(const Point &point) { cairo_move_to(m_cairo, OnPaper(point).x, OnPaper(point).y); }
    void LineTo(const Point &point) { cairo_line_to(m_cairo, OnPaper(point).x, OnPaper(point).y); }
    void Disc(const Point &point, double radius) {
        cairo_new_sub_path(m_cairo);
        cairo_arc(m_cairo, OnPaper(point).x, OnPaper(point).y, radius, 0.0, 2.0 * M_PI);
    }

    using ShapeIterator = std::vector<Outline::Shape>::const_iterator;

    void PaintShapes(const std::function<bool(const std::string &)> &isWanted) {
        const std::vector<Outline::Shape> &shapes = m_outline.shapes;
        for (ShapeIterator begin = shapes.begin(); begin != shapes.end();) {
            // A body's shapes follow each other.
            const ShapeIterator end = std::find_if(begin, shapes.end(), [begin](const Outline::Shape &shape) {
                return shape.body != begin->body || shape.state != begin->state || shape.kind != begin->kind;
            });
            if (isWanted(begin->state)) {
                if (end - begin > 1 && begin->kind == Outline::Kind::Polygon && begin->state != "sensor")
                    PaintSilhouette(begin, end);
                else
                    std::for_each(begin, end, [this](const Outline::Shape &shape) { PaintShape(shape); });
            }
            begin = end;
        }
    }

    void TracePath(const Outline::Shape &shape) {
        cairo_new_path(m_cairo);
        if (shape.kind == Outline::Kind::Circle) {
            Disc(shape.points[0], shape.radius * m_scale);
            return;
        }
        MoveTo(shape.points[0]);
        for (size_t i = 1; i < shape.points.size(); ++i)
            LineTo(shape.points[i]);
        if (shape.kind == Outline::Kind::Polygon)
            cairo_close_path(m_cairo);
    }

    /// A body of several polygons: all edges first, then the insides, opaque, over those edges that are inner
    /// ones. Drawn one by one, a fan of 63 triangles would be nothing but edges.
    void PaintSilhouette(ShapeIterator begin, ShapeIterator end) {
        const Colour &colour = ColourOf(begin->state);
        SetColour(colour, 0.95);
        cairo_set_line_width(m_cairo, 2.0 * kEdgeWidth * m_unit);
        for (ShapeIterator shape = begin; shape != end; ++shape) {
            TracePath(*shape);
            cairo_stroke(m_cairo);
        }
        auto mixed = [](double over, double under) {
            return kFillOpacity * over + (1.0 - kFillOpacity) * under;
        };
        SetColour({mixed(colour.red, kBackground.red), mixed(colour.green, kBackground.green),
                   mixed(colour.blue, kBackground.blue)},
                  1.0);
        for (ShapeIterator shape = begin; shape != end; ++shape) {
            TracePath(*shape);
            cairo_fill(m_cairo);
        }
    }

    void PaintShape(const Outline::Shape &shape) {
        const Colour &colour = ColourOf(shape.state);
        const bool isSensor = shape.state == "sensor";
        TracePath(shape);
        if (shape.kind != Outline::Kind::Chain && !isSensor) {
            SetColour(colour, kFillOpacity);
            cairo_fill_preserve(m_cairo);
        }
        if (shape.kind == Outline::Kind::Circle) {
            // A radius shows how it is turned.
            MoveTo(shape.points[0]);
            LineTo({shape.points[0].x + shape.radius * std::cos(shape.angle),
                    shape.points[0].y + shape.radius * std::sin(shape.angle)});
        }
        SetColour(colour, isSensor ? kSensorOpacity : 0.95);
        cairo_set_line_width(m_cairo,
                             (shape.kind == Outline::Kind::Chain ? kChainWidth : kEdgeWidth) * m_unit);
        cairo_stroke(m_cairo);
    }

    static const Colour &ColourOf(const Outline::Pair &pair) {
        return pair.slack > 0.0 ? kCertified : pair.slack < 0.0 ? kNear : kUnproved;
    }
    static const Colour &ColourOf(const std::string &state) { return testbed::ColourOf(state); }

    void PaintPairs() {
        const double opacity =
            std::clamp(kOpaquePairs / (1.0 + static_cast<double>(m_outline.pairs.size())), 0.12, 0.9);
        for (const Outline::Pair &pair : m_outline.pairs) {
            cairo_new_path(m_cairo);
            MoveTo(pair.a);
            LineTo(pair.b);
            SetColour(ColourOf(pair), opacity);
            cairo_set_line_width(m_cairo, 1.3 * m_unit);
            cairo_stroke(m_cairo);
        }
    }

    void PaintJoints() {
        SetColour(kJoint, 0.8);
        cairo_set_line_width(m_cairo, 1.2 * m_unit);
        for (const Outline::Pair &joint : m_outline.joints) {
            cairo_new_path(m_cairo);
            MoveTo(joint.a);
            LineTo(joint.b);
            cairo_stroke(m_cairo);
            Disc(joint.a, 2.0 * m_unit);
            Disc(joint.b, 2.0 * m_unit);
            cairo_fill(m_cairo);
        }
    }

    void PaintContacts() {
        SetColour(kContact, 0.9);
        for (const Point &contact : m_outline.contacts) {
            cairo_new_path(m_cairo);
            Disc(contact, 1.8 * m_unit);
            cairo_fill(m_cairo);
        }
    }

    enum class Mark { Square, Stroke, Disc };
    struct Entry {
        Colour colour;
        Mark mark;
        std::string text;
    };

    /// The legend: what there is in this picture, and nothing else.
    std::vector<Entry> Entries() const {
        std::vector<Entry> entries;
        for (const StateColour &state : kStates) {
            const bool isPresent =
                std::any_of(m_outline.shapes.begin(), m_outline.shapes.end(),
                            [&state](const auto &shape) { return shape.state == state.state; });
            if (isPresent)
                entries.push_back({state.colour, Mark::Square, state.state});
        }
        size_t certified = 0, unproved = 0, unasked = 0;
        for (const Outline::Pair &pair : m_outline.pairs)
            ++(pair.slack > 0.0 ? certified : pair.slack < 0.0 ? unasked : unproved);
        auto addPairs = [&entries](const Colour &colour, const char *text, size_t count) {
            if (count != 0)
                entries.push_back(
                    {colour, Mark::Stroke, text + std::to_string(count) + (count == 1 ? " pair" : " pairs")});
        };
        addPairs(kCertified, "proved apart: ", certified);
        addPairs(kUnproved, "touching or not proved: ", unproved);
        addPairs(kNear, "near: ", unasked);
        if (!m_outline.contacts.empty())
            entries.push_back(
                {kContact, Mark::Disc, "contact points: " + std::to_string(m_outline.contacts.size())});
        return entries;
    }

    void SelectFont(cairo_font_weight_t weight, double size) {
        cairo_select_font_face(m_cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, weight);
        cairo_set_font_size(m_cairo, size);
    }

    double TextWidth(const std::string &text) {
        cairo_text_extents_t extents;
        cairo_text_extents(m_cairo, text.c_str(), &extents);
        return extents.x_advance;
    }

    void PaintText(double x, double y, double size, const std::string &text) {
        SetColour(kText, 1.0);
        // Centred on the capitals' height, which does not depend on the letters.
        cairo_move_to(m_cairo, x, y + 0.36 * size);
        cairo_show_text(m_cairo, text.c_str());
    }

    void PaintMark(double x, double y, double size, const Entry &entry) {
        cairo_new_path(m_cairo);
        SetColour(entry.colour, 1.0);
        switch (entry.mark) {
        case Mark::Square:
            cairo_rectangle(m_cairo, x, y - 0.5 * size, size, size);
            SetColour(entry.colour, kFillOpacity);
            cairo_fill_preserve(m_cairo);
            SetColour(entry.colour, 1.0);
            cairo_set_line_width(m_cairo, 0.09 * size);
            cairo_stroke(m_cairo);
            break;
        case Mark::Stroke:
            cairo_move_to(m_cairo, x, y);
            cairo_line_to(m_cairo, x + size, y);
            cairo_set_line_width(m_cairo, 0.2 * size);
            cairo_stroke(m_cairo);
            break;
        case Mark::Disc:
            cairo_arc(m_cairo, x + 0.5 * size, y, 0.28 * size, 0.0, 2.0 * M_PI);
            cairo_fill(m_cairo);
            break;
        }
    }

    /// Title and legend; smaller where they would not fit the width.
    void PaintStrip(const std::string &title, double height) {
        SetColour(kStrip, 1.0);
        cairo_rectangle(m_cairo, 0.0, m_height, m_width, height);
        cairo_fill(m_cairo);
        const std::vector<Entry> entries = Entries();
        // In multiples of the letters' size.
        constexpr double kTitle = 1.15, kMark = 0.85, kAfterMark = 0.45, kAfterEntry = 1.5, kAtEnds = 1.2;
        double size = 13.0 * m_unit;
        SelectFont(CAIRO_FONT_WEIGHT_BOLD, kTitle * size);
        const double titleWidth = TextWidth(title);
        SelectFont(CAIRO_FONT_WEIGHT_NORMAL, size);
        double needed = titleWidth + 2.0 * kAtEnds * size;
        for (const Entry &entry : entries)
            needed += TextWidth(entry.text) + (kMark + kAfterMark + kAfterEntry) * size;
        const double shrink = std::min(1.0, m_width / needed);
        size *= shrink;

        const double y = m_height + 0.5 * height;
        double x = kAtEnds * size;
        SelectFont(CAIRO_FONT_WEIGHT_BOLD, kTitle * size);
        PaintText(x, y, kTitle * size, title);
        x += shrink * titleWidth + kAfterEntry * size;
        SelectFont(CAIRO_FONT_WEIGHT_NORMAL, size);
        for (const Entry &entry : entries) {
            PaintMark(x, y, kMark * size, entry);
            x += (kMark + kAfterMark) * size;
            PaintText(x, y, size, entry.text);
            x += TextWidth(entry.text) + kAfterEntry * size;
        }
    }

    cairo_t *m_cairo;
    const Outline &m_outline;
    Box m_frame;
    double m_scale; ///< units of paper per metre
    double m_width, m_height;
    double m_unit; ///< a pixel of a picture 1200 wide
};

} // namespace

void DrawPicture(const Outline &outline, const std::string &title, const std::string &path, int width) {
    Box frame = FrameOf(outline);
    // A frame of an awkward shape gets more of its surroundings, about its own middle.
    const double wantedHeight = std::max(frame.Height(), kFlattest * frame.Width());
    const double wantedWidth = std::max(frame.Width(), wantedHeight / kTallest);
    const double centreX = 0.5 * (frame.left + frame.right), centreY = 0.5 * (frame.bottom + frame.top);
    frame = Box();
    frame.Add(centreX - 0.5 * wantedWidth, centreY - 0.5 * wantedHeight);
    frame.Add(centreX + 0.5 * wantedWidth, centreY + 0.5 * wantedHeight);

    const double height = std::round(width * frame.Height() / frame.Width());
    const double strip = std::round(40.0 * width / 1200.0);
    Surface surface(path, width, height + strip);
    Painter(surface.Cairo(), outline, frame, width, height).Paint(title, strip);
    surface.Write();
}

} // namespace testbed
