// SPDX-License-Identifier: MIT
#include "picture/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

namespace testbed {
namespace {

/// In points of a picture 1200 wide.
constexpr double kRow = 24.0, kAround = 14.0, kAfterSample = 7.0, kAfterEntry = 20.0, kSample = 24.0;
constexpr double kScale = 170.0;

std::string Counted(std::size_t count, const char *one, const char *many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

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

Legend::Legend(Canvas &canvas, const WorldView &world, const PictureOptions &options, std::string title,
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

void Legend::Add(const std::string &text, double sample, std::function<void(bmr_vec2)> draw) {
    Entry entry;
    entry.text = text;
    entry.sample = sample * m_unit;
    entry.draw = std::move(draw);
    m_entries.push_back(std::move(entry));
}

void Legend::AddLine(const std::string &text, const Pen &pen) {
    Add(text, kSample, [this, pen](bmr_vec2 left) {
        m_canvas.Segment(left, bmr_vec2_make(left.x + kSample * m_unit, left.y), pen);
    });
}

void Legend::AddBodies() {
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
                         {colour, isSensor ? 0.0 : style::kFillOpacity}, {colour, 1.2 * m_unit, 1.0, dash});
        });
    }
}

void Legend::AddScale() {
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

void Legend::AddProofs() {
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
                    m_canvas.Segment(bmr_vec2_make(vertex.x, low), vertex, {colour, 1.2 * m_unit, 1.0, {}});
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
    if (m_options.layers.hulls)
        AddLine(m_kinetic ? "disk of a body" : "hull",
                {style::kHull, 1.2 * m_unit, 0.9, {6.0 * m_unit, 3.0 * m_unit}});
    if (m_options.layers.envelopes)
        AddLine("envelope at the proof's level",
                {style::kEnvelope, 1.6 * m_unit, 1.0, {1.5 * m_unit, 3.5 * m_unit}});
}

void Legend::AddOthers() {
    const std::size_t handedOver = m_contents.handedOver, points = m_contents.points;
    const bool counts = !m_options.series;
    if (m_options.layers.handedOver && handedOver != 0)
        Add(counts ? "needed a manifold: " + Counted(handedOver, "pair", "pairs") : "needed a manifold", 11.0,
            [this](bmr_vec2 left) {
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

void Legend::LayOut(double width) {
    const double left = kAround * m_unit, right = width - kAround * m_unit;
    double x =
        left + m_canvas.TextWidth(m_title, 1.15 * style::kTextSize * m_unit, true) + kAfterEntry * m_unit;
    for (Entry &entry : m_entries) {
        const double needed =
            entry.sample + kAfterSample * m_unit + m_canvas.TextWidth(entry.text, style::kTextSize * m_unit);
        if (x + needed > right && x > left) {
            x = left;
            ++m_rows;
        }
        entry.left = x;
        entry.row = m_rows - 1;
        x += needed + kAfterEntry * m_unit;
    }
}

double Legend::Height() const {
    return std::ceil((m_rows * kRow + kAround) * m_unit);
}

void Legend::Draw(bmr_vec2 top) const {
    const auto middle = [&](int row) { return top.y - (0.5 * kAround + (row + 0.5) * kRow) * m_unit; };
    const double title = 1.15 * style::kTextSize * m_unit, size = style::kTextSize * m_unit;
    m_canvas.Text(bmr_vec2_make(top.x + kAround * m_unit, middle(0)), 0.0, -0.36 * title, m_title, title,
                  Align::Left, style::kText, true);
    for (const Entry &entry : m_entries) {
        const bmr_vec2 at = bmr_vec2_make(top.x + entry.left, middle(entry.row));
        entry.draw(at);
        m_canvas.Text(at, entry.sample + kAfterSample * m_unit, -0.36 * size, entry.text, size, Align::Left,
                      style::kText);
    }
}

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

} // namespace testbed
