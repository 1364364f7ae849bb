// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_H
#define BOOMERANG_TESTBED_PICTURE_H

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "picture/frame.h"

namespace testbed {

/// What is drawn over the bodies.
struct Layers {
    bool certificates = true; ///< what proves pairs apart: lines, edges, vertices, directions, disks
    bool slack = true;        ///< how far apart that proves them, as colour
    bool handedOver = true;   ///< pairs for which a manifold was needed
    bool contacts = true;     ///< points of the manifolds
    bool events = true;       ///< pairs to whose certificate something happened in the step
    bool boxes = false;
    bool disks = false, trails = false; ///< of a kinetic world; where bodies were in the frames before
};

/// What pictures hold of each kind that a legend explains, and how often.
struct Contents {
    std::map<std::string, std::size_t> states, proofs, events; ///< by the frames' words
    std::size_t handedOver = 0, points = 0, joints = 0;
};

struct PictureOptions {
    Layers layers;
    /// The part of the world to show; without it, where the scene happens.
    std::optional<Rectangle> region;
    /// A body in focus, whose pairs are explained one by one.
    std::optional<int> body;
    int width = 1200;
    /// Of the trails: where each body was, by its number, the latest last.
    std::map<int, std::deque<bmr_vec2>> trails;
    /// One of a series: what all of its pictures hold together, so that they have one legend and one size.
    std::optional<Contents> series;
};

/// The box of a world that has a periodic one.
std::optional<Rectangle> PeriodicBoxOf(const shown::Frame &frame);

/// The part of the world that a picture with these options shows of a frame: around the bodies without those
/// that flew far away from the others, or around the body in focus.
Rectangle RegionOf(const shown::Frame &frame, const PictureOptions &options);

/// Adds what the picture of a frame holds.
void AddContents(const shown::Frame &frame, const PictureOptions &options, Contents *contents);

/// Draws a frame in the colours of Box2D's testbed, with a scale bar, and a title and a legend below, as an
/// SVG, PNG or PDF file by the ending of the path (drawing/canvas.h). Throws std::runtime_error if the file
/// cannot be written, or if a body in focus is not there.
void DrawPicture(const shown::Frame &frame, const PictureOptions &options, const std::string &path);

} // namespace testbed

#endif
