// SPDX-License-Identifier: MIT
#include "drawing/canvas.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>

namespace testbed {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailToWrite(const std::string &path, const std::string &reason) {
    throw std::runtime_error("cannot write " + path + ": " + reason);
}

/// What cairo writes, appended to the bytes of the file.
cairo_status_t Append(void *bytes, const unsigned char *data, unsigned length) {
    static_cast<std::string *>(bytes)->append(reinterpret_cast<const char *>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t *MakeSurface(const std::string &path, std::string *bytes, double width, double height) {
    if (fs::path(path).extension() == ".png")
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width)),
                                          static_cast<int>(std::lround(height)));
    if (fs::path(path).extension() == ".svg")
        return cairo_svg_surface_create_for_stream(Append, bytes, width, height);
    return cairo_pdf_surface_create_for_stream(Append, bytes, width, height);
}

} // namespace

void CheckWritable(const std::string &path) {
    std::error_code error;
    const fs::path directory = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : ".";
    if (!fs::exists(directory, error))
        FailToWrite(path, "there is no directory " + directory.string());
    if (!fs::is_directory(directory, error))
        FailToWrite(path, std::strerror(ENOTDIR));
    if (fs::is_directory(path, error))
        FailToWrite(path, std::strerror(EISDIR));
}

void WriteWholeFile(const std::string &path, const std::string &content) {
    std::error_code error;
    const fs::path target = fs::weakly_canonical(path, error);
    const bool replaces = !fs::exists(target, error) || fs::is_regular_file(target, error);
    const fs::path written = replaces ? fs::path(target) += ".part" : target;
    errno = 0;
    std::ofstream stream(written, std::ios::binary);
    stream << content << std::flush;
    const int failure = errno;
    if (!stream) {
        if (replaces)
            fs::remove(written, error);
        FailToWrite(path, std::strerror(failure));
    }
    if (!replaces)
        return;
    fs::rename(written, target, error);
    if (error)
        FailToWrite(path, error.message());
}

bool IsPicturePath(const std::string &path) {
    const fs::path ending = fs::path(path).extension();
    return ending == ".svg" || ending == ".png" || ending == ".pdf";
}

Rectangle NoRectangle() {
    constexpr double kFar = std::numeric_limits<double>::max();
    return {kFar, kFar, -kFar, -kFar};
}

bool IsEmpty(const Rectangle &box) {
    return box.left > box.right || box.bottom > box.top;
}

void Grow(Rectangle *box, bmr_vec2 point, double radius) {
    Grow(box, {point.x - radius, point.y - radius, point.x + radius, point.y + radius});
}

void Grow(Rectangle *box, const Rectangle &other) {
    *box = {std::min(box->left, other.left), std::min(box->bottom, other.bottom),
            std::max(box->right, other.right), std::max(box->top, other.top)};
}

Rectangle Intersection(const Rectangle &a, const Rectangle &b) {
    return {std::max(a.left, b.left), std::max(a.bottom, b.bottom), std::min(a.right, b.right),
            std::min(a.top, b.top)};
}

Rectangle Widened(const Rectangle &box, double share) {
    const double by = share * std::max(box.Width(), box.Height());
    return {box.left - by, box.bottom - by, box.right + by, box.top + by};
}

std::vector<bmr_vec2> Clipped(const std::vector<bmr_vec2> &polygon, bmr_vec2 normal, double offset) {
    std::vector<bmr_vec2> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const bmr_vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double fa = bmr_dot(normal, a) - offset, fb = bmr_dot(normal, b) - offset;
        if (fa >= 0.0)
            kept.push_back(a);
        if ((fa >= 0.0) != (fb >= 0.0))
            kept.push_back(bmr_add(a, bmr_scale(fa / (fa - fb), bmr_sub(b, a))));
    }
    return kept;
}

namespace ink {
Colour Series(size_t index) {
    constexpr std::array<Colour, 6> kSeries = {kBlue, kRed, kGreen, kPurple, kOrange, kSky};
    return kSeries[index % kSeries.size()];
}
} // namespace ink

