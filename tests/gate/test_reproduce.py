#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_reproduce.py ROOT BUILD WORK: `./testbed_scenes/run reproduce` makes what the pages show, and finds what differs."""
import contextlib
import io
import pathlib
import sys
import unittest

ROOT, BUILD, WORK = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
del sys.argv[1:]
sys.path.insert(0, str(ROOT / "testbed_scenes"))
import reproduce  # noqa: E402

run, counted = reproduce.subprocess.run, {}


def run_once(words, **options):
    """Half a minute of counting is done once: a control then reads the same events beside another page."""
    csv, key = pathlib.Path(words[-1]), tuple(words)
    if key not in counted:
        done = run(words, **options)
        counted[key] = done, csv.read_bytes() if csv.suffix == ".csv" and csv.exists() else None
    done, events = counted[key]
    if events is not None:
        csv.write_bytes(events)
    return done


reproduce.subprocess.run = run_once


def reproduced(*names, changed=None):
    """(exit code, what it said) of `reproduce`; `changed`: a text of the pages, and the one in its place."""
    pages, said, sys.argv = reproduce.pages, io.StringIO(), ["reproduce", "--build", str(BUILD), "--output", str(WORK), *names]
    if changed:
        assert any(changed[0] in text for text in pages()), f"control: no page has {changed[0]}"
        reproduce.pages = lambda: [text.replace(*changed) for text in pages()]
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            try:
                code = reproduce.main()
            except SystemExit as left:
                code = left.code
    finally:
        reproduce.pages = pages
    return code, said.getvalue()


class Reproduced(unittest.TestCase):
    def test_table_1_is_the_page_s(self):
        code, said = reproduced("table-1")
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"table-1 +the same, \d\d+ figures")
        self.assertRegex(said, r"\n  orbit: lazy +\| O\(mu log mu\) +\d+\.\d to +\d+\.\d")
        self.assertLessEqual(max(map(len, said.splitlines())), 140)

    def test_an_output_that_is_no_folder_is_named(self):
        self.assertEqual(reproduced("table-1", "--output", "/dev/null"), (3, "reproduce: /dev/null/table-1 is no folder: Not a directory\n"))

    def test_another_number_of_table_1_is_noticed(self):
        code, said = reproduced("table-1", changed=("| - lazy | log mu | +0.78 (14) |", "| - lazy | log mu | +0.79 (14) |"))
        self.assertEqual((code, said.count("in the page")), (1, 1), said)
        self.assertIn("line, lazy-compass: 0.79 in the page, 0.78", said)

    def test_figures_and_lists_are_the_pages(self):
        for names in (("figures", "planks", "any-size"), ("rivals", "saturation")):
            code, said = reproduced(*names)
            self.assertEqual(code, 0, said)
            self.assertEqual(said.count("the same, "), len(names), said)

    def test_another_count_and_another_picture_are_noticed(self):
        code, said = reproduced("rivals", changed=("| line | 1794, 1917 |", "| line | 1794, 1916 |"))
        self.assertEqual((code, said.count("in the page")), (1, 1), said)
        reproduce.PICTURES["other"] = (reproduce.PICTURES["planks"][0].replace("--step 150", "--step 151"), "docs")
        reproduce.NAMES.append("other")
        code, said = reproduced("other")
        self.assertEqual(code, 1, said)
        self.assertIn("is not docs/planks.png", said)

    def test_rounding_is_the_pages(self):
        result = reproduce.Result()
        for committed, measured in (("9.3", 9.333), ("12", 11.6), ("1,000", 1000), ("0.50", 0.495)):
            result.number("x", committed, measured)
        self.assertEqual((result.wrong, result.cells), ([], 4))
        for committed, measured in (("9.3", 9.36), ("12", 12.6), ("4", 5)):
            result.number("x", committed, measured)
        self.assertEqual(len(result.wrong), 3)

    def test_a_bound_holds_where_the_growth_is_its_own_and_not_where_it_is_faster(self):
        ratios = [8.0 * 4**i for i in range(8)]
        bounds = list(reproduce.BOUNDS) # each grows faster than those before it
        for i, bound in enumerate(bounds):
            for j, growth in enumerate(bounds):
                means = [10 * reproduce.BOUNDS[growth](ratio) for ratio in ratios]
                self.assertEqual(reproduce.holds(bound, ratios, means), j <= i, (bound, growth))

    def test_what_there_is_not_is_refused(self):
        code, said = reproduced("table-7")
        self.assertEqual(code, 2)
        self.assertIn("there is no 'table-7'; there are table-1, ", said)


if __name__ == "__main__":
    unittest.main()
