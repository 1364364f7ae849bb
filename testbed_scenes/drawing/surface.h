// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_SURFACE_H
#define BOOMERANG_TESTBED_SURFACE_H

#include <memory>
#include <string>

#include <cairo.h>

#include "drawing/whole_file.h"

namespace testbed {

bool EndsWith(const std::string &path, const std::string &ending);
/// Whether there is a kind of picture for the ending of this path: .svg, .png or .pdf.
bool IsPicturePath(const std::string &path);

/// A picture file being drawn: cairo's surface of the kind that the path's ending names, and a context on it.
/// Sizes are pixels in a PNG and points elsewhere. An older file stays until Write.
class Surface {
public:
    Surface(std::string path, double width, double height);

    cairo_t *Cairo() const { return m_context.get(); }
    /// Writes the file; throws std::runtime_error if it, or anything drawn, failed.
    void Write();

private:
    using SurfacePointer = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
    using ContextPointer = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

    std::string m_path;
    WholeFile m_file;
    SurfacePointer m_surface;
    ContextPointer m_context;
};

} // namespace testbed

#endif
