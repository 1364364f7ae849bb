// SPDX-License-Identifier: MIT
#include "drawing/surface.h"

#include <cmath>
#include <stdexcept>

#include <cairo-pdf.h>
#include <cairo-svg.h>

namespace testbed {
namespace {

cairo_surface_t *MakeSurface(const std::string &path, const std::string &writePath, double width,
                             double height) {
    if (EndsWith(path, ".png"))
        return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(std::lround(width)),
                                          static_cast<int>(std::lround(height)));
    if (EndsWith(path, ".svg"))
        return cairo_svg_surface_create(writePath.c_str(), width, height);
    return cairo_pdf_surface_create(writePath.c_str(), width, height);
}

} // namespace

bool EndsWith(const std::string &path, const std::string &ending) {
    return path.size() > ending.size() &&
           path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

bool IsPicturePath(const std::string &path) {
    return EndsWith(path, ".svg") || EndsWith(path, ".png") || EndsWith(path, ".pdf");
}

Surface::Surface(std::string path, double width, double height)
    : m_path(std::move(path)), m_file(m_path),
      m_surface(MakeSurface(m_path, m_file.WritePath().string(), width, height), cairo_surface_destroy),
      m_context(cairo_create(m_surface.get()), cairo_destroy) {}

void Surface::Write() {
    cairo_status_t status = cairo_status(m_context.get());
    if (status == CAIRO_STATUS_SUCCESS && EndsWith(m_path, ".png"))
        status = cairo_surface_write_to_png(m_surface.get(), m_file.WritePath().c_str());
    cairo_surface_finish(m_surface.get());
    if (status == CAIRO_STATUS_SUCCESS)
        status = cairo_surface_status(m_surface.get());
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("cannot draw " + m_path + ": " + cairo_status_to_string(status));
    m_file.Finish();
}

} // namespace testbed
