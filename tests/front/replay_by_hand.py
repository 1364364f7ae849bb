# SPDX-License-Identifier: MIT
"""What a hand does with the page of a replay: fit, choose, hover, link, save. Mixed into ReplayPage of test_replay_page.py."""

import base64
import json
import pathlib

from selenium.webdriver.common.action_chains import ActionChains

PIXELS = """
    const scene = document.getElementById("scene"), canvas = document.createElement("canvas");
    canvas.width = scene.width;
    canvas.height = scene.height;
    const g = canvas.getContext("2d", { willReadFrequently: true });
    g.drawImage(scene, 0, 0);
    const data = g.getImageData(0, 0, canvas.width, canvas.height).data, ground = data.slice(0, 3);
    let strong = 0;
    for (let i = 0; i < data.length; i += 4)
      if (Math.abs(data[i] - ground[0]) + Math.abs(data[i + 1] - ground[1]) + Math.abs(data[i + 2] - ground[2]) > 250) ++strong;
    return strong;"""
NUMBERS = """
    const texts = [], real = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, ...rest) {
      if (this.canvas.id === "scene") texts.push(text);
      return real.call(this, text, ...rest);
    };
    const done = arguments[0];
    replay.seek(replay.step);
    requestAnimationFrame(() => requestAnimationFrame(() => {
      CanvasRenderingContext2D.prototype.fillText = real;
      done(texts);
    }));"""


