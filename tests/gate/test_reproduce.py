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
from compare import Result  # noqa: E402

# What makes figures: commands of the testbed, measurements, tests with more iterations than they have in the gate.
FIGURES = re.compile(r"boomerang-testbed (?:events|figures|compare-shapes|compare|world|render|plot)\b|(?:tests/bench/)?measure_\w+\.sh|tests/bench/world_share\.sh"
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
            self.assertEqual(run.result.wrong, [], f"./testbed_scenes/run reproduce --only {name}")
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
