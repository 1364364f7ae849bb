# SPDX-License-Identifier: MIT
"""Poses, polygons and their hierarchies (boomerang/pose.h, polygon.h, hierarchy.h)."""
import ctypes
import math
from collections.abc import Sequence

from . import _c


class Pose:
    """A rigid motion: turned counter-clockwise by `angle` (radians), then moved to (x, y). Immutable."""

    __slots__ = ("_c",)

    def __init__(self, x=0.0, y=0.0, angle=0.0):
        self._c = _c.pose(_c.vec2(float(x), float(y)), math.cos(angle), math.sin(angle))

    @classmethod
    def _of(cls, c):
        made = cls.__new__(cls)
        made._c = _c.pose(_c.vec2(c.position.x, c.position.y), c.c, c.s)
        return made

    @property
    def position(self):
        return _c.point(self._c.position)

    @property
    def angle(self):
        """In (-pi, pi]."""
        return math.atan2(self._c.s, self._c.c)

    def __call__(self, point):
        """Takes a point from the pose's frame outwards."""
        x, y = point
        return (self._c.c * x - self._c.s * y + self._c.position.x, self._c.s * x + self._c.c * y + self._c.position.y)

    def __repr__(self):
        return f"Pose({self.position[0]:g}, {self.position[1]:g}, angle={self.angle:g})"


def pose(value):
    """A Pose as it is; (x, y) or (x, y, angle) made one; None is the origin."""
    if isinstance(value, Pose):
        return value
    return Pose() if value is None else Pose(*value)


class Polygon(Sequence):
    """The convex hull of points, in any order: exact, immutable, a sequence of its vertices counter-clockwise. One point is a
    polygon, and two are. O(n log n)."""

    def __init__(self, points):
        array, count = _c.vectors(points)
        self._c, where = _c.create(_c.core.bmr_polygon_create, array, count, kind=ctypes.POINTER(_c.polygon))
        _c.release_with(self, (), _c.core.bmr_polygon_destroy, self._c, where)
        self._hierarchies = {}

    def __len__(self):
        return self._c.contents.count

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        # (ctypes would read beyond the end.)
        if not -len(self) <= index < len(self):
            raise IndexError(f"vertex {index} of {len(self)}")
        return _c.point(self._c.contents.vertices[index % len(self)])

    def contains(self, point, tolerance=0.0):
        """Is the point inside, or at most `tolerance` beyond the line of an edge? Exact for 0."""
        return _c.core.bmr_polygon_contains(self._c, _c.to_vec2(point), float(tolerance))

    def hierarchy(self, kind="dudley"):
        """The hierarchy of this kind, "compass", "dudley" or "dobkin-kirkpatrick": built when it is asked for first."""
        if kind not in self._hierarchies:
            self._hierarchies[kind] = Hierarchy(self._c, kind)
        return self._hierarchies[kind]

    def _shape(self, kinds):
        """The C shape with the hierarchies of these kinds. The polygon must stay as long as it is in use."""
        made = _c.shape(polygon=self._c)
        for kind in kinds:
            made.hierarchies[_c.HIERARCHY_KINDS.index(kind)] = self.hierarchy(kind)._c
        return made

    def __repr__(self):
        return f"<Polygon of {len(self)} vertices>"


class Hierarchy:
    """Outer approximations of a polygon, level by level (section 3 of the paper): Polygon.hierarchy makes it."""

    def __init__(self, polygon, kind):
        if kind not in _c.HIERARCHY_KINDS:
            raise ValueError(f"there is no hierarchy {kind!r}; there are {', '.join(_c.HIERARCHY_KINDS)}")
        number = _c.HIERARCHY_KINDS.index(kind)
        compass = ()
        if _c.core.bmr_hierarchy_uses_compass(number):
            table, where = _c.create(_c.core.bmr_compass_create, polygon.contents.count)
            compass = (_Compass(table, where),)
        self.kind = kind
        self._c, where = _c.create(_c.core.bmr_hierarchy_build, number, polygon, compass[0]._c if compass else None)
        _c.release_with(self, (compass, polygon), _c.core.bmr_hierarchy_destroy, self._c, where)

    @property
    def depth(self):
        """The deepest level; that envelope is the polygon itself."""
        return _c.core.bmr_hierarchy_depth(self._c)

    @property
    def edge_count(self):
        return _c.core.bmr_hierarchy_edge_count(self._c)


class _Compass:
    """The table of directions that a compass hierarchy looks into."""

    def __init__(self, table, where):
        self._c = table
        _c.release_with(self, (), _c.core.bmr_compass_destroy, table, where)
