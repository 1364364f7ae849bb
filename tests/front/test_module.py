#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_module.py ROOT: the Python module on the built libraries. Environment: PYTHONPATH, BOOMERANG_LIBRARY_DIR."""
import ctypes
import functools
import gc
import math
import os
import pathlib
import re
import subprocess
import sys
import unittest
import unittest.mock

import boomerang as bmr
from boomerang import _c, analysis, kinetic

import c_types

ROOT = pathlib.Path(sys.argv.pop(1))
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]


class CountingMemory:
    """malloc for the library, counted; `left` is what was not given back."""

    def __init__(self):
        libc = ctypes.CDLL(None)
        libc.malloc.restype, libc.malloc.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
        libc.free.restype, libc.free.argtypes = None, [ctypes.c_void_p]
        self.left, self.blocks, self.fails = 0, 0, False

        def allocate(_, size):
            if self.fails:
                return None
            self.left, self.blocks = self.left + size, self.blocks + 1
            return libc.malloc(size)

        def release(_, block, size):
            self.left -= size
            libc.free(block)

        types = dict(_c.allocator._fields_)
        self.c = _c.allocator(types["allocate"](allocate), types["release"](release), None)

    def __enter__(self):
        _c.memory = self.c
        return self

    def __exit__(self, *_):
        gc.collect()
        _c.memory = None


@functools.cache
def types_of_c():
    return c_types.types(ROOT)


def layout(name):
    """(size, {member: offset}) of a C record, as clang reads the headers."""
    lines = types_of_c()
    size = next(int(m.group(1)) for line in lines if (m := re.match(rf"record bmr_{name}: (\d+) bytes", line)))
    members = {m.group(2): int(m.group(1)) for line in lines if (m := re.match(rf"record bmr_{name} (\d+): .*?(\w+)$", line))}
    return size, members


def laid_out_as_in_c(structure, name):
    size, members = layout(name)
    ours = {field: getattr(structure, field).offset for field, *_ in structure._fields_}
    return ctypes.sizeof(structure) == size and ours == members


class Library(unittest.TestCase):
    def test_every_record_is_laid_out_as_in_c(self):
        records = {name: value for name, value in vars(_c).items() if isinstance(value, type) and issubclass(value, ctypes.Structure)}
        self.assertGreater(len(records), 30)
        for name, structure in records.items():
            if name == "pair":  # (its 8 bits of flags are one member here)
                self.assertEqual(ctypes.sizeof(structure), layout(name)[0])
                self.assertEqual({n: o for n, o in layout(name)[1].items() if n in dict(structure._fields_)},
                                 {n: getattr(structure, n).offset for n, _ in structure._fields_ if n != "bits"})
            else:
                self.assertTrue(laid_out_as_in_c(structure, name), name)

    def test_control_another_layout_is_noticed(self):
        changed = _c.record("overlap", ("normal", _c.vec2), ("depth", ctypes.c_double), ("point_a", _c.vec2), ("point_b", _c.vec2))
        self.assertFalse(laid_out_as_in_c(changed, "overlap"))

    def test_every_function_takes_as_many_arguments_as_in_c(self):
        types = types_of_c()
        for name, (_, *arguments) in {**_c.CORE, **_c.KINETIC}.items():
            taken = next(m.group(1) for line in types if (m := re.match(rf"function {name}: .*?\((.*)\)$", line)))
            self.assertEqual(len(arguments), 0 if taken == "void" else taken.count(",") + 1, name)

    def test_the_version_is_that_of_the_build(self):
        self.assertIn(f"VERSION {bmr.__version__} ", (ROOT / "CMakeLists.txt").read_text())

    def test_a_library_that_is_not_there_is_told(self):
        environment = dict(os.environ, BOOMERANG_LIBRARY_DIR="")
        program = "import boomerang._c as c\nc.load('libboomerang_absent.so.1')"
        done = subprocess.run([sys.executable, "-c", program], env={**environment, "LD_LIBRARY_PATH": os.environ["BOOMERANG_LIBRARY_DIR"]},
                              capture_output=True, text=True, check=False)
        self.assertRegex(done.stderr, "ImportError: libboomerang_absent.so.1 is not found .*BOOMERANG_LIBRARY_DIR")

    def test_a_folder_without_the_library_is_told_what_has_it(self):
        with unittest.mock.patch.dict(os.environ, BOOMERANG_LIBRARY_DIR="/nowhere"):
            with self.assertRaisesRegex(ImportError, "libboomerang_kinetic.so.1 is not found .*libgsl-dev"):
                _c.load("libboomerang_kinetic.so.1")


