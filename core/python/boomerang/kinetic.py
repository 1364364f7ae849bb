# SPDX-License-Identifier: MIT
"""Motions that are known beforehand, and their events in the order of time (boomerang/motion.h, simulation.h, time_of_contact.h).

Loads libboomerang_kinetic, which links the GNU Scientific Library: a program distributed with it inside is under the GPL-3.
"""
import ctypes
import math
from ctypes import byref, c_double, c_void_p
from typing import NamedTuple, Optional

from . import _c
from .shapes import Pose, pose

library = _c.Library("libboomerang_kinetic.so.1", _c.KINETIC)
_ALGEBRAIC, _SCREW = 0, 1
_EVENT_NAMES = tuple(_c.core.bmr_kds_event_name(kind).decode() for kind in range(12))


class Structure(NamedTuple):
    """A kinetic structure by name. `hierarchy` is the kind that it walks on, or None."""

    name: str
    title: str
    section: str
    domain: str
    role: str
    hierarchy: Optional[str]


def _structure(info):
    hierarchy = _c.HIERARCHY_KINDS[info.hierarchy] if info.hierarchy >= 0 else None
    return Structure(info.name.decode(), info.title.decode(), info.section.decode(), ("point", "translation", "rigid")[info.domain],
                     ("recommended", "control", "rival")[info.role], hierarchy)


def structures():
    """Every structure of the paper, its rivals, and what answers its open question, in the paper's order."""
    return [_structure(_c.core.bmr_kds_at(index).contents) for index in range(_c.core.bmr_kds_count())]


def find_structure(name):
    """(the C structure, its Structure). Raises BoomerangError, which names all there are."""
    found = ctypes.POINTER(_c.kds_info)()
    encoded = str(name).encode()
    try:
        _c.core.bmr_kds_find(encoded, byref(found))
    except _c.BoomerangError as problem:
        text = ctypes.create_string_buffer(4096)
        _c.core.bmr_kds_describe_unknown(encoded, text, len(text))
        raise _c.BoomerangError(problem.code, text.value.decode(errors="replace")) from None
    return found, _structure(found.contents)


class Motion:
    """A rigid motion of one body as a function of time, for all time. Made by rest, screw, algebraic or sampled."""

    def __init__(self, handle):
        self._c = handle
        _c.release_with(self, (), library.bmr_motion_destroy, handle)

    @classmethod
    def _of_piece(cls, piece):
        return cls(_c.create(library.bmr_motion_create, byref(piece))[0])

    @classmethod
    def rest(cls, at=None):
        return cls.screw(at)

    @classmethod
    def screw(cls, start=None, velocity=(0.0, 0.0), spin=0.0, origin=0.0):
        """At `start`, which is a Pose, (x, y) or (x, y, angle), at the time `origin`; from there along a line, turning by `spin`
        radians a unit of time."""
        piece = _c.motion_piece(_SCREW, float(origin))
        getattr(piece, "as").screw = _c.screw_motion(pose(start)._c, _c.to_vec2(velocity), float(spin))
        return cls._of_piece(piece)

    @classmethod
    def algebraic(cls, x, y, angle=0.0, turn=((1.0,), (0.0,)), origin=0.0):
        """Position (sum x[k] u^k, sum y[k] u^k) with u = time - origin, up to degree 8; rotation `angle` and 2 atan2(b(u), a(u)) for
        turn = (a, b), two lists of coefficients without a common root."""
        size = max(len(x), len(y)), max(len(turn[0]), len(turn[1]))
        if min(len(x), len(y), len(turn[0]), len(turn[1])) < 1 or max(size) > 9:
            raise ValueError("a polynomial has 1 to 9 coefficients")
        piece = _c.motion_piece(_ALGEBRAIC, float(origin))
        algebraic = getattr(piece, "as").algebraic
        algebraic.degree, algebraic.rotation_degree = size[0] - 1, size[1] - 1
        for name, coefficients in (("x", x), ("y", y), ("a", turn[0]), ("b", turn[1])):
            getattr(algebraic, name)[: len(coefficients)] = [float(c) for c in coefficients]
        algebraic.start_c, algebraic.start_s = math.cos(angle), math.sin(angle)
        return cls._of_piece(piece)

    @classmethod
    def sampled(cls, times, poses):
        """Screw motions from sample to sample; at rest before the first and after the last. `times` ascend."""
        times, poses = [float(t) for t in times], [pose(p)._c for p in poses]
        if len(times) != len(poses):
            raise ValueError(f"{len(times)} times and {len(poses)} poses")
        count = len(times)
        samples = (c_double * max(1, count))(*times), (_c.pose * max(1, count))(*poses)
        return cls(_c.create(library.bmr_motion_create_sampled, *samples, count)[0])

    def __call__(self, time):
        """The pose at a time."""
        return Pose._of(library.bmr_motion_pose(self._c, float(time), None, None))


