#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The playground's page in a browser, on a desktop's and on a phone's size.

    test_playground_page.py PAGE [unittest's options]

What it draws and counts is tested without a browser (claims/test_playground.c). Here: that it starts from a file and asks nobody, that
hands and keys reach it, that it can be read and heard, that nothing lies on anything else.
"""

import pathlib
import sys
import unittest

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

from browser import Browser

PAGE = pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else pathlib.Path("playground.html")
MOST_BYTES = 700_000
MODES = ["learn", "hands", "motions", "mixed", "many"]
SIZES = [(1400, 900, False), (390, 844, True)]
LEAST_CONTRAST = 4.5

# Of all texts that are seen: the least ratio of contrast with what is behind them, and where.
CONTRAST = """
const channel = (c) => (c /= 255) <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
const luminance = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
const numbers = (text) => text.match(/[\\d.]+/g).map(Number);
let least = [99, ""];
for (const node of document.querySelectorAll("body *")) {
  const own = [...node.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim() !== "");
  if (!own || node.closest("script, style, dialog:not([open]), .unseen, .skip") || node.disabled || !node.checkVisibility()) continue;
  let behind = node;
  while (behind && (numbers(getComputedStyle(behind).backgroundColor)[3] ?? 1) === 0) behind = behind.parentElement;
  const [a, b] = [numbers(getComputedStyle(node).color), behind ? numbers(getComputedStyle(behind).backgroundColor) : [255, 255, 255]].map(luminance);
  const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  if (ratio < least[0]) least = [ratio, `${node.tagName} ${node.id} ${node.textContent.trim().slice(0, 30)}`];
}
return least;"""

# Controls that lie on each other, texts that are cut, and a page that is wider than its window. Handles lie on bodies.
LAYOUT = """
const found = [], shown = (n) => n.checkVisibility({ visibilityProperty: true });
const open = document.querySelector("dialog[open]");
const parts = [...(open || document).querySelectorAll("button, select, input, summary, .readout, .badges li, p, h1, h2, .ladder span, .legend li")]
  .filter((n) => shown(n) && !n.closest(".unseen") && !n.matches(".handle.move, .skip, .unseen") && (open || !n.closest("dialog")));
const boxes = parts.map((n) => n.getBoundingClientRect());
const name = (n) => `${n.tagName}#${n.id}.${n.className} ${n.textContent.trim().slice(0, 20)}`;
for (let i = 0; i < parts.length; i++) {
  if (parts[i].scrollWidth > parts[i].clientWidth + 1 && parts[i].clientWidth > 0 && !parts[i].matches("input, select")) found.push("cut: " + name(parts[i]));
  for (let j = i + 1; j < parts.length; j++) {
    if (parts[i].contains(parts[j]) || parts[j].contains(parts[i])) continue;
    const a = boxes[i], b = boxes[j];
    if (Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1)
      found.push(name(parts[i]) + " on " + name(parts[j]));
  }
}
if (document.documentElement.scrollWidth > window.innerWidth) found.push("wider than the window");
return found;"""

# What can be reached with Tab and has no name that is read aloud.
NAMELESS = """
return [...document.querySelectorAll("button, select, input, summary, [tabindex]")].filter((n) => n.checkVisibility())
  .filter((n) => !(n.getAttribute("aria-label") || n.labels?.[0]?.textContent.trim() || n.textContent.trim())).map((n) => n.outerHTML);"""


class PlaygroundPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()

    def setUp(self):
        self.browser.resize(1400, 900)
        self.browser.prefer(prefers_color_scheme="light", prefers_reduced_motion="no-preference")

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [], "the console")

    def show(self, place="mode=hands"):
        self.browser.driver.get("about:blank")
        self.browser.driver.get(f"file://{PAGE}#{place}")
        self.assertTrue(self.browser.wait("document.documentElement.dataset.ready === 'yes'"),
                        self.browser.run("return document.getElementById('problem').textContent"))
        self.browser.settle()

    def at(self, body):
        return self.browser.run("const p = playground.core.place(arguments[0]); return [p.x, p.y, p.angle]", body)

    def events(self, follower=0):
        return self.browser.run("return playground.panels.sum(arguments[0], 'events')", follower)

    def press(self, *keys):
        ActionChains(self.browser.driver).send_keys(*keys).perform()
        self.browser.settle()

    def element(self, name):
        return self.browser.driver.find_element("id", name)

    def test_it_is_one_small_file_that_asks_nobody(self):
        self.assertLessEqual(PAGE.stat().st_size, MOST_BYTES)
        self.show("mode=learn")
        fetched = "return performance.getEntriesByType('resource').map((e) => e.name).filter((n) => !/^(data|blob):/.test(n))"
        self.assertEqual(self.browser.run(fetched), [])
        # Control: it may not even if it wanted to.
        self.browser.run("new Image().src = 'http://127.0.0.1:9/'")
        self.browser.settle()
        self.assertTrue(any("Content Security Policy" in error for error in self.browser.errors()))

    def test_it_says_under_which_license_it_is(self):
        self.show()
        footer = self.browser.driver.find_element("css selector", "footer").text
        self.assertIn("GNU General Public License, version 3 or later", footer)
        self.element("licenses-open").click()
        texts = self.browser.run("return document.getElementById('licenses').textContent")
        for part in ("END OF TERMS AND CONDITIONS", "Permission is hereby granted", "apt-get source gsl", "without any warranty"):
            self.assertIn(part, texts)

    def test_a_stab_and_a_roll_are_seen_in_the_first_minute(self):
        # By the page's own time: so many frames of a sixtieth of a second.
        self.show("mode=learn")
        frames = self.browser.run("""
            const page = playground, kinds = [];
            page.begin(true);
            for (let frame = 0; frame < 3600; frame++) {
              page.step(1 / 60);
              page.draw();
              page.write_words();
              const said = document.getElementById("happened").textContent.split(".")[0];
              if (!kinds.some((k) => k[0] === said)) kinds.push([said, frame / 60]);
            }
            return kinds;""")
        when = dict(frames)
        self.assertIn("Stab", when)
        self.assertIn("Roll", when)
        self.assertIn("Push", when)
        print(f"first seen, seconds after the start: {frames}", file=sys.stderr)

    def test_it_plays_and_pauses_by_itself_and_by_keys(self):
        self.show("mode=learn")
        self.assertTrue(self.browser.wait("playground.core.call('time') > 0.2"))
        self.press("p")
        time = self.browser.run("return playground.core.call('time')")
        self.browser.settle()
        self.assertEqual(self.browser.run("return playground.core.call('time')"), time)
        self.press("n")
        self.assertEqual(self.browser.run("return document.getElementById('happened').textContent").split(".")[0], "Push")
        for key, mode in zip("12345", MODES):
            self.press(key)
            self.assertEqual(self.browser.run("return playground.place.mode"), mode)
            self.assertIn(f"mode={mode}", self.browser.run("return location.hash"))

    def test_whoever_wants_no_motion_has_none(self):
        self.browser.prefer(prefers_reduced_motion="reduce", prefers_color_scheme="light")
        for mode in ("learn", "motions", "many"):
            self.show(f"mode={mode}")
            self.assertFalse(self.browser.run("return playground.playing"), mode)
        self.show("mode=learn")
        self.element("next-event").click()
        self.browser.settle()
        self.assertEqual(self.events(), 1)

    def test_a_body_is_kicked_by_a_click_and_by_a_key(self):
        energy = "return playground.core.say(3).match(/Energy: ([0-9.]+)/)[1]"
        self.show("mode=many")
        self.assertEqual(self.browser.run(energy), "1.0000000000")
        self.press("k")
        kicked = self.browser.run(energy)
        self.assertNotEqual(kicked, "1.0000000000")
        ActionChains(self.browser.driver).move_to_element(self.element("scene")).click().perform()
        self.assertNotEqual(self.browser.run(energy), kicked)

    def test_hands_move_and_turn(self):
        self.show()
        x, y, angle = self.at(1)
        ActionChains(self.browser.driver).click_and_hold(self.element("move-b")).move_by_offset(-60, 30).move_by_offset(-60, 20) \
            .release().perform()
        self.browser.settle()
        moved = self.at(1)
        self.assertLess(moved[0], x - 0.3)
        self.assertLess(moved[1], y - 0.1)
        self.assertAlmostEqual(moved[2], angle, places=9)
        ActionChains(self.browser.driver).click_and_hold(self.element("turn-b")).move_by_offset(0, -60).release().perform()
        self.browser.settle()
        self.assertGreater(abs(self.at(1)[2] - angle), 0.1)
        for body in (0, 1):  # what is where the address says it is
            place = self.browser.run("return playground.place.poses[arguments[0]]", body)
            self.assertEqual([round(c, 6) for c in place], [round(c, 6) for c in self.at(body)])

    def test_keys_move_and_turn_and_what_follows_is_said(self):
        self.show("mode=hands&poses=0_0_0_1.9_0_0")
        self.browser.run("document.getElementById('move-b').focus()")
        before = self.at(1)
        self.press(Keys.ARROW_LEFT, Keys.ARROW_UP)
        self.assertAlmostEqual(self.at(1)[0], before[0] - 0.05, places=9)
        self.assertAlmostEqual(self.at(1)[1], before[1] + 0.05, places=9)
        self.press(*["]"] * 40)
        self.assertLess(self.at(1)[2], before[2] - 1)
        self.assertGreater(self.events(), 0)
        self.assertTrue(self.browser.wait("/events?: .*Rivals/.test(document.getElementById('status').textContent)"))
        label = self.element("move-b").get_attribute("aria-label")
        self.assertIn(f"at {self.at(1)[0]:.2f}", label)
        self.press(Keys.TAB)  # on to B's knob
        self.assertEqual(self.browser.run("return document.activeElement.id"), "turn-b")
        angle = self.at(1)[2]
        self.press(Keys.ARROW_RIGHT)
        self.assertNotEqual(self.at(1)[2], angle)

    def test_x_moves_through_the_cells(self):
        self.show("mode=mixed")
        self.browser.run("document.getElementById('move-x').focus()")
        self.press(*["["] * 60)
        self.assertGreater(self.browser.run("return playground.core.call('events', 0, playground.core.kinds.find((k) => k.name === 'page-turn').kind)"), 0)
        self.show("mode=mixed")
        self.browser.run("document.getElementById('move-x').focus()")
        self.press(*[Keys.ARROW_RIGHT] * 30)
        self.assertGreater(self.events(), 0)
        self.assertGreater(self.browser.colours("#mixed"), 6)

    def test_a_shape_is_drawn_and_a_bad_one_is_refused(self):
        self.show()
        self.browser.run("document.getElementById('drawer').open = true")
        self.element("draw-b").click()
        scene = self.element("scene")
        for x, y in ((-80, -60), (60, -70), (90, 60), (-20, 90), (0, 0)):
            ActionChains(self.browser.driver).move_to_element_with_offset(scene, x, y).click().perform()
        self.element("draw-done").click()
        self.browser.settle()
        self.assertEqual(self.browser.run("return playground.core.place(1).corners"), 4)  # the hull of the five
        address = self.browser.run("return location.hash")
        self.show(address.lstrip("#"))
        self.assertEqual(self.browser.run("return playground.core.place(1).corners"), 4)
        self.browser.run("document.getElementById('drawer').open = true")
        self.element("corners").send_keys("0 0, 1 0, 2 0")
        self.element("type-a").click()
        self.assertIn("at least three points", self.element("problem").text)
        self.element("corners").clear()
        self.element("corners").send_keys("-1 0, 1 -0.4, 0.6 0.9")
        self.element("type-a").click()
        self.assertFalse(self.element("problem").is_displayed())
        self.assertEqual(self.browser.run("return playground.core.place(0).corners"), 3)

    def test_an_address_says_what_is_chosen_and_nonsense_in_it_is_left_out(self):
        self.show("mode=motions&family=spin&ratio=10&n=48&ngon=lens&seed=7&structure=free-fd2&levels=all")
        place = self.browser.run("return playground.place")
        self.assertEqual([place[k] for k in ("family", "ratio", "n", "ngon", "seed", "structure", "levels")],
                         ["spin", 10, 48, "lens", 7, "free-fd2", "all"])
        first = self.browser.run("return playground.panels.sum(0, 'events_in_all')")
        self.show(self.browser.run("return location.hash").lstrip("#"))
        self.assertEqual(self.browser.run("return playground.panels.sum(0, 'events_in_all')"), first)
        self.show("mode=nowhere&structure=nothing&n=-3&ratio=1e9&poses=a_b&a=p0_0~1&b=*&seed=<script>&shown=99")
        self.assertEqual(self.browser.run("return [playground.place.mode, playground.place.structure, playground.place.n]"), ["learn", "lazy-dudley", 32])

    def test_events_are_counted_at_twenty_ratios_while_the_motion_plays_on(self):
        self.show("mode=motions&family=orbit&n=64&ratio=7")
        before = self.browser.run("return [0, 1, 2, 3].map((f) => playground.panels.sum(f, 'events_in_all'))")
        self.element("grow").click()
        self.assertTrue(self.browser.wait("playground.growth.counts.length === 20"))
        counts = dict(self.browser.run("return playground.growth.counts"))
        self.assertEqual(counts[7], before, "of the ratio that plays, the same")
        self.assertEqual(self.browser.run("return [0, 1, 2, 3].map((f) => playground.panels.sum(f, 'events_in_all'))"), before)
        self.assertGreater(counts[20][0], counts[1][0])
        self.browser.run("document.getElementById('growth').scrollIntoView()")
        self.browser.settle()
        self.assertGreater(self.browser.colours("#growth"), 8)
        self.assertTrue(self.browser.wait("/at 1,048,576/.test(document.getElementById('growth-words').textContent)"))
        self.assertEqual(self.browser.run(LAYOUT), [])
        self.browser.run("playground.place.family = 'spin'; playground.changed(true)")
        self.assertEqual(self.browser.run("return playground.growth.counts.length"), 0)

    def test_every_motion_and_structure_plays(self):
        self.show("mode=motions&n=16")
        failed = self.browser.run("""
            const { core } = playground, failed = [];
            for (const family of core.families)
              for (const structure of core.structures.filter((s) => s.offered)) {
                Object.assign(playground.place, { family, structure: structure.name });
                playground.begin(false);
                playground.seek(1);
                if (!document.getElementById("problem").hidden || !(playground.panels.sum(1, "events_in_all") > 0)) failed.push(`${family} ${structure.name}`);
              }
            return failed;""")
        self.assertEqual(failed, [])

    def test_nothing_lies_on_anything_else(self):
        for width, height, touch in SIZES:
            self.browser.resize(width, height, touch)
            for mode in MODES:
                self.show(f"mode={mode}")
                self.assertEqual(self.browser.run(LAYOUT), [], f"{mode} at {width}")
            for button in ("help-open", "licenses-open"):
                self.show()
                self.browser.run("document.getElementById(arguments[0]).click()", button)
                self.assertEqual(self.browser.run(LAYOUT), [], f"{button} at {width}")
            self.show()
            self.browser.run("document.getElementById('drawer').open = true; document.getElementById('draw-a').click()")
            self.assertEqual(self.browser.run(LAYOUT), [], f"drawing at {width}")
        # Control: something that does is found.
        self.browser.run("document.getElementById('intro').style.marginBottom = '-3rem'")
        self.assertNotEqual(self.browser.run(LAYOUT), [])

    def test_all_can_be_read_and_has_a_name(self):
        for scheme in ("light", "dark"):
            self.browser.prefer(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            for mode in MODES:
                self.show(f"mode={mode}")
                if mode in ("learn", "motions"):
                    self.element("next-event").click()
                    self.browser.settle()
                ratio, where = self.browser.run(CONTRAST)
                self.assertGreaterEqual(ratio, LEAST_CONTRAST, f"{scheme}, {mode}: {where}")
                self.assertEqual(self.browser.run(NAMELESS), [], mode)
        self.browser.run("document.getElementById('intro').style.color = '#777'")
        self.assertLess(self.browser.run(CONTRAST)[0], LEAST_CONTRAST, "control")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]], verbosity=2)
