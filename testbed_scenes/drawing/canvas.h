// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_CANVAS_H
#define BOOMERANG_TESTBED_CANVAS_H

#include <memory>
#include <string>
#include <vector>

#include <cairo.h>

#include "boomerang/vector.h"

namespace testbed {

/// Throws std::runtime_error, which says why, if a file cannot be written there, as far as that can be known
/// before the work.
void CheckWritable(const std::string &path);

/// Writes a file that is there whole or as it was before: beside its place first, as path.part, which then
/// takes its place. A device or a pipe is written directly, and of a link what it leads to. Throws
/// std::runtime_error.
void WriteWholeFile(const std::string &path, const std::string &content);

/// Whether there is a kind of picture for the ending of this path: .svg, .png or .pdf.
bool IsPicturePath(const std::string &path);

struct Colour {
    double red, green, blue;
};

/// Okabe and Ito's eight, which people tell apart whatever their sight, on white.
namespace ink {
constexpr Colour kBlack = {0.13, 0.13, 0.15};
constexpr Colour kGrey = {0.55, 0.56, 0.58};
constexpr Colour kFaint = {0.86, 0.87, 0.88};
constexpr Colour kBlue = {0.0, 0.447, 0.698};
constexpr Colour kOrange = {0.902, 0.624, 0.0};
constexpr Colour kGreen = {0.0, 0.62, 0.451};
constexpr Colour kRed = {0.835, 0.369, 0.0};
constexpr Colour kPurple = {0.8, 0.475, 0.655};
constexpr Colour kSky = {0.337, 0.706, 0.914};
/// The i-th of six that follow one another well: levels, series.
Colour Series(size_t index);
} // namespace ink

/// How a boundary and its inside are drawn. Widths are in units of the page.
struct Pen {
    Colour colour = ink::kBlack;
    double width = 1.0;
    double opacity = 1.0;
    std::vector<double> dash = {};
};
struct Fill {
    Colour colour = ink::kGrey;
    double opacity = 0.0; ///< 0: not filled
};

struct Rectangle {
    double left, bottom, right, top;
    double Width() const { return right - left; }
    double Height() const { return top - bottom; }
};

/// A rectangle that holds nothing, and how it grows.
Rectangle NoRectangle();
bool IsEmpty(const Rectangle &box);
void Grow(Rectangle *box, bmr_vec2 point, double radius = 0.0);
void Grow(Rectangle *box, const Rectangle &other);
Rectangle Intersection(const Rectangle &a, const Rectangle &b);
/// Wider by a share of its larger side, on each side.
Rectangle Widened(const Rectangle &box, double share);

/// What is left of a convex polygon on the inner side of a line: <normal, x> >= offset.
std::vector<bmr_vec2> Clipped(const std::vector<bmr_vec2> &polygon, bmr_vec2 normal, double offset);

enum class Align { Left, Centre, Right };

/// A page with y upwards, its origin in the lower left corner, on which panels map world coordinates. Fonts
/// are the system's sans serif. The path's ending names the kind of picture; sizes are pixels in a PNG and
/// points elsewhere.
class Canvas {
public:
    Canvas(std::string path, double width, double height);
    Canvas(const Canvas &) = delete;
    Canvas &operator=(const Canvas &) = delete;

    /// From now on world coordinates are those of `world`, shown in `page` (of the page's units) as large as
    /// fits, centred, undistorted; drawing is clipped to `page`.
    void SetPanel(const Rectangle &page, const Rectangle &world);
    /// World coordinates are the page's.
    void ClearPanel();
    bmr_vec2 OnPage(bmr_vec2 world) const;
    /// Units of the page per unit of the world, along x.
    double Scale() const { return m_scaleX; }

    void Polygon(const std::vector<bmr_vec2> &points, const Fill &fill, const Pen &pen);
    void Box(const Rectangle &box, const Fill &fill, const Pen &pen = {ink::kBlack, 0.0, 1.0, {}});
    void Polyline(const std::vector<bmr_vec2> &points, const Pen &pen);
    void Segment(bmr_vec2 from, bmr_vec2 to, const Pen &pen);
    /// The part of the line <normal, x> = offset that the panel shows.
    void Line(bmr_vec2 normal, double offset, const Pen &pen);
    /// A segment with a head at its end.
    void Arrow(bmr_vec2 from, bmr_vec2 to, const Pen &pen);
    /// `radius` in the world.
    void Circle(bmr_vec2 center, double radius, const Fill &fill, const Pen &pen);
    /// `radius` on the page.
    void Dot(bmr_vec2 center, double radius, const Colour &colour);

    /// Text whose anchor stands at `at`, moved by (dx, dy) on the page.
    void Text(bmr_vec2 at, double dx, double dy, const std::string &text, double size,
              Align align = Align::Left, const Colour &colour = ink::kBlack, bool bold = false);
    /// Text that reads upwards, centred.
    void TextUpwards(bmr_vec2 at, double dx, double dy, const std::string &text, double size);
    double TextWidth(const std::string &text, double size, bool bold = false);

    double Width() const { return m_width; }
    double Height() const { return m_height; }
    /// Writes the file; throws std::runtime_error if it, or anything drawn, failed.
    void Write();

private:
    /// As SetPanel, but stretched to fill `page`.
    void SetStretchedPanel(const Rectangle &page, const Rectangle &world);
    void Prepare();
    void Trace(const std::vector<bmr_vec2> &points, bool close);
    void Stroke(const Pen &pen);
    void FillPath(const Fill &fill);
    void SelectFont(double size, bool bold);

    using SurfacePointer = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
    using ContextPointer = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

    const std::string m_path;
    std::string m_bytes; ///< of the file
    double m_width, m_height;
    SurfacePointer m_surface;
    ContextPointer m_context;
    cairo_t *m_cairo;
    Rectangle m_world, m_page;
    double m_scaleX = 1.0, m_scaleY = 1.0, m_shiftX = 0.0, m_shiftY = 0.0;
};

} // namespace testbed

#endif
