# SPDX-License-Identifier: MIT
"""Boomerang from Python: separation of convex polygons that move, with the structures of Erickson, Guibas, Stolfi and Zhang (SODA '99).

    import boomerang as bmr

    square = bmr.Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
    answer = bmr.distance(square, bmr.Pose(), square, bmr.Pose(5, 1, angle=0.3))
    answer.distance, answer.point_a, answer.point_b

    pair = bmr.Pair(square, square)              # remembers a proof from pose to pose
    pair.advance(bmr.Pose(5, 1))                 # apart by at least so much, and the events that it took

    from boomerang import kinetic                # motions that are known; loads GSL, which is under the GPL-3
    run = kinetic.Simulation([square, square], [kinetic.Motion.rest(), kinetic.Motion.screw((-9, 3), velocity=(4, 0))])
    for event in run.run(until=5): ...

The module needs nothing but Python's standard library and libboomerang_core.so.1 (libboomerang_kinetic.so.1 for `kinetic` and
`analysis`). It looks for them in $BOOMERANG_LIBRARY_DIR if that is set, else beside where it is installed, else where the loader
looks. Whatever the library refuses is raised as `BoomerangError`, with its sentence. The C headers are the reference.
"""
from ._c import BoomerangError
from .pair import Pair, PairEvent
from .queries import Closest, Overlap, distance, penetration
from .shapes import Hierarchy, Polygon, Pose

__version__ = "1.0.0"
__all__ = ["BoomerangError", "Closest", "Hierarchy", "Overlap", "Pair", "PairEvent", "Polygon", "Pose", "distance", "penetration"]
