# SPDX-License-Identifier: MIT
"""What the paper's table is measured with: polygons, families of motions with a chosen least separation, the offline optimum, and fits
of growth (boomerang/families.h, analysis.h). Loads libboomerang_kinetic, as boomerang.kinetic does."""
from ctypes import byref, c_double
from typing import NamedTuple

from . import _c
from .kinetic import Motion, Simulation, library
from .shapes import Polygon


def _names(function):
    names = []
    while (name := function(len(names))) is not None:
        names.append(name.decode())
    return tuple(names)


NGONS = _names(library.bmr_ngon_name)
FAMILIES = _names(library.bmr_family_name)


def _find(name, names, what):
    if name not in names:
        raise ValueError(f"there is no {what} {name!r}; there are {', '.join(names)}")
    return names.index(name)


def ngon(name, n, seed=1):
    """A polygon of n vertices and diameter about 2: "regular", "random", "lens", "ellipse" or "disc"."""
    points = (_c.vec2 * max(3, min(int(n), 1 << 17)))()
    library.bmr_ngon_points(_find(name, NGONS, "polygon"), n, seed, points)
    return Polygon(_c.point(p) for p in points[:n])


class Course:
    """Two polygons and how they move over the times 0 to 1. D/sigma is the larger diameter over the least separation."""

    def __init__(self, a, b, motions, diameter, separation):
        self.a, self.b, self.motions, self.diameter, self.separation = a, b, motions, diameter, separation

    def run(self, structure="lazy-dudley"):
        """The events of a structure along the course: certificates that failed and were repaired (no starts)."""
        events = Simulation((self.a, self.b), self.motions, structure).run(1.0)
        return [event for event in events if event.kind != "start"]

    def optimum(self, margin=1e-6, resolution=0.02):
        """(least, found): the fewest separating lines that cover the course, between two bounds."""
        course, answer = _c.course(), _c.optimum()
        course.polygons[0], course.polygons[1] = self.a._c, self.b._c
        course.motions[0], course.motions[1] = (motion._c for motion in self.motions)
        course.to = 1.0
        library.bmr_offline_optimum(byref(course), margin, resolution, None, 0, byref(answer))
        return answer.least, answer.found


def family(name, a, b, ratio, seed=1, steps=0, turns=0):
    """The Course of one of FAMILIES ("line", "orbit", "tumble", ..) with D/sigma = ratio."""
    wanted = _c.family_def(_find(name, FAMILIES, "family"), float(ratio), seed, steps, turns)
    made, _ = _c.create(library.bmr_family_create, byref(wanted), a._c, b._c, kind=_c.family_motion)
    return Course(a, b, tuple(Motion(handle) for handle in made.motions), made.diameter, made.separation)


class Growth(NamedTuple):
    """y = constant * x^exponent, or offset + slope * log2 x; `logarithmic` says which fits better."""

    exponent: float
    exponent_error: float
    constant: float
    slope: float
    slope_error: float
    offset: float
    logarithmic: bool


def fit_growth(x, y):
    x, y = [float(v) for v in x], [float(v) for v in y]
    if len(x) != len(y):
        raise ValueError(f"{len(x)} x and {len(y)} y")
    found, count = _c.growth(), max(1, len(x))
    library.bmr_fit_growth((c_double * count)(*x), (c_double * count)(*y), len(x), byref(found))
    return Growth(*(getattr(found, name) for name in Growth._fields))
