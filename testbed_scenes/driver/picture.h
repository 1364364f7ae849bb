// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_PICTURE_H
#define BOOMERANG_TESTBED_PICTURE_H

#include <string>
#include <vector>

namespace testbed {

struct Point {
    double x = 0.0, y = 0.0;
};

/// What a worker's --outline says (see ../outline.h), parsed.
struct Outline {
    enum class Kind { Polygon, Circle, Chain };
    struct Shape {
        Kind kind = Kind::Polygon;
        int body = 0;
        std::string state;
        std::vector<Point> points; ///< a circle's only point is its centre
        double radius = 0.0, angle = 0.0;
    };
    struct Pair {
        Point a, b;         ///< closest points
        double slack = 0.0; ///< certified distance; 0: nothing proved; -1: nobody was asked
    };
    std::vector<Shape> shapes;
    std::vector<Pair> pairs;
    std::vector<Pair> joints; ///< anchors; no slack
    std::vector<Point> contacts;
};

/// Reads one line that begins with "outline "; throws WorkerError on anything else.
void ParseOutlineLine(const std::string &line, Outline &outline);

/// Draws the outline in the colours of Box2D's testbed, with a title and a legend below, as an SVG, PNG or
/// PDF file by the ending of the path (drawing/surface.h). Bodies that flew far away from the others are left
/// outside the frame. Throws std::runtime_error if the file cannot be written.
void DrawPicture(const Outline &outline, const std::string &title, const std::string &path, int width);

} // namespace testbed

#endif