Canvas::Canvas(std::string path, double width, double height)
    : m_path(std::move(path)), m_width(width), m_height(height),
      m_surface(MakeSurface(m_path, &m_bytes, width, height), cairo_surface_destroy),
      m_context(cairo_create(m_surface.get()), cairo_destroy),
      m_cairo(m_context.get()), m_world{0.0, 0.0, width, height}, m_page(m_world) {
    Prepare();
}

void Canvas::Write() {
    cairo_status_t status = cairo_status(m_cairo);
    if (status == CAIRO_STATUS_SUCCESS && fs::path(m_path).extension() == ".png")
        status = cairo_surface_write_to_png_stream(m_surface.get(), Append, &m_bytes);
    cairo_surface_finish(m_surface.get());
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(m_surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("cannot draw " + m_path + ": " + cairo_status_to_string(status));
    WriteWholeFile(m_path, m_bytes);
}

void Canvas::Prepare() {
    cairo_set_source_rgb(m_cairo, 1.0, 1.0, 1.0);
    cairo_paint(m_cairo);
    cairo_set_line_join(m_cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(m_cairo, CAIRO_LINE_CAP_ROUND);
}

void Canvas::SetStretchedPanel(const Rectangle &page, const Rectangle &world) {
    m_page = page;
    m_world = world;
    m_scaleX = page.Width() / world.Width();
    m_scaleY = page.Height() / world.Height();
    m_shiftX = page.left - m_scaleX * world.left;
    m_shiftY = page.bottom - m_scaleY * world.bottom;
    cairo_reset_clip(m_cairo);
    cairo_rectangle(m_cairo, page.left, m_height - page.top, page.Width(), page.Height());
    cairo_clip(m_cairo);
}

void Canvas::SetPanel(const Rectangle &page, const Rectangle &world) {
    const double scale = std::min(page.Width() / world.Width(), page.Height() / world.Height());
    const double centreX = 0.5 * (world.left + world.right), centreY = 0.5 * (world.bottom + world.top);
    const double halfX = 0.5 * page.Width() / scale, halfY = 0.5 * page.Height() / scale;
    SetStretchedPanel(page, {centreX - halfX, centreY - halfY, centreX + halfX, centreY + halfY});
}

void Canvas::ClearPanel() {
    const Rectangle all = {0.0, 0.0, m_width, m_height};
    SetStretchedPanel(all, all);
}

bmr_vec2 Canvas::OnPage(bmr_vec2 world) const {
    return bmr_vec2_make(m_shiftX + m_scaleX * world.x, m_shiftY + m_scaleY * world.y);
}

void Canvas::Trace(const std::vector<bmr_vec2> &points, bool close) {
    cairo_new_path(m_cairo);
    for (const bmr_vec2 &point : points) {
        const bmr_vec2 at = OnPage(point);
        cairo_line_to(m_cairo, at.x, m_height - at.y);
    }
    if (close)
        cairo_close_path(m_cairo);
}

void Canvas::FillPath(const Fill &fill) {
    if (fill.opacity <= 0.0)
        return;
    cairo_set_source_rgba(m_cairo, fill.colour.red, fill.colour.green, fill.colour.blue, fill.opacity);
    cairo_fill_preserve(m_cairo);
}

void Canvas::Stroke(const Pen &pen) {
    if (pen.width > 0.0) {
        cairo_set_source_rgba(m_cairo, pen.colour.red, pen.colour.green, pen.colour.blue, pen.opacity);
        cairo_set_line_width(m_cairo, pen.width);
        cairo_set_dash(m_cairo, pen.dash.data(), static_cast<int>(pen.dash.size()), 0.0);
        cairo_stroke_preserve(m_cairo);
    }
    cairo_new_path(m_cairo);
}

void Canvas::Polygon(const std::vector<bmr_vec2> &points, const Fill &fill, const Pen &pen) {
    Trace(points, true);
    FillPath(fill);
    Stroke(pen);
}

void Canvas::Box(const Rectangle &box, const Fill &fill, const Pen &pen) {
    Polygon({bmr_vec2_make(box.left, box.bottom), bmr_vec2_make(box.right, box.bottom),
             bmr_vec2_make(box.right, box.top), bmr_vec2_make(box.left, box.top)},
            fill, pen);
}

void Canvas::Polyline(const std::vector<bmr_vec2> &points, const Pen &pen) {
    Trace(points, false);
    Stroke(pen);
}

void Canvas::Segment(bmr_vec2 from, bmr_vec2 to, const Pen &pen) {
    Polyline({from, to}, pen);
}

void Canvas::Line(bmr_vec2 normal, double offset, const Pen &pen) {
    // The clip of the panel cuts what is too long.
    const double reach = m_world.Width() + m_world.Height();
    const bmr_vec2 centre =
        bmr_vec2_make(0.5 * (m_world.left + m_world.right), 0.5 * (m_world.bottom + m_world.top));
    const bmr_vec2 on = bmr_add(centre, bmr_scale(offset - bmr_dot(normal, centre), normal));
    const bmr_vec2 along = bmr_scale(reach, bmr_left(normal));
    Segment(bmr_sub(on, along), bmr_add(on, along), pen);
}

void Canvas::Arrow(bmr_vec2 from, bmr_vec2 to, const Pen &pen) {
    constexpr double kHead = 6.0, kHalfAngle = 0.42;
    Segment(from, to, pen);
    const bmr_vec2 a = OnPage(from), b = OnPage(to);
    const double angle = std::atan2(b.y - a.y, b.x - a.x), size = kHead + pen.width;
    cairo_new_path(m_cairo);
    cairo_move_to(m_cairo, b.x, m_height - b.y);
    for (const double side : {-kHalfAngle, kHalfAngle})
        cairo_line_to(m_cairo, b.x - size * std::cos(angle + side),
                      m_height - (b.y - size * std::sin(angle + side)));
    cairo_close_path(m_cairo);
    cairo_set_source_rgba(m_cairo, pen.colour.red, pen.colour.green, pen.colour.blue, pen.opacity);
    cairo_fill(m_cairo);
}

void Canvas::Circle(bmr_vec2 center, double radius, const Fill &fill, const Pen &pen) {
    const bmr_vec2 at = OnPage(center);
    cairo_new_path(m_cairo);
    cairo_arc(m_cairo, at.x, m_height - at.y, radius * m_scaleX, 0.0, 2.0 * M_PI);
    FillPath(fill);
    Stroke(pen);
}

void Canvas::Dot(bmr_vec2 center, double radius, const Colour &colour) {
    Circle(center, radius / m_scaleX, {colour, 1.0}, {colour, 0.0});
}

void Canvas::SelectFont(double size, bool bold) {
    cairo_select_font_face(m_cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(m_cairo, size);
}

double Canvas::TextWidth(const std::string &text, double size, bool bold) {
    SelectFont(size, bold);
    cairo_text_extents_t extents;
    cairo_text_extents(m_cairo, text.c_str(), &extents);
    return extents.x_advance;
}

void Canvas::Text(bmr_vec2 at, double dx, double dy, const std::string &text, double size, Align align,
                  const Colour &colour, bool bold) {
    const double width = TextWidth(text, size, bold);
    const bmr_vec2 anchor = OnPage(at);
    const double left = align == Align::Left ? 0.0 : align == Align::Centre ? 0.5 * width : width;
    cairo_set_source_rgb(m_cairo, colour.red, colour.green, colour.blue);
    cairo_move_to(m_cairo, anchor.x + dx - left, m_height - (anchor.y + dy));
    cairo_show_text(m_cairo, text.c_str());
    cairo_new_path(m_cairo);
}

void Canvas::TextUpwards(bmr_vec2 at, double dx, double dy, const std::string &text, double size) {
    const double width = TextWidth(text, size);
    const bmr_vec2 anchor = OnPage(at);
    cairo_save(m_cairo);
    cairo_set_source_rgb(m_cairo, ink::kBlack.red, ink::kBlack.green, ink::kBlack.blue);
    cairo_move_to(m_cairo, anchor.x + dx, m_height - (anchor.y + dy) + 0.5 * width);
    cairo_rotate(m_cairo, -0.5 * M_PI);
    cairo_show_text(m_cairo, text.c_str());
    cairo_restore(m_cairo);
    cairo_new_path(m_cairo);
}

} // namespace testbed