class Event(NamedTuple):
    """One event of a simulation, in the paper's words, and what it cost in elementary steps."""

    time: float
    kind: str
    apart: bool
    line_changed: bool
    level_before: int
    level_after: int
    steps: int


class Simulation:
    """Two polygons that move as planned: one kinetic structure, events in time order."""

    def __init__(self, polygons, motions, structure="lazy-dudley", time=0.0, margin=1e-6, hysteresis=0.0):
        polygons, motions = tuple(polygons), tuple(motions)
        if len(polygons) != 2 or len(motions) != 2:
            raise ValueError(f"two polygons and their motions, not {len(polygons)} and {len(motions)}")
        made = library.bmr_default_simulation_def()
        made.structure, self.structure = find_structure(structure)
        made.kds.margin, made.kds.hysteresis = float(margin), float(hysteresis)
        kinds = [self.structure.hierarchy] if self.structure.hierarchy else []
        shapes = (_c.shape * 2)(*(polygon._shape(kinds) for polygon in polygons))
        plans = (c_void_p * 2)(*(motion._c for motion in motions))
        self._new = []
        observer = _c.ON_SIMULATION_EVENT(_note_into(self._new))
        self._c, _ = _c.create(library.bmr_simulation_create, byref(made), shapes, plans, float(time), observer, None)
        _c.release_with(self, (polygons, motions, shapes, plans, observer), library.bmr_simulation_destroy, self._c)

    def run(self, until):
        """All events up to and at the time `until` that were not returned yet, in order; the first is the start."""
        library.bmr_simulation_run(self._c, float(until))
        events = list(self._new)
        self._new.clear()
        return events

    @property
    def time(self):
        return library.bmr_simulation_time(self._c)

    @property
    def counts(self):
        """What it took so far: {"events": {kind: number}, "lines": .., "steps": .., "failure_times": .., "conditions": .., "bytes": ..}."""
        c = library.bmr_simulation_get_counts(self._c)
        return {"events": dict(zip(_EVENT_NAMES, c.events)), "lines": c.lines, "steps": c.touched, "failure_times": c.failure_times,
                "external": c.external, "conditions": c.conditions, "bytes": c.bytes}

    def audit(self):
        """Proves the pair apart again, from nothing; raises BoomerangError if the proof is false."""
        library.bmr_simulation_audit(self._c)


def _note_into(events):
    def note(_, event):
        e = event.contents
        r = e.report
        events.append(Event(e.time, _EVENT_NAMES[r.kind], r.apart, r.line_changed, r.level_before, r.level_after, r.touched))

    return note


def time_of_contact(a, motion_a, b, motion_b, start=0.0, until=1.0, margin=1e-6):
    """The first time in [start, until] at which the polygons are within `margin`, or None."""
    time = c_double()
    library.bmr_time_of_contact(byref(a._shape(["dudley"])), motion_a._c, byref(b._shape(["dudley"])), motion_b._c, float(start), float(until),
                                float(margin), _c.memory_now(), byref(time))
    return None if math.isinf(time.value) else time.value
