# SPDX-License-Identifier: MIT
"""How two posed polygons lie to each other, asked once (boomerang/distance.h)."""
from ctypes import byref
from typing import NamedTuple

from . import _c
from .shapes import pose


class Closest(NamedTuple):
    """Two closest points, in the world, and the unit normal from A to B. All zero where the polygons touch or overlap."""

    distance: float
    point_a: tuple
    point_b: tuple
    normal: tuple


class Overlap(NamedTuple):
    """The shortest way out: B moved by depth * normal touches A. All zero where the polygons are apart."""

    depth: float
    normal: tuple
    point_a: tuple
    point_b: tuple


def distance(a, pose_a, b, pose_b):
    """The distance of two polygons at their poses (a Pose, (x, y), (x, y, angle) or None). O(log n + log m)."""
    found = _c.closest_points()
    _c.core.bmr_distance(a._c, byref(pose(pose_a)._c), b._c, byref(pose(pose_b)._c), byref(found))
    return Closest(found.distance, _c.point(found.point_a), _c.point(found.point_b), _c.point(found.normal))


def penetration(a, pose_a, b, pose_b):
    """How deep two polygons are in each other."""
    found = _c.overlap()
    _c.core.bmr_penetration(a._c, byref(pose(pose_a)._c), b._c, byref(pose(pose_b)._c), byref(found))
    return Overlap(found.depth, _c.point(found.normal), _c.point(found.point_a), _c.point(found.point_b))
