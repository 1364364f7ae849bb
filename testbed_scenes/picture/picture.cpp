// SPDX-License-Identifier: MIT
#include "picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "picture/parts.h"
#include "picture/world_view.h"

namespace testbed {
namespace {

/// Smaller pictures keep their letters legible.
constexpr double kLeastUnit = 0.7;

/// In points of a picture 1200 wide.
constexpr double kPadding = 4.0, kHeight = 19.0;
/// Labels are tried at these distances, in so many directions.
constexpr double kDistances[] = {22.0, 34.0, 50.0, 75.0, 110.0};
constexpr int kDirections = 12;
/// From here on a line leads to the point.
constexpr double kLeaderFrom = 30.0;

bool Overlap(const Rectangle &a, const Rectangle &b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

/// Short texts beside points of a page, none over another or over the edge of its area. The canvas shows the
/// page itself (Canvas::ClearPanel).
class Labels {
public:
    Labels(Canvas &canvas, const Rectangle &area, double unit)
        : m_canvas(canvas), m_area(area), m_unit(unit) {}

    /// Keeps labels away from here.
    void Block(bmr_vec2 at, double radius);
    /// Writes a text near a point, with a line to the point where there is no room close by; nothing where
    /// there is no room at all.
    void Place(bmr_vec2 at, const std::string &text);
    /// Writes a text around a point, if it fits there and not elsewhere.
    void PlaceAt(bmr_vec2 at, const std::string &text, double size);

private:
    bool IsFree(const Rectangle &box) const;

    Canvas &m_canvas;
    const Rectangle m_area;
    const double m_unit;
    std::vector<Rectangle> m_taken;
};

void Labels::Block(bmr_vec2 at, double radius) {
    m_taken.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
}

bool Labels::IsFree(const Rectangle &box) const {
    return box.left >= m_area.left && box.right <= m_area.right && box.bottom >= m_area.bottom &&
           box.top <= m_area.top &&
           std::none_of(m_taken.begin(), m_taken.end(),
                        [&box](const Rectangle &taken) { return Overlap(box, taken); });
}

void Labels::Place(bmr_vec2 at, const std::string &text) {
    const double width = m_canvas.TextWidth(text, style::kTextSize * m_unit) + 2.0 * kPadding * m_unit;
    const double height = kHeight * m_unit;
    for (const double distance : kDistances) {
        for (int i = 0; i < kDirections; ++i) {
            // Right and left first.
            const double angle = M_PI * (i % 2 == 0 ? i : kDirections - i + 1) / kDirections * 2.0 + 0.3;
            const double reachX = 0.5 * width + distance * m_unit * std::fabs(std::cos(angle));
            const bmr_vec2 centre =
                bmr_vec2_make(at.x + std::copysign(reachX, std::cos(angle)) * std::fabs(std::cos(angle)),
                              at.y + (0.5 * height + distance * m_unit) * std::sin(angle));
            const Rectangle box = {centre.x - 0.5 * width, centre.y - 0.5 * height, centre.x + 0.5 * width,
                                   centre.y + 0.5 * height};
            const Rectangle near = {at.x - 4.0 * m_unit, at.y - 4.0 * m_unit, at.x + 4.0 * m_unit,
                                    at.y + 4.0 * m_unit};
            if (!IsFree(box) || Overlap(box, near))
                continue;
            if (distance >= kLeaderFrom) {
                const bmr_vec2 end = bmr_vec2_make(std::clamp(at.x, box.left, box.right),
                                                   std::clamp(at.y, box.bottom, box.top));
                m_canvas.Segment(at, end, {style::kFaintText, 0.8 * m_unit, 0.9, {}});
            }
            m_canvas.Box(box, {style::kStrip, 0.8});
            const double size = style::kTextSize * m_unit;
            m_canvas.Text(bmr_vec2_make(box.left + kPadding * m_unit, centre.y), 0.0, -0.36 * size, text,
                          size, Align::Left, style::kText);
            m_taken.push_back(box);
            return;
        }
    }
}

void Labels::PlaceAt(bmr_vec2 at, const std::string &text, double size) {
    const double halfWidth = 0.5 * m_canvas.TextWidth(text, size, true) + 2.0 * m_unit, half = 0.6 * size;
    const Rectangle box = {at.x - halfWidth, at.y - half, at.x + halfWidth, at.y + half};
    if (!IsFree(box))
        return;
    m_canvas.Text(at, 0.0, -0.36 * size, text, size, Align::Centre, style::kText, true);
    m_taken.push_back(box);
}

/// The middle of the corners of what a region shows of a body's polygons, in the world; nothing where it
/// shows none.
std::optional<bmr_vec2> PlaceIn(const WorldView &world, const Rectangle &region, int body) {
    bmr_vec2 sum = bmr_vec2_make(0.0, 0.0);
    double count = 0.0;
    for (const shown::Fixture *fixture : world.FixturesOf(body)) {
        if (fixture->shape != "polygon")
            continue;
        std::vector<bmr_vec2> seen = world.ToWorld(body, fixture->points);
        seen = Clipped(seen, bmr_vec2_make(-1.0, 0.0), -region.right);
        seen = Clipped(seen, bmr_vec2_make(1.0, 0.0), region.left);
        seen = Clipped(seen, bmr_vec2_make(0.0, -1.0), -region.top);
        seen = Clipped(seen, bmr_vec2_make(0.0, 1.0), region.bottom);
        for (const bmr_vec2 &corner : seen)
            sum = bmr_add(sum, corner);
        count += static_cast<double>(seen.size());
    }
    return count > 0.0 ? std::optional<bmr_vec2>(bmr_scale(1.0 / count, sum)) : std::nullopt;
}

bool IsKinetic(const shown::Frame &frame) {
    return frame.program == "world";
}

std::string TitleOf(const shown::Frame &frame) {
    const std::string title = frame.scene + ", step " + std::to_string(frame.step);
    if (IsKinetic(frame)) {
        char time[32];
        std::snprintf(time, sizeof time, "%.4g", frame.time);
        return frame.scene + ", time " + time;
    }
    if (frame.program == "off")
        return title + ", plugin off";
    return frame.program == "stock" ? title + ", stock Box2D" : title;
}

class Page {
public:
    Page(const WorldView &world, const PictureOptions &options)
        : m_world(world), m_options(options), m_title(TitleOf(world.Frame())), m_width(options.width),
          m_unit(std::max(options.width / 1200.0, kLeastUnit)) {}

    /// On the canvas that `make` makes of a width and a height.
    template <class Make> void Draw(Make make) {
        const Rectangle region = RegionOf(m_world.Frame(), m_options);
        const double high = std::round(m_width * region.Height() / region.Width());
        double strip = 0.0;
        {
            // How high the legend is, and with it the page, a canvas must tell that knows the font. (A PNG
            // that is not written is no file.)
            Canvas measure("legend.png", 1.0, 1.0);
            strip = Legend(measure, m_world, m_options, m_title, m_width, m_unit).Height();
        }
        m_explained = Explain(m_world, m_options, region);
        Canvas canvas = make(m_width, high + strip);
        canvas.Box({0.0, 0.0, m_width, high + strip}, {style::kStrip, 1.0});
        const Rectangle area = {0.0, strip, m_width, strip + high};
        canvas.Box(area, {style::kBackground, 1.0});
        canvas.SetPanel(area, region);
        const double pagePerWorld = canvas.Scale();
        DrawWorld(canvas);
        std::vector<Label> labels = LabelsOf(canvas, region);
        canvas.ClearPanel();
        const Rectangle bar = DrawScaleBar(canvas, area, pagePerWorld, m_unit, IsKinetic(m_world.Frame()));
        DrawLabels(canvas, area, bar, labels);
        Legend(canvas, m_world, m_options, m_title, m_width, m_unit).Draw(bmr_vec2_make(0.0, strip));
        canvas.Write();
    }

private:
    /// The bodies in focus, and those that an explained pair is about.
    bool IsNamed(int body) const {
        const auto &bodies = m_options.bodies;
        return std::find(bodies.begin(), bodies.end(), body) != bodies.end() ||
               std::any_of(m_explained.begin(), m_explained.end(), [body](const Explained &one) {
                   return one.pair->a == body || one.pair->b == body;
               });
    }

    void DrawWorld(Canvas &canvas) {
        const Layers &layers = m_options.layers;
        DrawBodies(canvas, m_world, m_unit,
                   [this](int body) { return !m_options.bodies.empty() && !IsNamed(body); });
        DrawJoints(canvas, m_world, m_unit);
        if (layers.trails)
            DrawTrails(canvas, m_options.trails,
                       m_world.Frame().period.x > 0.0f ? 0.5 * static_cast<double>(m_world.Frame().period.x)
                                                       : HUGE_VAL,
                       m_unit);
        if (layers.boxes)
            DrawBoxes(canvas, m_world, m_unit);
        if (const std::optional<Rectangle> box = PeriodicBoxOf(m_world.Frame()))
            DrawPeriodicBox(canvas, *box, m_unit);
        DrawOutlines(canvas, m_world, m_options, m_unit);
        if (layers.certificates || layers.slack)
            DrawProofs(canvas, m_world, m_options, m_unit);
        for (const Explained &one : m_explained)
            if (layers.certificates)
                DrawExplained(canvas, m_world, m_options, m_unit, one);
        if (layers.contacts)
            DrawContacts(canvas, m_world, m_unit);
        if (layers.handedOver)
            DrawHandedOver(canvas, m_world, m_options, m_unit);
        if (layers.events)
            DrawEvents(canvas, m_world, m_options, m_unit);
    }

    /// A text, and where it belongs on the page.
    struct Label {
        bmr_vec2 at;
        std::string text;
        bool isNumber; ///< of a body: it stands there or nowhere
    };

    /// Is it in focus, or in a pair with a body in focus?
    bool IsMet(int body) const {
        const std::vector<shown::Pair> &pairs = m_world.Frame().pairs;
        return IsNamed(body) || (!m_options.bodies.empty() &&
                                 std::any_of(pairs.begin(), pairs.end(), [&](const shown::Pair &pair) {
                                     return (pair.a == body || pair.b == body) && IsInFocus(m_options, pair);
                                 }));
    }

    /// The numbers of the bodies that are met; and how far apart those are whose proofs are drawn in full.
    std::vector<Label> LabelsOf(const Canvas &canvas, const Rectangle &region) const {
        std::vector<Label> labels;
        for (const shown::Body &body : m_world.Frame().bodies)
            if (IsMet(body.number))
                if (const std::optional<bmr_vec2> place = PlaceIn(m_world, region, body.number))
                    labels.push_back({canvas.OnPage(*place), std::to_string(body.number), true});
        for (const Explained &one : m_explained)
            if (m_options.layers.certificates)
                labels.push_back(
                    {canvas.OnPage(one.place),
                     LengthText(static_cast<double>(one.proof->slack), IsKinetic(m_world.Frame())), false});
        return labels;
    }

    void DrawLabels(Canvas &canvas, const Rectangle &area, const Rectangle &bar,
                    const std::vector<Label> &texts) const {
        Labels labels(canvas, area, m_unit);
        labels.Block(bmr_vec2_make(0.5 * (bar.left + bar.right), 0.5 * (bar.bottom + bar.top)),
                     0.5 * std::max(bar.Width(), bar.Height()));
        for (const Label &label : texts)
            if (!label.isNumber)
                labels.Block(label.at, 5.0 * m_unit);
        for (const Label &label : texts) {
            if (label.isNumber)
                labels.PlaceAt(label.at, label.text, 15.0 * m_unit);
            else
                labels.Place(label.at, label.text);
        }
    }

    const WorldView &m_world;
    const PictureOptions &m_options;
    const std::string m_title;
    const double m_width, m_unit;
    std::vector<Explained> m_explained;
};

} // namespace

std::optional<Rectangle> PeriodicBoxOf(const shown::Frame &frame) {
    if (!(frame.period.x > 0.0f))
        return std::nullopt;
    const double x = 0.5 * static_cast<double>(frame.period.x), y = 0.5 * static_cast<double>(frame.period.y);
    return Rectangle{-x, -y, x, y};
}

void DrawPicture(const shown::Frame &frame, const PictureOptions &options, const std::string &path) {
    const WorldView world(frame);
    Page(world, options).Draw([&path](double width, double height) { return Canvas(path, width, height); });
}

} // namespace testbed
