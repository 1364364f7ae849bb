// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURES_H
#define BOOMERANG_TESTBED_PICTURES_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "picture/picture.h"

namespace testbed {

/// Which steps a command draws, and how: `render` of a scene, `world` of a kinetic world.
struct PictureRequest {
    std::string output;
    std::optional<int64_t> step;
    std::string frames; ///< FIRST:LAST[:EVERY] instead of a step
    std::string focus;
    int width = 1200;
    /// What to draw: none named means what Layers has by itself.
    Layers named = {false, false, false, false, false, false, false, false};
    bool all = false, bare = false;
};

/// Where frames come from. Of a scene only those of the pictures come; of a kinetic world all do, so that
/// trails can be drawn.
enum class PictureSource { Scene, World };

/// The options of a request but for the output. Those of them that make no sense without it need `output`,
/// where that is not required (else nullptr).
void AddPictureOptions(CLI::App &app, PictureRequest &request, CLI::Option *output);
/// What the names of the layers mean.
extern const char kLayersHelp[];

/// The pictures of those frames that are wanted. They are drawn once all have come, for one legend explains
/// what any of them holds.
class PictureSeries {
public:
    /// Throws UsageError, or std::runtime_error where the file cannot be written.
    PictureSeries(const PictureRequest &request, PictureSource source);

    int64_t First() const { return m_first; }
    int64_t Last() const { return m_last; }
    int64_t Every() const { return m_every; }
    /// Throws UsageError where `name` ends before the last picture.
    void CheckLast(const std::string &name, int64_t last) const;
    /// Frames come in order; those that are not wanted leave trails alone. Throws UsageError where a body in
    /// focus is not there.
    void Add(const shown::Frame &frame);
    /// Writes the files.
    void Draw();
    /// What was written, in a line.
    std::string Said() const;

private:
    struct Picture {
        shown::Frame frame;
        PictureOptions options;
    };

    void ReadFocus();
    void ReadRange();
    bool IsNumbered() const { return !m_request.frames.empty(); }
    void AddTrails(const shown::Frame &frame);
    std::string PathOf(size_t index) const;

    const PictureRequest &m_request;
    PictureOptions m_options;
    int64_t m_first = 0, m_last = 0, m_every = 1;
    std::optional<Rectangle> m_shape; ///< of the series
    std::vector<Picture> m_pictures;
    Contents m_contents; ///< of all pictures
};

} // namespace testbed

#endif
