// SPDX-License-Identifier: MIT
#include "picture/picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "picture/parts.h"
#include "picture/world_view.h"

namespace testbed {
namespace {

// --- the legend ---

/// In points of a picture 1200 wide.
constexpr double kRow = 24.0, kAround = 14.0, kAfterSample = 7.0, kAfterEntry = 20.0, kSample = 24.0;
constexpr double kScale = 170.0;

std::string Counted(std::size_t count, const char *one, const char *many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// What is in a picture, with a sample of each: rows of entries below it.
class Legend {
public:
    /// Lays the entries out in rows of this width (of the page). One of a series explains what the whole
    /// series holds, without counts. A kinetic world has words of its own.
    Legend(Canvas &canvas, const WorldView &world, const PictureOptions &options, std::string title,
           double width, double unit)
        : m_canvas(canvas), m_options(options), m_kinetic(world.Frame().program == "world"), m_unit(unit),
          m_title(std::move(title)) {
        if (options.series)
            m_contents = *options.series;
        else
            AddContents(world.Frame(), options, &m_contents);
        AddBodies();
        if (world.Frame().period.x > 0.0f)
            AddLine("periodic box", {style::kText, 1.6 * m_unit, 0.8, {9.0 * m_unit, 5.0 * m_unit}});
        AddProofs();
        AddOthers();
        LayOut(width);
    }

    double Height() const { return std::ceil((m_rows * kRow + kAround) * m_unit); }
    /// Its upper left corner at `top`, on the page.
    void Draw(bmr_vec2 top) const {
        const auto middle = [&](int row) { return top.y - (0.5 * kAround + (row + 0.5) * kRow) * m_unit; };
        const double title = 1.15 * style::kTextSize * m_unit, size = style::kTextSize * m_unit;
        m_canvas.Text(bmr_vec2_make(top.x + kAround * m_unit, middle(0)), 0.0, -0.36 * title, m_title, title,
                      Align::Left, style::kText, true);
        for (const Entry &entry : m_entries) {
            const bmr_vec2 at = bmr_vec2_make(top.x + entry.left, middle(entry.row));
            entry.draw(at);
            m_canvas.Text(at, entry.sample + kAfterSample * m_unit, -0.36 * size, entry.text, size,
                          Align::Left, style::kText);
        }
    }

private:
    struct Entry {
        std::string text;
        double sample; ///< width that the sample takes
        /// Draws the sample in a box of the sample's width whose left end's middle this is.
        std::function<void(bmr_vec2 left)> draw;
        double left = 0.0;
        int row = 0;
    };
    void Add(const std::string &text, double sample, std::function<void(bmr_vec2)> draw) {
        Entry entry;
        entry.text = text;
        entry.sample = sample * m_unit;
        entry.draw = std::move(draw);
        m_entries.push_back(std::move(entry));
    }

    void AddLine(const std::string &text, const Pen &pen) {
        Add(text, kSample, [this, pen](bmr_vec2 left) {
            m_canvas.Segment(left, bmr_vec2_make(left.x + kSample * m_unit, left.y), pen);
        });
    }

    void AddBodies() {
        for (const char *state : {"dynamic", "sleeping", "kinematic", "static", "sensor", "disabled"}) {
            if (m_contents.states.count(state) == 0)
                continue;
            const Colour colour = ColourOfState(state);
            const bool isSensor = state == std::string("sensor");
            Add(state, 13.0, [this, colour, isSensor](bmr_vec2 left) {
                const double half = 6.0 * m_unit, right = left.x + 13.0 * m_unit;
                std::vector<double> dash;
                if (isSensor)
                    dash = {3.0 * m_unit, 2.0 * m_unit};
                m_canvas.Box({left.x, left.y - half, right, left.y + half},
                             {colour, isSensor ? 0.0 : style::kFillOpacity},
                             {colour, 1.2 * m_unit, 1.0, dash});
            });
        }
    }

    void AddScale() {
        Add(m_kinetic ? "slack" : "slack, m", kScale, [this](bmr_vec2 left) {
            constexpr int kSteps = 64;
            const double width = kScale * m_unit, bar = 5.0 * m_unit;
            for (int i = 0; i < kSteps; ++i) {
                const double share = (i + 0.5) / kSteps;
                // Each lies over the end of the one before: no seams.
                const double from = left.x + width * i / kSteps, to = left.x + width;
                const Colour colour = ColourOfSlack(kLeastSlack * std::pow(kMostSlack / kLeastSlack, share));
                m_canvas.Box({from, left.y, to, left.y + bar}, {colour, 1.0});
            }
            const int decades = static_cast<int>(std::lround(std::log10(kMostSlack / kLeastSlack)));
            for (int i = 0; i <= decades; ++i) {
                char text[16];
                std::snprintf(text, sizeof text, "%g", kLeastSlack * std::pow(10.0, i));
                const double x = left.x + width * i / decades;
                m_canvas.Text(bmr_vec2_make(x, left.y), 0.0, -10.5 * m_unit, text, 10.5 * m_unit,
                              i == 0         ? Align::Left
                              : i == decades ? Align::Right
                                             : Align::Centre,
                              style::kText);
            }
        });
    }

    void AddProofs() {
        std::map<std::string, std::size_t> &kinds = m_contents.proofs;
        const bool counts = !m_options.series;
        const auto text = [counts](const char *what, std::size_t count) {
            return counts ? what + (": " + std::to_string(count)) : std::string(what);
        };
        if (m_options.layers.certificates) {
            const Colour colour = m_options.layers.slack ? ColourOfSlack(0.3) : style::kCertificate;
            const std::size_t edges = kinds["remembered-edge"] + kinds["edge-line"];
            if (edges != 0) {
                Add(text("apart by an edge and the vertex opposite", edges), kSample,
                    [this, colour](bmr_vec2 left) {
                        const double low = left.y - 6.0 * m_unit, high = left.y + 6.0 * m_unit;
                        m_canvas.Segment(bmr_vec2_make(left.x, low),
                                         bmr_vec2_make(left.x + kSample * m_unit, low),
                                         {colour, 3.5 * m_unit, 1.0, {}});
                        const bmr_vec2 vertex = bmr_vec2_make(left.x + 0.5 * kSample * m_unit, high);
                        m_canvas.Segment(bmr_vec2_make(vertex.x, low), vertex,
                                         {colour, 1.2 * m_unit, 1.0, {}});
                        m_canvas.Dot(vertex, 2.4 * m_unit, colour);
                    });
            }
            if (kinds["direction"] != 0)
                AddLine(text("apart along a direction", kinds["direction"]),
                        {colour, 1.4 * m_unit, 1.0, {6.0 * m_unit, 4.0 * m_unit}});
            if (kinds["disks"] != 0)
                AddLine(text("apart by bounding disks", kinds["disks"]),
                        {colour, 1.8 * m_unit, 1.0, {1.0 * m_unit, 3.2 * m_unit}});
        }
        if (m_options.layers.slack && !kinds.empty())
            AddScale();
        if (m_options.layers.disks)
            AddLine("disk of a body", {style::kDisk, 1.2 * m_unit, 0.9, {6.0 * m_unit, 3.0 * m_unit}});
    }

    void AddOthers() {
        const std::size_t handedOver = m_contents.handedOver, points = m_contents.points;
        const bool counts = !m_options.series;
        if (m_options.layers.handedOver && handedOver != 0)
            Add(counts ? "needed a manifold: " + Counted(handedOver, "pair", "pairs") : "needed a manifold",
                11.0, [this](bmr_vec2 left) {
                    const double half = 5.0 * m_unit;
                    const bmr_vec2 at = bmr_vec2_make(left.x + half, left.y);
                    m_canvas.Polygon({bmr_vec2_make(at.x - half, at.y), bmr_vec2_make(at.x, at.y - half),
                                      bmr_vec2_make(at.x + half, at.y), bmr_vec2_make(at.x, at.y + half)},
                                     {}, {style::kHandedOver, 1.4 * m_unit, 1.0, {}});
                });
        std::string events = "event of a certificate";
        const std::map<std::string, std::size_t> &kinds = m_contents.events;
        if (counts) {
            events = "in this step:";
            const auto add = [&events](std::size_t count, const std::string &kind) {
                events += (events.back() == ':' ? " " : ", ") + std::to_string(count) + " " + kind;
            };
            // Those of most structures in the order of a certificate's life, then what only some have.
            std::map<std::string, std::size_t> others = kinds;
            for (const char *kind : {"start", "push", "stab", "roll", "coarsen", "contact", "leave", "part"})
                if (const auto found = others.find(kind); found != others.end()) {
                    add(found->second, kind);
                    others.erase(found);
                }
            for (const auto &[kind, count] : others)
                add(count, kind);
        }
        if (m_options.layers.events && !kinds.empty())
            Add(events, 13.0, [this](bmr_vec2 left) {
                m_canvas.Circle(bmr_vec2_make(left.x + 6.5 * m_unit, left.y), 5.5 * m_unit, {},
                                {style::kEvent, 1.6 * m_unit, 1.0, {}});
            });
        if (m_options.layers.contacts && points != 0)
            Add(counts ? Counted(points, "contact point", "contact points") : "contact point and normal", 8.0,
                [this](bmr_vec2 left) {
                    const bmr_vec2 at = bmr_vec2_make(left.x + 3.0 * m_unit, left.y - 4.0 * m_unit);
                    m_canvas.Segment(at, bmr_vec2_make(at.x, at.y + 11.0 * m_unit),
                                     {style::kContact, 1.2 * m_unit, 1.0, {}});
                    m_canvas.Dot(at, 2.2 * m_unit, style::kContact);
                });
        if (m_options.layers.boxes)
            AddLine(m_kinetic ? "cell of a body" : "box of the broad phase",
                    {style::kBox, 1.0 * m_unit, 0.9, {1.0 * m_unit, 3.0 * m_unit}});
        if (m_options.layers.trails)
            AddLine("trail", {style::kTrail, 1.3 * m_unit, 0.9, {}});
        if (m_contents.joints != 0)
            AddLine("joint", {style::kJoint, 1.4 * m_unit, 1.0, {}});
    }

    void LayOut(double width) {
        const double left = kAround * m_unit, right = width - kAround * m_unit;
        double x =
            left + m_canvas.TextWidth(m_title, 1.15 * style::kTextSize * m_unit, true) + kAfterEntry * m_unit;
        for (Entry &entry : m_entries) {
            const double needed = entry.sample + kAfterSample * m_unit +
                                  m_canvas.TextWidth(entry.text, style::kTextSize * m_unit);
            if (x + needed > right && x > left) {
                x = left;
                ++m_rows;
            }
            entry.left = x;
            entry.row = m_rows - 1;
            x += needed + kAfterEntry * m_unit;
        }
    }

    Canvas &m_canvas;
    const PictureOptions &m_options;
    Contents m_contents;
    const bool m_kinetic;
    const double m_unit;
    const std::string m_title;
    std::vector<Entry> m_entries;
    int m_rows = 1;
};

/// How long something is in the world: a bar of a round length in the lower left corner of the area. What it
/// takes of the page.
Rectangle DrawScaleBar(Canvas &canvas, const Rectangle &area, double pagePerWorld, double unit,
                       bool kinetic) {
    constexpr double kLongest = 150.0;
    double length = std::pow(10.0, std::floor(std::log10(kLongest * unit / pagePerWorld)));
    for (const double factor : {5.0, 2.0}) {
        if (factor * length * pagePerWorld <= kLongest * unit) {
            length *= factor;
            break;
        }
    }
    const double x = area.left + 16.0 * unit, y = area.bottom + 16.0 * unit, width = length * pagePerWorld,
                 size = style::kTextSize * unit, tick = 4.0 * unit;
    const std::string text = LengthText(length, kinetic);
    const Rectangle box = {x - 6.0 * unit, y - 8.0 * unit,
                           x + std::max(width, canvas.TextWidth(text, size)) + 6.0 * unit, y + 24.0 * unit};
    canvas.Box(box, {style::kStrip, 0.7});
    const Pen pen = {style::kText, 1.6 * unit, 1.0, {}};
    canvas.Segment(bmr_vec2_make(x, y), bmr_vec2_make(x + width, y), pen);
    for (const double end : {x, x + width})
        canvas.Segment(bmr_vec2_make(end, y - tick), bmr_vec2_make(end, y + tick), pen);
    canvas.Text(bmr_vec2_make(x + 0.5 * width, y), 0.0, 8.0 * unit, text, size, Align::Centre, style::kText);
    return box;
}

// --- the page ---

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
    void Block(bmr_vec2 at, double radius) {
        m_taken.push_back({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
    }
    /// Writes a text near a point, with a line to the point where there is no room close by; nothing where
    /// there is no room at all.
    void Place(bmr_vec2 at, const std::string &text) {
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
                const Rectangle box = {centre.x - 0.5 * width, centre.y - 0.5 * height,
                                       centre.x + 0.5 * width, centre.y + 0.5 * height};
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
    /// Writes a text around a point, if it fits there and not elsewhere.
    void PlaceAt(bmr_vec2 at, const std::string &text, double size) {
        const double halfWidth = 0.5 * m_canvas.TextWidth(text, size, true) + 2.0 * m_unit, half = 0.6 * size;
        const Rectangle box = {at.x - halfWidth, at.y - half, at.x + halfWidth, at.y + half};
        if (!IsFree(box))
            return;
        m_canvas.Text(at, 0.0, -0.36 * size, text, size, Align::Centre, style::kText, true);
        m_taken.push_back(box);
    }

private:
    bool IsFree(const Rectangle &box) const {
        return box.left >= m_area.left && box.right <= m_area.right && box.bottom >= m_area.bottom &&
               box.top <= m_area.top &&
               std::none_of(m_taken.begin(), m_taken.end(),
                            [&box](const Rectangle &taken) { return Overlap(box, taken); });
    }

    Canvas &m_canvas;
    const Rectangle m_area;
    const double m_unit;
    std::vector<Rectangle> m_taken;
};

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

    void Draw(const std::string &path) {
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
        Canvas canvas(path, m_width, high + strip);
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
    /// The body in focus, and those that an explained pair is about.
    bool IsNamed(int body) const {
        return m_options.body == body ||
               std::any_of(m_explained.begin(), m_explained.end(), [body](const Explained &one) {
                   return one.pair->a == body || one.pair->b == body;
               });
    }

    void DrawWorld(Canvas &canvas) {
        const Layers &layers = m_options.layers;
        DrawBodies(canvas, m_world, m_unit, [this](int body) { return m_options.body && !IsNamed(body); });
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
        if (layers.disks)
            DrawDisks(canvas, m_world, m_options, m_unit);
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

    /// Is it in focus, or in a pair with the body in focus?
    bool IsMet(int body) const {
        const std::vector<shown::Pair> &pairs = m_world.Frame().pairs;
        return IsNamed(body) ||
               (m_options.body && std::any_of(pairs.begin(), pairs.end(), [&](const shown::Pair &pair) {
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

void AddContents(const shown::Frame &frame, const PictureOptions &options, Contents *contents) {
    const WorldView world(frame);
    for (const shown::Body &body : frame.bodies)
        for (const shown::Fixture *fixture : world.FixturesOf(body.number))
            if (!options.region || !IsEmpty(Intersection(world.BoxOf(*fixture), *options.region)))
                contents->states[StateOf(body, *fixture)] += 1;
    for (const shown::Pair &pair : frame.pairs) {
        if (!IsInFocus(options, pair))
            continue;
        for (const shown::Proof &proof : pair.proofs)
            if (proof.kind != "none")
                contents->proofs[proof.kind] += 1;
        contents->handedOver += frame.program != "world" && pair.handed_over > 0 && pair.contacts > 0 ? 1 : 0;
    }
    for (const shown::Contact &contact : frame.touching)
        contents->points += contact.points.size();
    for (const auto &[kind, count] : EventsInFocus(world, options))
        contents->events[kind] += count;
    contents->joints += frame.joints.size();
}

Colour ColourOfSlack(double slack) {
    // Evenly spaced in the logarithm of the slack.
    constexpr std::array<Colour, 4> kStops = {
        {{1.0, 0.93, 0.25}, {0.42, 0.82, 0.4}, {0.16, 0.64, 0.66}, {0.36, 0.46, 0.85}}};
    const double share = std::clamp(
        std::log(std::max(slack, kLeastSlack) / kLeastSlack) / std::log(kMostSlack / kLeastSlack), 0.0, 1.0);
    const double place = share * static_cast<double>(kStops.size() - 1);
    const auto index = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
    const double part = place - static_cast<double>(index);
    const Colour &from = kStops[index], &to = kStops[index + 1];
    const auto mix = [part](double a, double b) { return a + part * (b - a); };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

std::string LengthText(double length, bool kinetic) {
    char text[40];
    std::snprintf(text, sizeof text, kinetic ? "%.3g" : "%.3g m", length);
    return text;
}

std::optional<Rectangle> PeriodicBoxOf(const shown::Frame &frame) {
    if (!(frame.period.x > 0.0f))
        return std::nullopt;
    const double x = 0.5 * static_cast<double>(frame.period.x), y = 0.5 * static_cast<double>(frame.period.y);
    return Rectangle{-x, -y, x, y};
}

void DrawPicture(const shown::Frame &frame, const PictureOptions &options, const std::string &path) {
    const WorldView world(frame);
    Page(world, options).Draw(path);
}

} // namespace testbed
