// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_VIEW_H
#define BOOMERANG_TESTBED_WORLD_VIEW_H

#include <map>
#include <vector>

#include "boomerang/vector.h"
#include "drawing/canvas.h"
#include "recording/recording.h"

namespace testbed {

/// A frame with its bodies and fixtures at hand. Refers to what it is made of.
class WorldView {
public:
    WorldView(const recording::Frame &frame, const recording::Gathered &gathered);

    const recording::Frame &Frame() const { return m_frame; }
    const recording::Gathered &Gathered() const { return m_gathered; }
    /// nullptr: there is none of this number.
    const recording::Body *FindBody(int number) const;
    const recording::Pose &PoseOf(int body) const; ///< throws where there is no such body
    const std::vector<const recording::Fixture *> &FixturesOf(int body) const;

    /// Points of a body in the world.
    bmr_vec2 ToWorld(int body, const recording::Vec &point) const;
    std::vector<bmr_vec2> ToWorld(int body, const std::vector<recording::Vec> &points) const;
    bmr_vec2 Turned(int body, const recording::Vec &direction) const;

    /// The box around a fixture, or around all of a body's; empty (left > right) where it has none.
    Rectangle BoxOf(const recording::Fixture &fixture) const;
    Rectangle BoxOfBody(int body) const;

private:
    const recording::Frame &m_frame;
    const recording::Gathered &m_gathered;
    std::map<int, const recording::Body *> m_bodies;
    std::map<int, std::vector<const recording::Fixture *>> m_fixtures;
};

bmr_vec2 ToVec2(const recording::Vec &v);

/// A rectangle that holds nothing, and how it grows.
Rectangle NoRectangle();
bool IsEmpty(const Rectangle &box);
void Grow(Rectangle *box, bmr_vec2 point, double radius = 0.0);
void Grow(Rectangle *box, const Rectangle &other);
Rectangle Intersection(const Rectangle &a, const Rectangle &b);
/// Wider by a share of its larger side, on each side.
Rectangle Widened(const Rectangle &box, double share);

} // namespace testbed

#endif
