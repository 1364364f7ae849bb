#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The page of `boomerang-testbed replay`, in a browser, held against the recordings of the same runs.

    test_replay_page.py DIRECTORY-OF-THE-PROGRAMS [unittest's options]

The recordings are read here anew, from what the workers print: the page's data went another way. Where a check
could pass for the wrong reason, a control beside it shows that it can fail.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin

from browser import Browser
from replay_by_hand import ByHand

PROGRAMS = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else pathlib.Path(".")
POSITION_QUANTUM, ANGLE_QUANTUM, SLACK_QUANTUM = 1 / 4096, 1 / 16384, 1 / 1024
FLOAT = 1e-6  # what the recording's own floats lose in an angle
ANSWERS = ["unasked", "apart", "manifold", "handed over"]

# A scene with times of impact, and one whose bodies come and go, on kinetic structures alone.
SCENES = {
    "planks": ["planks", "--size", "40", "--steps", "90"],
    "rocks": ["chain-rocks", "--size", "30", "--steps", "120", "--structure", "lazy-compass"],
}


def count_library():
    for place in (PROGRAMS.parent / "lib", PROGRAMS):
        if (place / "libboomerang-count.so").exists():
            return place / "libboomerang-count.so"
    sys.exit("libboomerang-count.so is not built")


def testbed(*arguments):
    return subprocess.run([PROGRAMS / "boomerang-testbed", *arguments], capture_output=True, text=True, check=False)


class Recording:
    """Frames of one side, as the worker prints them."""

    def __init__(self, side, arguments):
        scene, rest = arguments[0], list(arguments[1:])
        if side == "stock":
            if "--structure" in rest:
                at = rest.index("--structure")
                del rest[at:at + 2]
        steps = int(rest[rest.index("--steps") + 1])
        program = PROGRAMS / ("boomerang-scene" if side == "stock" else "boomerang-scene-plugin")
        plugin = [] if side == "stock" else [str(PROGRAMS.parent / "lib" / "libboomerang_box2d.so")]
        environment = {name: value for name, value in os.environ.items() if not name.startswith("BOOMERANG")}
        environment["LD_PRELOAD"] = ":".join(plugin + [str(count_library())])
        environment["ASAN_OPTIONS"] = environment.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"
        done = subprocess.run([program, scene, *rest, "--mode", "count", "--record", f"0:{steps - 1}"],
                              capture_output=True, text=True, check=True, env=environment)
        self.frames = [json.loads(line[len("frame "):]) for line in done.stdout.splitlines() if line.startswith("frame ")]
        self.summary = json.loads(next(line for line in done.stdout.splitlines() if line.startswith("summary "))[8:])
        assert len(self.frames) == steps, f"{scene}: {len(self.frames)} frames"

    def pair(self, a, b):
        """{step: the pair's JSON}"""
        return {frame.get("step", 0): pair for frame in self.frames for pair in frame.get("pairs", [])
                if (pair.get("a", 0), pair["b"]) == (a, b)}

    def events(self, a, b):
        return [(event.get("step", 0), event["kind"], event.get("level_before", 0), event.get("level_after", 0))
                for frame in self.frames for event in frame.get("events", [])
                if {event.get("a", 0), event.get("b", 0)} == {a, b}]


def expected_answer(pair):
    if any(pair.get("calls", {}).values()):
        return "handed over"
    if pair.get("asked", 0) == 0:
        return "unasked"
    return "manifold" if pair.get("handed_over", 0) > 0 else "apart"


def farthest_off(shown, recorded):
    """The largest error of a body's place and turn, in quanta; infinite where not the same bodies are there."""
    by_number = {body["number"]: body for body in shown}
    if sorted(by_number) != sorted(body.get("number", 0) for body in recorded):
        return math.inf
    worst = 0.0
    for body in recorded:
        x, y, c, s = body.get("pose", [0, 0, 1, 0])
        its = by_number[body.get("number", 0)]
        worst = max(worst, abs(its["x"] - x) / POSITION_QUANTUM, abs(its["y"] - y) / POSITION_QUANTUM,
                    (math.hypot(its["cos"] - c, its["sin"] - s) - FLOAT) / ANGLE_QUANTUM)
    return worst


class ReplayPage(ByHand, unittest.TestCase):
    run_testbed = staticmethod(testbed)

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.pages, cls.recordings = {}, {}
        for name, arguments in SCENES.items():
            cls.pages[name] = pathlib.Path(cls.scratch.name) / f"{name}.html"
            done = testbed("replay", *arguments, "-o", str(cls.pages[name]))
            assert done.returncode == 0, done.stderr
            assert done.stderr == "", done.stderr  # piped: no progress line
            cls.recordings[name] = {side: Recording(side, arguments) for side in ("plugin", "stock")}
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.scratch.cleanup()

    def setUp(self):
        self.browser.resize(1280, 800)
        self.browser.prefer(prefers_color_scheme="light", prefers_reduced_motion="no-preference")
        self.show("planks")

    def show(self, name):
        self.browser.open(self.pages[name])
        self.assertTrue(self.browser.wait("document.documentElement.dataset.ready === 'yes'"),
                        self.browser.run("return document.getElementById('problem').textContent"))
        self.browser.settle()

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [], "the console")

    def seek(self, step):
        self.browser.run("replay.seek(arguments[0])", step)
        self.browser.settle()

    def slow_down(self, speed):
        self.browser.run("const s = document.getElementById('speed'); s.value = arguments[0];"
                         "s.dispatchEvent(new Event('change'))", speed)

    def press(self, *keys):
        ActionChains(self.browser.driver).send_keys(*keys).perform()
        self.browser.settle()

    def busiest(self, name, kind=None):
        """The two bodies with the most events (of a kind)."""
        counts = {}
        for frame in self.recordings[name]["plugin"].frames:
            for event in frame.get("events", []):
                if kind in (None, event["kind"]):
                    key = tuple(sorted((event.get("a", 0), event.get("b", 0))))
                    counts[key] = counts.get(key, 0) + 1
        self.assertTrue(counts, f"{name}: no events of kind {kind}")
        return max(counts, key=lambda key: (counts[key], key))

    def test_the_console_stays_empty_and_nothing_is_fetched(self):
        self.assertEqual(self.browser.errors(), [])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map((e) => e.name)"
                                          ".filter((name) => !name.startsWith('data:'))"), [])
        self.browser.run("console.error('control')")
        self.assertEqual(len(self.browser.errors()), 1, "control: errors are seen")

    def test_playback_advances_and_pauses(self):
        self.assertEqual(self.browser.run("return replay.step"), 0)
        self.browser.settle()
        self.assertEqual(self.browser.run("return replay.step"), 0, "control: it does not start by itself")
        self.slow_down("0.1")
        # It plays by the clock. Where the machine was so busy that it came to its end between two looks, once more.
        for _ in range(100):
            self.seek(0)
            self.browser.driver.find_element("id", "play").click()
            self.assertTrue(self.browser.wait("(replay.step > 8 && replay.framesDrawn > 3) || !replay.playing"))
            if self.browser.run("return replay.playing && (document.getElementById('play').click(), true)"):
                break
        self.assertTrue(self.browser.run("return replay.framesDrawn > 3"))
        self.assertFalse(self.browser.run("return replay.playing"))
        step = self.browser.run("return replay.step")
        self.browser.settle()
        self.assertEqual(self.browser.run("return replay.step"), step)
        self.assertTrue(self.browser.wait("document.getElementById('status').textContent.startsWith('Paused. Step')"))

    def test_it_plays_to_the_end_and_stops_there(self):
        self.seek(80)
        self.browser.run("replay.play()")
        self.assertTrue(self.browser.wait("!replay.playing"))
        self.assertEqual(self.browser.run("return replay.step"), 89)

    def test_each_step_shows_the_bodies_of_the_recording(self):
        for name in SCENES:
            self.show(name)
            frames = self.recordings[name]["plugin"].frames
            for step in (0, 1, 17, len(frames) // 2, len(frames) - 1):
                self.browser.run("const s = document.getElementById('scrub'); s.value = arguments[0];"
                                 "s.dispatchEvent(new Event('input'))", step)
                self.browser.settle()
                shown = self.browser.run("return replay.bodies()")
                self.assertLessEqual(farthest_off(shown, frames[step]["bodies"]), 0.51, f"{name}, step {step}")
                other = frames[step - 1 if step else 1]["bodies"]
                self.assertGreater(farthest_off(shown, other), 2, "control: another step's are elsewhere")

    def test_bodies_come_and_go(self):
        there = [{body.get("number", 0) for body in frame["bodies"]} for frame in self.recordings["rocks"]["plugin"].frames]
        self.assertTrue(there[0] - there[-1] and there[-1] - there[0], "control: rocks die and are born")
        self.show("rocks")
        for step in (0, len(there) - 1):
            self.seek(step)
            self.assertEqual({body["number"] for body in self.browser.run("return replay.bodies()")}, there[step])

    def check_pair(self, name, a, b, shown):
        plugin, stock = (self.recordings[name][side].pair(a, b) for side in ("plugin", "stock"))
        self.assertEqual([row["step"] for row in shown["steps"]],
                         sorted(set(plugin) | {step for step, pair in stock.items() if any(pair.get("calls", {}).values())}))
        for row in shown["steps"]:
            its = plugin.get(row["step"])
            if its is not None:
                slack = its.get("slack", -1)
                self.assertEqual(row["slack"] is None, slack < 0)
                if slack >= 0:
                    self.assertLessEqual(row["slack"], max(slack, SLACK_QUANTUM if slack > 0 else 0))
                    self.assertGreater(row["slack"], slack - SLACK_QUANTUM)
                self.assertEqual(ANSWERS[row["answer"]], expected_answer(its))
                self.assertEqual(row["touching"], its.get("touching", 0) > 0)
            calls = stock.get(row["step"], {}).get("calls", {})
            self.assertEqual((row["polygon"], row["toi"], row["overlap"]),
                             tuple(calls.get(key, 0) for key in ("polygon_tests", "toi", "overlap")))
        self.assertEqual([(event["step"], event["kind"], event["before"], event["after"]) for event in shown["events"]],
                         self.recordings[name]["plugin"].events(a, b))

    def test_a_pairs_time_line_is_that_of_the_recording(self):
        for name, kind in (("planks", None), ("planks", "contact"), ("rocks", "push"), ("rocks", "stab")):
            with self.subTest(scene=name, kind=kind):
                self.show(name)
                a, b = self.busiest(name, kind)
                shown = self.browser.run("return replay.pair(...arguments)", a, b)
                self.check_pair(name, a, b, shown)
                shown["steps"][len(shown["steps"]) // 2]["polygon"] += 1
                with self.assertRaises(AssertionError, msg="control: one test more is noticed"):
                    self.check_pair(name, a, b, shown)

    def test_totals_are_those_of_counting_runs(self):
        for name, arguments in SCENES.items():
            self.show(name)
            totals = self.browser.run("return replay.totals")
            stock = json.loads(testbed("run", *arguments, "--plugin", "off", "--json").stdout)
            names = {"polygon": "polygon_tests", "toi": "toi_calls", "distance": "distance_calls", "overlap": "overlap_calls"}
            for short, long in names.items():
                self.assertEqual(totals[f"stock.{short}"], stock[long], f"{name}: stock's {long}")
            # Of the plugin's side what the recorder itself asks for is not its own: b2Distance has no counterpart.
            recorded = self.recordings[name]["plugin"].summary
            self.assertEqual(totals["plugin.polygon"], recorded["polygon_tests"], f"{name}: polygon_tests")
            # Where a proof is remembered depends on where shapes lie in memory, and so, a little, does how many times of
            # impact are left to Box2D: another process may count a few more or fewer.
            room = max(5, recorded["toi_calls"] // 20)
            self.assertAlmostEqual(totals["plugin.toi"], recorded["toi_calls"], delta=room, msg=f"{name}: toi_calls")
            if name == "planks":
                self.assertGreater(totals["stock.toi"], recorded["toi_calls"] + room, "control: stock's number would be noticed")
            self.assertGreater(totals["stock.polygon"], totals["plugin.polygon"], "control: the sides differ")

    def test_the_scene_and_the_time_line_are_not_blank(self):
        self.browser.run("for (const name of ['zoom', 'readout', 'save']) document.querySelector('.' + name).hidden = true")
        self.assertGreater(self.browser.colours("#scene"), 30)
        a, b = self.busiest("planks")
        self.browser.run("replay.choose(...arguments)", a, b)
        self.browser.settle()
        self.assertGreater(self.browser.colours("#timeline"), 10)
        self.assertGreater(self.browser.colours("#load"), 5)
        self.browser.run("const c = document.getElementById('scene'); c.width = c.width")
        self.assertLess(self.browser.colours("#scene"), 30, "control: an empty canvas")

    def test_every_overlay_changes_the_picture(self):
        for name in ("planks", "rocks"):
            self.show(name)
            frames = self.recordings[name]["plugin"].frames
            self.seek(max(range(len(frames)), key=lambda step: len(frames[step].get("touching", []))))
            self.browser.driver.find_element("id", "zoom-fit").click()
            self.browser.settle()
            picture = "return document.getElementById('scene').toDataURL()"
            self.assertTrue(self.browser.run(picture) == self.browser.run(picture), "control: nothing else does")
            overlays = {"planks": ("slack", "contacts", "certificates", "boxes", "numbers"),
                        "rocks": ("hulls", "envelopes", "certificates")}[name]
            for overlay in overlays:
                before = self.browser.run(picture)
                self.browser.driver.find_element("id", f"show-{overlay}").click()
                self.browser.settle()
                self.assertFalse(self.browser.run(picture) == before, f"{name}: {overlay}")

    def test_a_kinetic_world_is_shown_without_box2d(self):
        run = pathlib.Path(self.scratch.name) / "run.txt"
        self.pages["world"] = run.with_suffix(".html")
        for arguments in (("world", "gas", "--bodies", "12", "--seconds", "2", "--quiet", "--record", run),
                          ("replay", "--recording", run, "-o", self.pages["world"])):
            self.assertEqual(testbed(*map(str, arguments)).returncode, 0)
        hidden = "return document.getElementById('load').closest('details').hidden"
        self.show("world")
        self.assertTrue(self.browser.run(hidden))
        self.seek(40)
        frame = json.loads(run.read_text().splitlines()[41][len("frame "):])
        self.assertEqual(len(self.browser.run("return replay.bodies()")), len(frame["bodies"]))
        picture = "return document.getElementById('scene').toDataURL()"
        self.assertTrue(self.browser.run(picture) == self.browser.run(picture), "control: nothing else does")
        for overlay in ("slack", "certificates", "hulls", "boxes", "numbers", "trails"):
            before = self.browser.run(picture)
            self.browser.driver.find_element("id", f"show-{overlay}").click()
            self.browser.settle()
            self.assertFalse(self.browser.run(picture) == before, overlay)
        self.show("planks")
        self.assertFalse(self.browser.run(hidden), "control: with Box2D it is there")

    def test_a_click_chooses_the_pair_below_it(self):
        pairs = self.recordings["planks"]["plugin"].frames[60]["pairs"]
        # A short line, which crosses no other.
        pair = min((pair for pair in pairs if pair.get("slack", 0) > 0.1), key=lambda pair: pair["slack"])
        a, b = pair.get("a", 0), pair["b"]
        self.browser.run("replay.seek(60); replay.choose(...arguments)", a, b)
        self.browser.driver.find_element("id", "pair-zoom").click()
        self.browser.settle()
        self.browser.run("replay.choose(-1, -1)")
        self.browser.settle()
        x, y = self.browser.run("return replay.linkOf(...arguments)", a, b)
        canvas = self.browser.driver.find_element("id", "scene")
        size = canvas.rect

        def click(dx, dy):
            ActionChains(self.browser.driver).move_to_element_with_offset(
                canvas, round(x + dx - size["width"] / 2), round(y + dy - size["height"] / 2)).click().perform()
            self.browser.settle()
        click(0, 0)
        self.assertEqual(self.browser.run("return replay.chosen"), [a, b])
        self.assertIn(f"Bodies {a} and {b}", self.browser.driver.find_element("id", "pair-title").text)
        self.browser.run("replay.choose(-1, -1); replay.seek(0)")
        self.browser.driver.find_element("id", "zoom-fit").click()
        self.browser.settle()
        x, y = 3, 3
        click(0, 0)
        self.assertIsNone(self.browser.run("return replay.chosen"), "control: nothing is in the corner")

    def test_wheel_drag_and_pinch_move_the_view(self):
        canvas = self.browser.driver.find_element("id", "scene")
        before = self.browser.run("return replay.camera")
        ActionChains(self.browser.driver).scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -300).perform()
        self.browser.settle()
        wheeled = self.browser.run("return replay.camera")
        self.assertGreater(wheeled["scale"], before["scale"])
        ActionChains(self.browser.driver).drag_and_drop_by_offset(canvas, 80, 40).perform()
        dragged = self.browser.run("return replay.camera")
        self.assertAlmostEqual(dragged["x"], wheeled["x"] - 80 / wheeled["scale"], places=3)
        self.assertAlmostEqual(dragged["y"], wheeled["y"] + 40 / wheeled["scale"], places=3)
        box = canvas.rect

        def touch(kind, spread):
            middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
            points = [] if spread is None else [{"x": middle[0] - spread, "y": middle[1], "id": 0},
                                                {"x": middle[0] + spread, "y": middle[1], "id": 1}]
            self.browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        touch("touchStart", 40)
        touch("touchMove", 60)
        touch("touchMove", 80)
        touch("touchEnd", None)
        self.browser.settle()
        self.assertAlmostEqual(self.browser.run("return replay.camera.scale") / dragged["scale"], 2, delta=0.05)

    def unreached(self):
        """Visible controls that Tab, pressed as often as there are some and more, never comes to."""
        self.browser.run("document.activeElement.blur(); window.scrollTo(0, 0)")
        wanted = self.browser.run("""
            window.controls = [...document.querySelectorAll("button, select, input, summary, a[href], [tabindex]")]
              .filter((e) => e.checkVisibility({visibilityProperty: true}) && !e.closest("dialog"));
            window.reached = new Set();
            return controls.length""")
        for _ in range(wanted + 12):
            ActionChains(self.browser.driver).send_keys(Keys.TAB).perform()
            # Where the focus is, it shows.
            self.browser.run("const e = document.activeElement; if (e !== document.body &&"
                             "(getComputedStyle(e).outlineStyle !== 'none' || e.matches('.skip'))) reached.add(e)")
        return self.browser.run("return controls.filter((e) => !reached.has(e)).map((e) => e.id || e.textContent)")

    def test_tab_reaches_every_control_and_the_focus_shows(self):
        a, b = self.busiest("planks")
        self.browser.run("replay.choose(...arguments)", a, b)
        self.browser.settle()
        self.assertEqual(self.unreached(), [])
        self.browser.run("document.getElementById('play').tabIndex = -1")
        self.assertEqual(self.unreached(), ["play"], "control: one that Tab leaves out")

    def test_keys_alone_do_everything(self):
        self.slow_down("0.05")
        self.press(Keys.SPACE)
        self.assertTrue(self.browser.run("return replay.playing"))
        self.press(Keys.SPACE)
        self.assertFalse(self.browser.run("return replay.playing"))
        self.press(Keys.HOME, ".", ".", ".", ",")
        self.assertEqual(self.browser.run("return replay.step"), 2)
        self.press("p", Keys.ARROW_DOWN, Keys.ARROW_DOWN, Keys.ENTER)
        chosen = self.browser.run("return replay.chosen")
        self.assertIsNotNone(chosen)
        active = self.browser.run("return document.getElementById('pair-list').getAttribute('aria-activedescendant')")
        self.assertEqual(self.browser.run("return document.getElementById(arguments[0]).getAttribute('aria-selected')", active), "true")
        self.press("]")
        steps = [event[0] for event in self.recordings["planks"]["plugin"].events(*chosen)]
        self.assertEqual(self.browser.run("return replay.step"), min(step for step in steps if step > 2))
        box = self.browser.driver.find_element("id", "show-certificates")
        shown = box.is_selected()
        self.press("4")
        self.assertNotEqual(box.is_selected(), shown)
        scale = self.browser.run("return replay.camera.scale")
        self.press("+")
        self.assertGreater(self.browser.run("return replay.camera.scale"), scale)
        self.press(Keys.ESCAPE)
        self.assertIsNone(self.browser.run("return replay.chosen"))
        self.press("?")
        self.assertTrue(self.browser.run("return document.getElementById('help').open"))
        step = self.browser.run("return replay.step")
        self.press(".")
        self.assertEqual(self.browser.run("return replay.step"), step, "control: a dialog keeps the keys")
        self.press(Keys.ESCAPE)
        self.browser.run("document.getElementById('scene').focus()")
        x = self.browser.run("return replay.camera.x")
        self.press(Keys.ARROW_RIGHT)
        self.assertGreater(self.browser.run("return replay.camera.x"), x)

    def test_names_and_roles(self):
        nameless = """return [...document.querySelectorAll("button, select, input, canvas")].filter((e) =>
            !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.[0]?.textContent.trim())).map((e) => e.id)"""
        self.assertEqual(self.browser.run(nameless), [])
        self.browser.run("document.getElementById('zoom-in').removeAttribute('aria-label');"
                         "document.getElementById('zoom-in').textContent = ''")
        self.assertEqual(self.browser.run(nameless), ["zoom-in"], "control: a button without a name")

    def test_phones_need_no_sideways_scrolling(self):
        a, b = self.busiest("planks")
        self.browser.run("replay.choose(...arguments); document.getElementById('pair-events').open = true", a, b)
        overflow = "return document.documentElement.scrollWidth - window.innerWidth"
        for width in (390, 320):
            self.browser.resize(width, 844, touch=True)
            self.browser.settle()
            self.assertLessEqual(self.browser.run(overflow), 0, f"{width} pixels")
            self.assertGreater(self.browser.run("return document.getElementById('scene').clientWidth"), width - 40)
        self.browser.run("document.querySelector('main').insertAdjacentHTML('beforeend', '<div style=width:600px>control</div>')")
        self.assertGreater(self.browser.run("return document.documentElement.scrollWidth"), 320, "control: something wide")

    def test_dark_and_light_follow_the_system_and_the_switch(self):
        ground = "return getComputedStyle(document.body).backgroundColor + document.getElementById('scene').toDataURL()"
        light = self.browser.run(ground)
        self.browser.prefer(prefers_color_scheme="dark")
        self.browser.settle()
        dark = self.browser.run(ground)
        self.assertFalse(light == dark)
        self.browser.run("const t = document.getElementById('theme'); t.value = 'light'; t.dispatchEvent(new Event('change'))")
        self.browser.settle()
        self.assertTrue(self.browser.run(ground) == light)

    def test_damaged_data_is_said_and_not_shown(self):
        page = self.pages["planks"].read_text()
        at = page.index('id="data">') + 5000
        broken = self.pages["planks"].with_name("broken.html")
        broken.write_text(page[:at] + "AAAA" * 8 + page[at + 32:])
        self.browser.open(broken)
        self.assertTrue(self.browser.wait("!document.getElementById('problem').hidden"))
        self.assertIn("cannot be shown", self.browser.run("return document.getElementById('problem').textContent"))
        self.assertGreater(len(self.browser.errors()), 0)  # and they are no surprise to tearDown


class ReplayCommand(unittest.TestCase):
    def check(self, code, message, *arguments):
        done = testbed("replay", *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertIn(message, done.stderr + done.stdout)

    def test_what_makes_no_sense_is_refused_with_2(self):
        self.check(2, 'the nearest is "planks"', "plancks", "-o", "/dev/null")
        self.check(3, "cannot write", "planks", "-o", "/no/such/directory/page.html")
        self.check(2, "--steps", "planks", "--steps", "0", "-o", "/dev/null")
        self.check(2, "--steps", "planks", "--steps", "1000000", "-o", "/dev/null")
        self.check(2, "--output", "planks")

    def test_quiet_says_nothing(self):
        arguments = ("planks", "--size", "5", "--steps", "2", "-o", "/dev/null")
        self.assertEqual(testbed("replay", *arguments, "--quiet").stdout, "")
        self.assertIn("2 steps", testbed("replay", *arguments).stdout, "control: otherwise it says what it wrote")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
