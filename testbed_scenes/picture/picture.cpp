// SPDX-License-Identifier: MIT
#include "picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

#include "picture/parts.h"
#include "picture/world_view.h"

namespace testbed {
namespace {

/// In points of a picture 1200 wide: the list that explains pairs.
constexpr double kListWidth = 330.0, kListAround = 14.0, kListEntry = 44.0, kListTitle = 40.0;
constexpr int kMostExplained = 9;
/// So many of the bodies that it touches are named, in words and in the picture.
constexpr std::size_t kMostNamed = 5;
/// Smaller pictures keep their letters legible.
constexpr double kLeastUnit = 0.7;

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

Colour ColourOf(const PictureOptions &options, const Explained &one) {
    if (one.proof == nullptr)
        return style::kHandedOver;
    return options.layers.slack ? ColourOfSlack(static_cast<double>(one.proof->slack)) : style::kCertificate;
}

std::string SlackText(const Explained &one, bool kinetic) {
    return one.proof != nullptr ? LengthText(static_cast<double>(one.proof->slack), kinetic) : "";
}

class Page {
public:
    Page(const WorldView &world, const PictureOptions &options)
        : m_world(world), m_options(options), m_title(TitleOf(world.Frame())), m_width(options.width),
          m_unit(std::max(options.width / 1200.0, kLeastUnit)) {}

    /// On the canvas that `make` makes of a width and a height.
    template <class Make> void Draw(Make make) {
        const Rectangle region = RegionOf(m_world.Frame(), m_options);
        const double list = m_options.bodies.empty() ? 0.0 : std::round(kListWidth * m_unit);
        const double wide = m_width - list, high = std::round(wide * region.Height() / region.Width());
        double strip = 0.0;
        {
            // How high the legend is, and with it the page, a canvas must tell that knows the font. (A PNG
            // that is not written is no file.)
            Canvas measure("legend.png", 1.0, 1.0);
            strip = Legend(measure, m_world, m_options, m_title, m_width, m_unit).Height();
        }
        Explanation explanation = Explain(m_world, m_options, region, kMostExplained);
        m_explained = std::move(explanation.pairs);
        m_touching = std::move(explanation.touching);
        m_alone = std::move(explanation.alone);
        m_rest = explanation.rest;
        Canvas canvas = make(m_width, high + strip);
        Paint(canvas, {0.0, 0.0, m_width, high + strip}, style::kStrip);
        const Rectangle area = {0.0, strip, wide, strip + high};
        Paint(canvas, area, style::kBackground);
        canvas.SetPanel(area, region);
        const double pagePerWorld = canvas.Scale();
        DrawWorld(canvas);
        const std::vector<Name> names = PlacesOfNames(canvas, area);
        canvas.ClearPanel();
        const Rectangle bar = DrawScaleBar(canvas, area, pagePerWorld, m_unit, IsKinetic(m_world.Frame()));
        DrawLabels(canvas, area, bar, names);
        if (list > 0.0)
            DrawList(canvas, {wide, strip, m_width, strip + high});
        Legend(canvas, m_world, m_options, m_title, m_width, m_unit).Draw(bmr_vec2_make(0.0, strip));
        canvas.Write();
    }

private:
    static void Paint(Canvas &canvas, const Rectangle &area, const Colour &colour) {
        canvas.Polygon({bmr_vec2_make(area.left, area.bottom), bmr_vec2_make(area.right, area.bottom),
                        bmr_vec2_make(area.right, area.top), bmr_vec2_make(area.left, area.top)},
                       {colour, 1.0}, {colour, 0.0, 1.0, {}});
    }

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
        for (Explained &one : m_explained)
            if (layers.certificates || one.proof == nullptr)
                DrawExplained(canvas, m_world, m_options, m_unit, &one);
        if (layers.contacts)
            DrawContacts(canvas, m_world, m_unit);
        if (layers.handedOver)
            DrawHandedOver(canvas, m_world, m_options, m_unit);
        if (layers.events)
            DrawEvents(canvas, m_world, m_options, m_unit);
    }

    /// A body's number on the page. Of a body outside of the picture it stands where the way to it leaves the
    /// picture.
    struct Name {
        int body;
        bmr_vec2 at;
        bool isOutside;
    };

    /// All bodies that the list beside the picture names.
    std::vector<Name> PlacesOfNames(const Canvas &canvas, const Rectangle &area) const {
        constexpr double kToBorder = 14.0;
        std::vector<Name> names;
        if (m_options.bodies.empty())
            return names;
        std::set<int> touching;
        for (const auto *pairs : {&m_touching, &m_alone})
            for (std::size_t i = 0; i < std::min(kMostNamed, pairs->size()); ++i)
                touching.insert(OtherOf(*(*pairs)[i]));
        for (const shown::Body &body : m_world.Frame().bodies) {
            if (!IsNamed(body.number) && touching.count(body.number) == 0)
                continue;
            if (const auto middle = MiddleOfVisible(canvas, m_world, area, m_unit, body.number)) {
                names.push_back({body.number, *middle, false});
                continue;
            }
            for (const Explained &one : m_explained) {
                const std::size_t side = one.pair->a == body.number ? 0 : 1;
                if (OtherOf(*one.pair) == body.number)
                    names.push_back(
                        {body.number,
                         WhereItLeaves(area, kToBorder * m_unit, one.ends[1 - side], one.ends[side]), true});
            }
        }
        return names;
    }