class Asked(unittest.TestCase):
    def test_a_polygon_is_the_hull_of_its_points(self):
        p = bmr.Polygon([(1, 1), *SQUARE])
        self.assertEqual(list(p), [(0, 0), (2, 0), (2, 2), (0, 2)])
        self.assertEqual((len(p), p[-1], p[1:3]), (4, (0, 2), [(2, 0), (2, 2)]))
        self.assertTrue(p.contains((2, 1)) and not p.contains((2.1, 1)) and p.contains((2.1, 1), tolerance=0.2))
        with self.assertRaises(IndexError):
            p[4]

    def test_distance_and_penetration(self):
        p = bmr.Polygon(SQUARE)
        closest = bmr.distance(p, None, p, (5, 0.5))
        self.assertEqual((closest.distance, closest.normal), (3, (1, 0)))
        self.assertEqual(bmr.distance(p, None, p, (1, 0)).distance, 0)
        overlap = bmr.penetration(p, None, p, bmr.Pose(1.5, 0))
        self.assertAlmostEqual(overlap.depth, 0.5)
        turned = bmr.distance(p, None, p, bmr.Pose(5, 0, angle=math.pi / 4))
        self.assertAlmostEqual(turned.distance, 3 - math.sqrt(2))

    def test_errors_are_the_librarys_sentences(self):
        for points, sentence in (([], "point"), ([(math.nan, 0)], "NaN|finite"), ([(1e10, 0)], "coordinates")):
            with self.assertRaisesRegex(bmr.BoomerangError, sentence) as caught:
                bmr.Polygon(points)
            self.assertGreater(caught.exception.code, 0)
        with self.assertRaises(bmr.BoomerangError):
            bmr.distance(bmr.Polygon(SQUARE), None, bmr.Polygon(SQUARE), bmr.Pose(math.inf, 0))
        with self.assertRaisesRegex(ValueError, "there are compass, dudley"):
            bmr.Polygon(SQUARE).hierarchy("dudly")
        with self.assertRaisesRegex(ValueError, "lazy-dudley"):
            bmr.Pair(bmr.Polygon(SQUARE), bmr.Polygon(SQUARE), "lazy")

    def test_a_pair_says_no_more_than_is_true(self):
        a, b = analysis.ngon("ellipse", 64), analysis.ngon("disc", 32, seed=3)
        for structure in _c.PAIR_STRUCTURES:
            pair, apart = bmr.Pair(a, b, structure), 0
            for step in range(300):
                pose = bmr.Pose(3 * math.cos(0.1 * step), 2 * math.sin(0.13 * step), angle=0.07 * step)
                gap, true = pair.advance(pose), bmr.distance(a, None, b, pose).distance
                self.assertLessEqual(gap, true)
                self.assertEqual(gap > 0, pair.certificate is not None)
                pair.audit(pose)
                apart += gap > 0
            self.assertTrue(0 < apart < 300 and pair.checks == 300 and pair.events[0].kind == "start", structure)
            with self.assertRaises(bmr.BoomerangError):  # a control of the audit: another place
                pair.advance((3, 0))
                pair.audit((0.1, 0))