class ByHand:
    def places(self):
        """{body: its middle in the view}"""
        return {int(body): place for body, place in json.loads(self.browser.run(
            "return JSON.stringify(Object.fromEntries(replay.bodies().map((b) => [b.number, replay.placeOf(b.number)])))")).items()}

    def point_at(self, x, y):
        canvas = self.browser.driver.find_element("id", "scene")
        size = canvas.rect
        return ActionChains(self.browser.driver).move_to_element_with_offset(
            canvas, round(x - size["width"] / 2), round(y - size["height"] / 2))

    def outside(self):
        width, height = self.browser.run("const c = document.getElementById('scene'); return [c.clientWidth, c.clientHeight]")
        return [body for body, (x, y) in self.places().items() if not (0 < x < width and 0 < y < height)]

    def free_body(self):
        """A body that moves, alone where it is: its middle, seen from near."""
        frame = self.recordings["planks"]["plugin"].frames[60]
        moving = [body["number"] for body in frame["bodies"] if body["type"] == "dynamic"]
        self.browser.run("replay.seek(60); replay.chooseBody(arguments[0])", moving[0])
        self.browser.driver.find_element("id", "pair-zoom").click()
        self.browser.run("replay.choose(-1, -1)")
        self.browser.settle()
        return moving[0], self.places()[moving[0]]

    def test_fit_shows_all_bodies(self):
        for name, steps in (("planks", (0, 45, 89)), ("rocks", (0, 60, 119))):
            self.show(name)
            for step in steps:
                self.seek(step)
                self.browser.driver.find_element("id", "zoom-in").click()
                self.browser.driver.find_element("id", "zoom-in").click()
                self.browser.settle()
                self.assertNotEqual(self.outside(), [], "control: from near, some are outside")
                self.browser.driver.find_element("id", "zoom-fit").click()
                self.browser.settle()
                self.assertEqual(self.outside(), [], f"{name}, step {step}")

    def test_a_chosen_pair_is_lit_and_nothing_moves(self):
        a, b = self.busiest("planks")
        where = "const c = document.getElementById('scene').getBoundingClientRect(); return [c.x, c.y, c.width, c.height, replay.camera]"
        before, strong = self.browser.run(where), self.browser.run(PIXELS)
        self.assertGreater(strong, 1000, "control: there is something to dim")
        self.browser.run("replay.choose(...arguments)", a, b)
        self.browser.settle()
        self.assertEqual(self.browser.run(where), before)
        lit = self.browser.run(PIXELS)
        self.assertLess(lit, strong / 2)
        self.assertGreater(lit, 0, "the pair is not dimmed")
        self.browser.run("replay.choose(-1, -1)")
        self.browser.settle()
        self.assertEqual(self.browser.run(PIXELS), strong)

    def test_a_click_in_a_body_chooses_it_and_hovering_names_it(self):
        body, place = self.free_body()
        hover = "const h = document.getElementById('hover'); return h.hidden ? '' : h.textContent"
        self.point_at(*place).perform()
        self.assertRegex(self.browser.run(hover), f"^Body {body}: dynamic, [0-9]+ pair")
        self.point_at(3, 120).perform()
        self.assertNotIn(f"Body {body}:", self.browser.run(hover), "control: elsewhere it says something else")
        self.point_at(*place).click().perform()
        self.browser.settle()
        self.assertEqual(self.browser.run("return replay.chosen"), body)
        self.assertEqual(self.browser.driver.find_element("id", "pair-title").text, f"Body {body}")
        rows = self.browser.run("return [...document.querySelectorAll('#pair-list li')].map((row) => row.firstChild.textContent)")
        self.assertTrue(rows and all(str(body) in row.split(" – ") for row in rows), rows)
        self.browser.driver.find_element("id", "pair-drop").click()
        self.assertGreater(self.browser.run("return document.querySelectorAll('#pair-list li').length"), len(rows))

    def test_each_body_has_its_number_once(self):
        a, b = self.busiest("planks")
        self.browser.driver.find_element("id", "show-numbers").click()
        there = sorted(str(body) for body in self.places())
        for chosen in ("replay.choose(-1, -1)", f"replay.choose({a}, {b})", f"replay.chooseBody({a})"):
            self.browser.run(chosen)
            self.browser.settle()
            self.assertEqual(sorted(self.browser.driver.execute_async_script(NUMBERS)), there, chosen)

    def test_the_address_has_the_state(self):
        a, b = self.busiest("planks")
        self.browser.run("replay.seek(33); replay.choose(...arguments); document.getElementById('show-boxes').click()", a, b)
        self.browser.driver.find_element("id", "zoom-in").click()
        self.assertTrue(self.browser.wait("location.hash.includes('view=')", 20))
        state = "return [replay.step, replay.chosen, document.getElementById('show-boxes').checked, replay.camera]"
        address, shown = self.browser.run("return location.href"), self.browser.run(state)
        self.assertEqual(shown[:3], [33, [min(a, b), max(a, b)], True])
        self.show("planks")
        self.assertNotEqual(self.browser.run(state)[:3], shown[:3], "control: without it the page begins anew")
        self.browser.driver.get("about:blank")
        self.browser.driver.get(address)
        self.assertTrue(self.browser.wait("document.documentElement.dataset.ready === 'yes'"))
        self.browser.settle()
        again = self.browser.run(state)
        self.assertEqual(again[:3], shown[:3])
        for key, value in shown[3].items():
            self.assertAlmostEqual(again[3][key], value, delta=1e-4 * abs(value))
        self.browser.run("location.hash = 'step=1e9&pair=x,&body=-4&view=1,2,no&show=,,&theme=pink'")
        self.browser.settle()
        self.assertEqual(self.browser.run("return [replay.step, replay.chosen]"), [89, None], "nonsense does no harm")

    def test_ones_own_pair_is_shown_event_by_event(self):
        folder = pathlib.Path(self.scratch.name)
        square, motion, trace = folder / "square.txt", folder / "motion.txt", folder / "trace.txt"
        square.write_text("1 1\n-1 1\n-1 -1\n1 -1\n0 1.4\n")
        motion.write_text("time 0 2\nbody A\nscrew 0 0 0 0 0 0 2\nbody B\nscrew 0 -6 2.5 0 6 0 -3\n")
        self.pages["pair"] = folder / "pair.html"
        own = ("--polygon", str(square), "--motion", str(motion))
        for arguments in (("replay", *own, "--structure", "lazy-dudley", "-o", str(self.pages["pair"])),
                          ("events", *own, "--structures", "lazy-dudley", "--quiet", "--trace", str(trace))):
            done = self.run_testbed(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.show("pair")
        self.assertEqual(self.browser.run("return replay.chosen"), [0, 1])
        shown = [event["kind"] for event in self.browser.run("return replay.pair(0, 1).events")]
        # motion structure D/sigma seed time kind …
        counted = [line.split()[5] for line in trace.read_text().splitlines() if not line.startswith("#")]
        self.assertEqual(shown, counted)
        self.assertGreater(len(set(shown)), 2, "control: several kinds of events")
        self.seek(150)
        picture = "return document.getElementById('scene').toDataURL()"
        before = self.browser.run(picture)
        self.assertRegex(self.browser.run("return document.getElementById('pair-now').textContent"), "envelope of level|In contact")
        self.seek(151)
        self.assertFalse(self.browser.run(picture) == before, "it moves")

    def test_the_view_is_saved_as_a_png(self):
        name, picture = self.browser.driver.execute_async_script("""
            const done = arguments[0], click = HTMLAnchorElement.prototype.click;
            HTMLAnchorElement.prototype.click = async function () {
              HTMLAnchorElement.prototype.click = click;
              const reader = new FileReader();
              reader.onload = () => done([this.download, reader.result.split(",")[1]]);
              reader.readAsDataURL(await (await fetch(this.href)).blob());
            };
            document.getElementById("save").click();""")
        self.assertEqual(name, "planks-step-0.png")
        png = base64.b64decode(picture)
        self.assertEqual(png[:8], b"\x89PNG\r\n\x1a\n")
        size = self.browser.run("const c = document.getElementById('scene'); return [c.width, c.height]")
        self.assertEqual([int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")], size)