    void DrawLabels(Canvas &canvas, const Rectangle &area, const Rectangle &bar,
                    const std::vector<Name> &names) const {
        Labels labels(canvas, area, m_unit);
        labels.Block(bmr_vec2_make(0.5 * (bar.left + bar.right), 0.5 * (bar.bottom + bar.top)),
                     0.5 * std::max(bar.Width(), bar.Height()));
        for (const Explained &one : m_explained)
            labels.Block(one.place, 5.0 * m_unit);
        for (const Name &name : names) {
            if (name.isOutside)
                labels.Place(name.at, 0, "to " + std::to_string(name.body), style::kFaintText);
            else
                labels.PlaceAt(name.at, std::to_string(name.body), 15.0 * m_unit, style::kText);
        }
        if (!m_options.layers.certificates)
            return;
        for (const Explained &one : m_explained)
            labels.Place(one.place, one.number, SlackText(one, IsKinetic(m_world.Frame())),
                         ColourOf(m_options, one));
    }

    void DrawList(Canvas &canvas, const Rectangle &area) const {
        const double left = area.left + kListAround * m_unit, right = area.right - kListAround * m_unit;
        double y = area.top - 26.0 * m_unit;
        const auto write = [&](double x, double baseline, const std::string &text, double size, bool bold,
                               const Colour &colour, Align align) {
            canvas.Text(bmr_vec2_make(x, baseline), 0.0, 0.0, text, size * m_unit, align, colour, bold);
        };
        const std::vector<int> &bodies = m_options.bodies;
        write(left, y,
              bodies.size() == 1
                  ? "Why body " + std::to_string(bodies[0]) + " is known to be apart"
                  : "Bodies " + std::to_string(bodies[0]) + " and " + std::to_string(bodies[1]),
              14.5, true, style::kText, Align::Left);
        y -= 0.75 * kListTitle * m_unit;
        if (m_explained.empty() && m_touching.empty() && m_alone.empty() && m_rest == 0)
            write(left, y, "No boxes overlap: nobody asked.", style::kSmallText, false, style::kFaintText,
                  Align::Left);
        int hidden = m_rest;
        for (const Explained &one : m_explained) {
            if (y - kListEntry * m_unit < area.bottom) {
                ++hidden;
                continue;
            }
            const double disc = 9.0 * m_unit, text = left + 26.0 * m_unit;
            DrawNumber(canvas, bmr_vec2_make(left + disc, y + 4.5 * m_unit), disc, one.number,
                       ColourOf(m_options, one));
            write(text, y, NameOfPair(one), style::kTextSize, true, style::kText, Align::Left);
            write(right, y, SlackText(one, IsKinetic(m_world.Frame())), style::kTextSize, true, style::kText,
                  Align::Right);
            write(text, y - 17.0 * m_unit, ReasonOf(one), style::kSmallText - 0.5, false, style::kFaintText,
                  Align::Left);
            y -= kListEntry * m_unit;
        }
        std::vector<std::string> lines;
        if (hidden > 0)
            lines.push_back("and " + std::to_string(hidden) + " more, farther away");
        if (!m_touching.empty())
            lines.push_back("It touches " + NamesOf(m_touching) + ".");
        if (!m_alone.empty())
            lines.push_back("Not two polygons, Box2D's alone: " + NamesOf(m_alone) + ".");
        y = std::max(y, area.bottom + (10.0 + 20.0 * static_cast<double>(lines.size() - 1)) * m_unit);
        for (const std::string &line : lines) {
            write(left, y, line, style::kSmallText, false, style::kFaintText, Align::Left);
            y -= 20.0 * m_unit;
        }
    }

    int OtherOf(const shown::Pair &pair) const { return pair.a == m_options.bodies[0] ? pair.b : pair.a; }

    /// The other bodies of pairs: "39, 47, 58 and 10 more".
    std::string NamesOf(const std::vector<const shown::Pair *> &pairs) const {
        std::string text;
        for (std::size_t i = 0; i < std::min(kMostNamed, pairs.size()); ++i) {
            const shown::Pair &pair = *pairs[i];
            text += (i == 0 ? "" : ", ") + std::to_string(OtherOf(pair));
        }
        const std::size_t more = pairs.size() - std::min(kMostNamed, pairs.size());
        return text + (more > 0 ? " and " + std::to_string(more) + " more" : "");
    }

    std::string NameOfPair(const Explained &one) const {
        const int other = OtherOf(*one.pair);
        const std::size_t proofs = one.pair->proofs.size();
        std::string name = "body " + std::to_string(other);
        if (proofs > 1 && one.proof != nullptr)
            name += ", least of " + std::to_string(proofs) + " proofs";
        return name;
    }

    const WorldView &m_world;
    const PictureOptions &m_options;
    const std::string m_title;
    const double m_width, m_unit;
    std::vector<Explained> m_explained;
    std::vector<const shown::Pair *> m_touching;
    std::vector<const shown::Pair *> m_alone;
    int m_rest = 0;
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
