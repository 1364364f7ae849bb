#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_reproduce.py ROOT BUILD WORK: `./testbed_scenes/run reproduce` knows every figure of the pages, and finds what differs."""
import pathlib
import re
import sys
import unittest

ROOT, BUILD, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
del sys.argv[1:]
sys.path.insert(0, str(ROOT / "testbed_scenes/reproduce"))
import catalogue  # noqa: E402
import reproduce  # noqa: E402
from compare import Events, Result, table_after  # noqa: E402
import table1  # noqa: E402

# What makes figures: commands of the testbed, measurements, tests with more iterations than they have in the gate.
FIGURES = re.compile(r"boomerang-testbed (?:events|figures|compare|world|render)\b|tests/bench/\w+\.sh"
                     r"|BMR_TEST_SCALE=\d+ test_\w+|build/bin/test_\w+")


def commands(page):
    """Every command of a page that makes figures: code in a line, and lines of fenced blocks, without comments."""
    fenced = "\n".join(re.findall(r"^```sh\n(.*?)^```", page, flags=re.S | re.M)).replace("\\\n", " ")
    inline = re.findall(r"`([^`]+)`", re.sub(r"^```.*?^```", "", page, flags=re.S | re.M))
    for code in [re.sub(r"\s#.*", "", line) for line in fenced.splitlines()] + inline:
        if FIGURES.match(reproduce.normal(code)):
            yield reproduce.normal(code)


def missing(pages):
    """(commands, pictures) of the pages that the catalogue does not know"""
    known = {reproduce.normal(quote) for experiment in catalogue.EXPERIMENTS for quote in experiment.quotes} | set(catalogue.USAGE)
    made = {file for experiment in catalogue.EXPERIMENTS for file in experiment.makes} | set(catalogue.BY_HAND)
    shown = {(ROOT / name).parent / file for name, text in pages.items() for file in re.findall(r"!\[[^\]]*\]\(([^)\s]+)\)", text)}
    return ({command for text in pages.values() for command in commands(text)} - known,
            {str(file.resolve().relative_to(ROOT)) for file in shown} - made)


class Catalogue(unittest.TestCase):
    def test_every_command_and_picture_of_the_pages_is_known(self):
        unknown, pictures = missing(reproduce.pages())
        self.assertEqual(unknown, set(), "for testbed_scenes/reproduce/catalogue.py")
        self.assertEqual(pictures, set(), "for testbed_scenes/reproduce/catalogue.py")

    def test_every_quotation_is_in_a_page(self):
        pages = " ".join(reproduce.normal(text) for text in reproduce.pages().values())
        for experiment in catalogue.EXPERIMENTS:
            for quote in experiment.quotes:
                self.assertTrue(reproduce.normal(quote) in pages, f"no page has: {quote}; see testbed_scenes/reproduce/catalogue.py")

    def test_control_a_new_figure_is_missed(self):
        page = {"docs/new.md": "`boomerang-testbed events spin --n 7` and\n```sh\ntests/bench/measure_costs.sh build new  # words\n```\n![x](figures/new.svg)"}
        self.assertEqual(missing(page), ({"boomerang-testbed events spin --n 7", "tests/bench/measure_costs.sh build new"}, {"docs/figures/new.svg"}))

    def test_names_are_one_each(self):
        names = [experiment.name for experiment in catalogue.EXPERIMENTS]
        self.assertEqual(len(names), len(set(names)))


class Built(unittest.TestCase):
    def test_an_experiment_has_built_what_it_runs_and_no_more(self):
        def targets(*names):
            return reproduce.targets([experiment for experiment in catalogue.EXPERIMENTS if experiment.name in names])

        workers = {"boomerang-scene", "boomerang-scene-plugin", "boomerang-count"}
        self.assertEqual(targets("growth", "growth-points", "figures"), {"boomerang-testbed"})
        self.assertEqual(targets("planks"), {"boomerang-testbed"} | workers)
        self.assertEqual(targets("event-cost"), {"test_claims_time"})
        self.assertEqual(targets("cost-calls"), {"boomerang-testbed", "bench_worlds"} | workers)


