// SPDX-License-Identifier: MIT
#ifndef BOOMERANG_TESTBED_WORLD_VIEW_H
#define BOOMERANG_TESTBED_WORLD_VIEW_H

#include <map>
#include <vector>

#include "boomerang/vector.h"
#include "drawing/canvas.h"
#include "picture/frame.h"

namespace testbed {

/// A frame with its bodies and fixtures at hand. Refers to what it is made of.
class WorldView {
public:
    explicit WorldView(const shown::Frame &frame);

    const shown::Frame &Frame() const { return m_frame; }
    /// nullptr: there is none of this number.
    const shown::Body *FindBody(int number) const;
    const shown::Pose &PoseOf(int body) const; ///< throws where there is no such body
    /// By their numbers.
    const std::vector<const shown::Fixture *> &FixturesOf(int body) const;

    /// Points of a body in the world.
    bmr_vec2 ToWorld(int body, const shown::Vec &point) const;
    std::vector<bmr_vec2> ToWorld(int body, const std::vector<shown::Vec> &points) const;
    bmr_vec2 Turned(int body, const shown::Vec &direction) const;

    /// The box around a fixture, or around all of a body's; empty (left > right) where it has none.
    Rectangle BoxOf(const shown::Fixture &fixture) const;
    Rectangle BoxOfBody(int body) const;

private:
    const shown::Frame &m_frame;
    std::map<int, const shown::Body *> m_bodies;
    std::map<int, std::vector<const shown::Fixture *>> m_fixtures;
};

bmr_vec2 ToVec2(const shown::Vec &v);

} // namespace testbed

#endif