class Kinetic(unittest.TestCase):
    def setUp(self):
        self.p = bmr.Polygon(SQUARE)

    def test_every_structure_finds_the_contact_of_two_squares(self):
        for structure in kinetic.structures():
            if structure.domain == "point":
                continue
            moves = kinetic.Motion.screw((-9, 0.5), velocity=(2, 0))
            simulation = kinetic.Simulation([self.p, self.p], [kinetic.Motion.rest(), moves], structure.name)
            events = simulation.run(3) + simulation.run(5)
            simulation.audit()
            self.assertEqual((events[0].kind, events[-1].kind), ("start", "contact"), structure.name)
            self.assertAlmostEqual(events[-1].time, 3.5, places=5)
            self.assertEqual(simulation.counts["events"]["contact"], 1)
            self.assertEqual(simulation.time, 5)

    def test_motions_are_where_they_say(self):
        bow = kinetic.Motion.algebraic([0, 1], [0, 0, 2], angle=0.5)
        self.assertAlmostEqual(bow(3).position[0], 3)
        self.assertAlmostEqual(bow(3).position[1], 18)
        self.assertAlmostEqual(bow(3).angle, 0.5)
        walk = kinetic.Motion.sampled([0, 1, 3], [(0, 0), (1, 0, 0.2), (1, 4)])
        self.assertAlmostEqual(walk(2).position[1], 2)
        self.assertAlmostEqual(walk(2).angle, 0.1)
        for wrong in (lambda: kinetic.Motion.sampled([0, 1], [(0, 0)]), lambda: kinetic.Motion.algebraic([0] * 10, [0]),
                      lambda: kinetic.Motion.sampled([1, 0], [(0, 0), (1, 1)]), lambda: kinetic.Motion.sampled([], [])):
            self.assertRaises(ValueError, wrong)

    def test_a_time_of_contact_is_that_of_the_simulation(self):
        arrives = kinetic.Motion.screw((-9, 0.5), velocity=(2, 0))
        self.assertAlmostEqual(kinetic.time_of_contact(self.p, kinetic.Motion.rest(), self.p, arrives, until=9), 3.5, places=5)
        self.assertIsNone(kinetic.time_of_contact(self.p, kinetic.Motion.rest(), self.p, arrives, until=3))

    def test_what_is_asked_wrongly_is_told(self):
        with self.assertRaisesRegex(bmr.BoomerangError, 'no structure "lazy-dudly"; there are .*lazy-dudley'):
            kinetic.find_structure("lazy-dudly")
        with self.assertRaisesRegex(ValueError, "not 1 and 0"):
            kinetic.Simulation([self.p], [])
        simulation = kinetic.Simulation([self.p, self.p], [kinetic.Motion.rest(), kinetic.Motion.rest((9, 0))])
        self.assertRaises(bmr.BoomerangError, simulation.run, math.nan)
        with self.assertRaisesRegex(ValueError, "there is no family 'lines'; there are line, "):
            analysis.family("lines", self.p, self.p, 8)
        self.assertRaises(bmr.BoomerangError, analysis.ngon, "disc", 2)
        self.assertRaises(bmr.BoomerangError, analysis.fit_growth, [1], [1])

    def test_an_orbit_costs_its_root_and_no_less_than_the_optimum(self):
        a, b = analysis.ngon("ellipse", 64), analysis.ngon("disc", 64)
        ratios, events = [8, 64, 512], []
        for ratio in ratios:
            course = analysis.family("orbit", a, b, ratio)
            self.assertAlmostEqual(course.separation * ratio / course.diameter, 1, places=1)
            events.append(len(course.run()))
        least, found = course.optimum()
        self.assertTrue(0 < least <= found <= events[-1])
        self.assertTrue(0.3 < analysis.fit_growth(ratios, events).exponent < 0.7)


class Memory(unittest.TestCase):
    def work(self):
        a, b = analysis.ngon("ellipse", 64), bmr.Polygon(SQUARE)
        for kind in _c.HIERARCHY_KINDS:
            self.assertGreater(a.hierarchy(kind).depth, 0)
        bmr.Pair(a, b, "lazy-compass").advance((5, 0))
        course = analysis.family("tumble", a, b, 8)
        simulation = kinetic.Simulation([a, b], course.motions, "active-cell-compass")
        del a, b, course  # the simulation keeps them
        gc.collect()
        self.assertGreater(len(simulation.run(1)), 1)
        simulation.audit()
        return simulation

    def test_all_of_it_is_given_back(self):
        with CountingMemory() as memory:
            kept = self.work()
            self.assertTrue(memory.left > 0 and memory.blocks > 10)  # the control: what is kept is counted
            del kept
            gc.collect()
            self.assertEqual(memory.left, 0)

    def test_memory_that_fails_is_an_error(self):
        with CountingMemory() as memory:
            memory.fails = True
            with self.assertRaisesRegex(bmr.BoomerangError, "memory"):
                bmr.Polygon(SQUARE)


if __name__ == "__main__":
    unittest.main()
