# SPDX-License-Identifier: MIT
"""Two polygons whose poses come in steps: a proof is kept from one to the next, and repaired where it fails (boomerang/pair.h)."""
from ctypes import byref, c_double
from typing import NamedTuple

from . import _c
from .shapes import pose

NEW, APART, CONTACT = "new", "apart", "contact"


class PairEvent(NamedTuple):
    """What one repair did, in the paper's words: start, push, stab, roll, coarsen, contact or leave."""

    kind: str
    level_before: int
    level_after: int
    gap: float


class Pair:
    """A pair of polygons, A and B. Poses are of B's frame in A's frame."""

    def __init__(self, a, b, structure="lazy-dudley", margin=0.0, hysteresis=0.0):
        if structure not in _c.PAIR_STRUCTURES:
            raise ValueError(f"there is no structure {structure!r} for a pair; there are {', '.join(_c.PAIR_STRUCTURES)}")
        self.a, self.b, self.structure = a, b, structure
        self._def = _c.pair_def(_c.PAIR_STRUCTURES.index(structure), float(margin), float(hysteresis))
        kinds = [kind for kind in _c.HIERARCHY_KINDS if structure == "lazy-" + kind]
        self._shapes = a._shape(kinds), b._shape(kinds)
        self._c = _c.pair()
        self._counters = _c.counters()
        self._events = []
        self._observer = _c.observer(_c.pointer(self._counters), _c.ON_EVENT(self._on_event()), None)

    def _on_event(self):
        events = self._events  # not self: the callback must not keep the pair

        def note(_, event):
            e = event.contents
            events.append(PairEvent(_c.core.bmr_event_name(e.kind).decode(), e.level_before, e.level_after, e.gap))

        return note

    def advance(self, b_in_a):
        """Takes the pair to a pose. Returns a certified lower bound of the distance, > margin where the polygons are proved apart,
        and 0.0 where they are not: then ask `distance` or `penetration`. O(1) while the proof holds."""
        gap = c_double()
        _c.core.bmr_pair_advance(byref(self._c), byref(self._def), byref(self._shapes[0]), byref(self._shapes[1]),
                                 byref(pose(b_in_a)._c), byref(self._observer), byref(gap))
        return gap.value

    def audit(self, b_in_a):
        """Proves the pair's state again from nothing, at the pose of the last advance; raises BoomerangError if it is false."""
        _c.core.bmr_pair_audit(byref(self._c), byref(self._def), byref(self._shapes[0]), byref(self._shapes[1]), byref(pose(b_in_a)._c))

    @property
    def state(self):
        return (NEW, APART, CONTACT)[self._c.state]

    @property
    def level(self):
        """-1 while two disks are proof enough, then the level of the hierarchy."""
        return self._c.level

    @property
    def events(self):
        """All repairs so far, as PairEvents."""
        return tuple(self._events)

    @property
    def checks(self):
        """How often `advance` was called."""
        return self._counters.checks

    @property
    def steps(self):
        """Elementary steps of all repairs: what they cost."""
        return self._counters.steps

    @property
    def certificate(self):
        """What proves the pair apart at this moment, or None: a dict. With `disks`, the two bodies' bounding disks; else `normal` and
        `offset` of a line in the owner's frame, and the `window` of the other's points that are nearest to it."""
        if self.state != APART:
            return None
        k = self._c.certificate
        if self.level < 0:
            return {"disks": (tuple(k.normal), tuple(k.window[0])), "sum_of_radii": k.offset}
        return {"owner": "ab"[self._c.owner], "level": self.level, "normal": tuple(k.normal), "offset": k.offset,
                "window": (tuple(k.window[0]), tuple(k.window[1]))}