class TableOne(unittest.TestCase):
    """Growth is the experiments' to count: these events are made up, a power of D/sigma for each structure."""

    def runs(self):
        found = {}
        for _, name, structures, rows in table1.PARTS:
            found[name] = Events.__new__(Events)
            found[name].ratios = [8.0, 32.0, 128.0]
            found[name].rows = {(motion, f"{structure}-{hierarchy}", ratio): [{"events": ratio**0.5}] for *_, ours in rows for motion in ours
                                for structure in structures for hierarchy in ("compass", "dudley") for ratio in found[name].ratios}
        return found

    def test_it_has_the_bounds_and_the_motions_of_the_page(self):
        page = [row for row in table_after(reproduce.pages()["core/README.md"], catalogue.GROWTH_OF_A_POINT.split("--")[-1])[1:] if "log" in row[1] or "mu" in row[1]]
        self.assertEqual(len(page), len(catalogue.POINT_ROWS + catalogue.POLYGON_ROWS))
        mine = [(our, structure, compass, dudley) for _, _, structures, rows in table1.PARTS for _, compass, dudley, ours in rows
                for our in ours for structure in structures]
        theirs = [(motion, structure, f"O({row[1]})", f"O({row[3]})") for (motion, structure), row in zip(catalogue.POINT_ROWS + catalogue.POLYGON_ROWS, page)]
        self.assertEqual(set(theirs) - set(mine), set())

    def test_it_prints_the_rows_of_the_paper_and_ours_below(self):
        text = table1.table(self.runs()).splitlines()
        for words in ("One point, one polygon", "convex .*O\\(log mu\\) .*O\\(log mu\\)", "rigid motion .*O\\(mu\\^2 log\\^2 mu\\) .*O\\(mu\\^2\\)",
                      "  orbit: lazy .* 2.8 to +11.3 +\\+2.12 +0.50 +yes",
                      "  line: lazy .* no"):
            self.assertTrue(any(re.match(words, line.replace("|", " ")) for line in text), words + " is not in\n" + "\n".join(text))
        self.assertLessEqual(max(map(len, text)), 140)
        part = self.runs()
        del part["growth"]
        self.assertNotIn("Two polygons", table1.table(part))


class Compared(unittest.TestCase):
    def test_rounding_is_the_pages(self):
        result = Result()
        for committed, measured in (("9.3", 9.333), ("12", 11.6), ("1,000", 1000), ("0.50", 0.495)):
            result.number("x", committed, measured)
        self.assertEqual((result.wrong, result.cells), ([], 4))
        for committed, measured in (("9.3", 9.36), ("12", 12.6), ("4", 5)):
            result.number("x", committed, measured)
        self.assertEqual(len(result.wrong), 3)

    def test_figures_and_tables_are_those_of_the_pages_and_another_number_is_noticed(self):
        by_name = {experiment.name: experiment for experiment in catalogue.EXPERIMENTS}
        for name in ("figures", "saturation", "rivals"):
            run = reproduce.take(by_name[name], BUILD, WORK)
            self.assertIsNotNone(run, name)
            self.assertEqual(run.result.wrong, [], f"./testbed_scenes/run reproduce {name}")
            self.assertGreater(run.result.cells, 10)
        # The control: the same runs beside a page in which one number is another, and one picture.
        true = reproduce.pages()
        try:
            reproduce.pages = lambda: {name: text.replace("| line | 1794, 1917 |", "| line | 1794, 1916 |") for name, text in true.items()}
            wrong = reproduce.Run(WORK / "rivals")
            by_name["rivals"].check(wrong)
            self.assertEqual(len(wrong.result.wrong), 1)
        finally:
            reproduce.pages = lambda: true
        (WORK / "figures/window.svg").write_text("another")
        wrong = reproduce.Run(WORK / "figures")
        by_name["figures"].check(wrong)
        self.assertEqual(len(wrong.result.wrong), 1)


if __name__ == "__main__":
    unittest.main()
