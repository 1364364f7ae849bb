# SPDX-License-Identifier: MIT
"""Makes Table 1 of the paper and the figures of the pages anew, and compares every number and every byte.

    ./testbed_scenes/run reproduce              all but drifters: a minute
    ./testbed_scenes/run reproduce table-1      the paper's Table 1, beside what is counted here: half a minute
    ./testbed_scenes/run reproduce NAME ...     these alone: table-1, rivals, saturation, figures, planks, any-size, drifters
    --output DIR                                keep what was made in this directory (default: reproduced/)

What it needs is built first: that takes minutes, once. Counts must be the pages' as they are rounded there, and pictures the committed ones
byte for byte (drifters, of many pictures, is left to be looked at). Exit codes: 0 nothing differs; 1 something does; 2 the request makes
no sense; 3 a command failed.
"""
import argparse
import collections
import csv
import math
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
# The pictures of the pages: what makes them, and the committed files.
PICTURES = {
    "figures": ("figures -o {out}", "docs/figures"),
    "planks": ("render planks --step 150 --focus 100 -o {out}/planks.png", "docs"),
    "any-size": ("render any-bag --step 380 --bare -o {out}/any-size.png", "docs"),
    # Then: convert -delay 7 drifters-*.png -layers optimize drifters.gif
    "drifters": ("render drifters --frames 30:240:3 --focus=-7.4,-3.8,14.8,7.6 --certificates --slack --contacts --events --width 640 "
                 "-o {out}/drifters.png", None),
}
# Tables of events, of which each cell lists the counts, ratio by ratio: how the command above them begins in its page.
LISTS = {"rivals": "events line tumble --structures rivals", "saturation": "events orbit spin tumble"}
# Table 1: its two commands, and what the page calls the structures of each.
PARTS = [("events line parabola algebraic orbit --shape ellipse:point", {"triangle": "triangle-levels", "lazy": "point-lazy"}),
         ("events line parabola algebraic orbit rigid-algebraic", {"active cell": "active-cell", "lazy": "lazy"})]
NAMES = ["table-1", *LISTS, *PICTURES]
# The bounds, for mu = sqrt(D/sigma).
BOUNDS = {"log mu": math.log2, "mu": math.sqrt, "mu log mu": lambda x: math.sqrt(x) * math.log2(x), "mu^2": lambda x: x,
          "mu^2 log^2 mu": lambda x: x * math.log2(x) ** 2}
LEGEND = """\
mu is the smaller of n and the square root of D/sigma. Here n is 1024, and D/sigma goes from 8 to 131072.
events  at the least and at the greatest D/sigma, the mean of three motions
x2      how many more events each doubling of D/sigma brings, fitted: a constant where they are O(log mu)
power   the fitted power of D/sigma: O(mu) is 0.5, and O(mu^2) is 1
holds   both powers are at most 0.05 above that of the paper's bound; or the bound is a logarithm, and fits better than a power"""


class Result:
    """How many figures were held against each other, and a line for each that differs."""

    def __init__(self):
        self.cells, self.wrong = 0, []

    def number(self, where, committed, measured):
        """Does the measured number, rounded as the committed text is, say the same? (Half of its last digit, either way.)"""
        self.cells += 1
        decimals = len(committed.partition(".")[2])
        if not abs(measured - float(committed.replace(",", ""))) <= 0.5 * 10**-decimals * (1 + 1e-9):
            self.wrong.append(f"{where}: {committed} in the page, {measured:.{decimals + 1}f} measured")


class Events:
    """What `events` wrote as CSV."""

    def __init__(self, path):
        self.rows = collections.defaultdict(list)
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.rows[row["motion"], row["structure"], float(row["wanted_ratio"])].append(float(row["events"]))
        self.ratios = sorted({key[2] for key in self.rows})

    def means(self, motion, structure):
        runs = [self.rows[motion, structure, ratio] for ratio in self.ratios]
        return [sum(run) / len(run) for run in runs] if all(runs) else []


def pages():
    return [file.read_text() for file in [ROOT / "README.md", ROOT / "core/README.md", *sorted((ROOT / "docs").glob("*.md"))]]


def quoted(beginning):
    """A command of the pages that begins so, in one line; and the page from there on."""
    start = re.compile(r"(`?)boomerang-testbed\s+" + r"[\s\\]+".join(map(re.escape, beginning.split())) + r"(?![\w-])")
    for text in pages():
        found = start.search(text)
        if found: # between back quotes, or a line that goes on behind a backslash
            end = re.compile("`" if found.group(1) else r"(?<!\\)\n").search(text, found.end()).start()
            return " ".join(text[found.start():end].strip("`").replace("\\\n", " ").split()), text[end:]
    raise ValueError(f"no page has the command {beginning}")


def table_in(text):
    """The rows of the first Markdown table, each a list of cells, without the rule below the head."""
    lines = re.search(r"(?:^\|.*\|[^\n]*\n)+", text, flags=re.M).group().splitlines()
    return [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in lines[:1] + lines[2:]]


def slope(x, y):
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def exponent(ratios, means):
    pairs = [(math.log(ratio), math.log(mean)) for ratio, mean in zip(ratios, means) if mean > 0]
    return slope([a for a, _ in pairs], [b for _, b in pairs])


def holds(bound, ratios, means):
    logs, power = [math.log2(ratio) for ratio in ratios], exponent(ratios, means)
    if power <= exponent(ratios, [BOUNDS[bound](ratio) for ratio in ratios]) + 0.05:
        return True
    rise, middle, mean, factor = slope(logs, means), sum(logs) / len(logs), sum(means) / len(means), sum(map(math.log2, means)) / len(means)

    def off(curve):
        return sum((value - mean) ** 2 for value, mean in zip(curve, means))

    return bound == "log mu" and (off([mean + rise * (log - middle) for log in logs]) <=
                                  off([2 ** (factor + power * (log - middle)) for log in logs]))


def compare_growth(cell, where, events, means, result):
    """A cell of the page's table of growth: exponent, events a doubling, the largest share of the square root, and the last count."""
    doublings = [math.log2(ratio) for ratio in events.ratios]
    for pattern, measured in ((r"e ([\d.]+)", exponent(events.ratios, means)), (r"\+([\d.]+)", slope(doublings, means)),
                              (r"([\d.]+) sqrt", max(mean / math.sqrt(ratio) for mean, ratio in zip(means, events.ratios))),
                              (r"\(([\d,.]+)\)", means[-1])):
        found = re.search(pattern, cell)
        if found:
            result.number(where, found.group(1), measured)


def table_1(count, result):
    """The rows of the page's table, printed as the paper has them, with what was counted."""
    runs = [count(beginning) for beginning, _ in PARTS]
    _, rest = quoted(PARTS[0][0])
    line = "{:26} | {:16} {:34} | {:9} {:34} | {}".format
    heads = ["bound", "events            x2   power"]
    printed = ["Table 1 of the paper, and what was counted here:", "", line("motion: structure", *heads, *heads, "holds").rstrip(), "=" * 135]
    part, motion = 0, ""
    for name, *cells in table_in(rest)[1:]:
        part = 1 if "two polygons" in name else part
        found = re.search(r"^(.*?)\(([a-z-]+)[^)]*\): (.*)$", name)
        motion, structure = (found.group(2), found.group(3)) if found else (motion, name.lstrip("- "))
        title = found.group(1).replace("*", "").strip() if found else ""
        if title and title not in printed:
            printed.append(title)
        shown, good = [], []
        for hierarchy, bound, cell in (("compass", *cells[0:2]), ("dudley", *cells[2:4])):
            structure_name = f"{PARTS[part][1][structure]}-{hierarchy}"
            means = runs[part].means(motion, structure_name)
            if not means:
                if cell != "-": # of a structure that there is not
                    result.wrong.append(f"{motion}, {structure_name}: {cell} in the page, nothing measured")
                shown += [f"O({bound})", "-"]
                continue
            compare_growth(cell, f"{motion}, {structure_name}", runs[part], means, result)
            doublings = [math.log2(ratio) for ratio in runs[part].ratios]
            shown += [f"O({bound})", f"{means[0]:6.1f} to {means[-1]:6.1f} {slope(doublings, means):+6.2f}   {exponent(runs[part].ratios, means):5.2f}"]
            good.append(holds(bound, runs[part].ratios, means))
        verdict = "yes" if all(good) else "no"
        if len(cells) > 4 and cells[4] != verdict:
            result.wrong.append(f"{motion}, {structure}: holds is {cells[4]} in the page, {verdict} measured")
        printed.append(line(f"  {motion}: {structure}", *shown, verdict))
    print("\n".join([*printed, "=" * 135, LEGEND]))


def compare_list(name, count, result):
    events, (_, rest) = count(LISTS[name]), quoted(LISTS[name])
    head, *rows = table_in(rest)
    for side, *cells in rows:
        for top, cell in zip(head[1:], cells):
            motion, structure = (top, side.split("`")[1]) if "`" in side else (side, top.split("`")[1])
            means, texts = events.means(motion, structure), cell.split(", ")
            if len(means) != len(texts):
                result.wrong.append(f"{motion}, {structure}: {cell} in the page, {len(means)} counts measured")
            for ratio, text, mean in zip(events.ratios, texts, means):
                result.number(f"{motion}, {structure}, {ratio:g}", text, mean)


def main():
    parser = argparse.ArgumentParser(prog="reproduce", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--build", default=ROOT / "build", help=argparse.SUPPRESS)
    parser.add_argument("--output", default="reproduced", metavar="DIR")
    parser.add_argument("--targets", action="store_true", help=argparse.SUPPRESS) # what has to be built, and no more
    options = parser.parse_args()
    for name in options.names:
        if name not in NAMES:
            parser.exit(2, f"reproduce: there is no {name!r}; there are {', '.join(NAMES)}\n")
    names = options.names or [name for name in NAMES if name != "drifters"]
    if options.targets:
        plays = any(name in PICTURES and PICTURES[name][0].startswith("render") for name in names)
        print("boomerang-testbed", "boomerang-scene boomerang-scene-plugin boomerang-count" if plays else "")
        return 0
    differs = False

    def run(words):
        done = subprocess.run([f"{options.build}/bin/boomerang-testbed", *words], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 1):
            parser.exit(3, f"reproduce: failed ({done.returncode}): {' '.join(words)}\n{done.stderr}")

    for name in names:
        result, out = Result(), pathlib.Path(options.output).resolve() / name
        try:
            out.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            parser.exit(3, f"reproduce: {out} is no folder: {error.strerror}\n")

        def count(beginning):
            run([*quoted(beginning)[0].split()[1:], "--quiet", "--csv", f"{out}/events.csv"])
            return Events(out / "events.csv")

        if name == "table-1":
            table_1(count, result)
        elif name in LISTS:
            compare_list(name, count, result)
        else:
            command, committed = PICTURES[name]
            run([word.format(out=out) for word in command.split()])
            for made in sorted(out.iterdir()) if committed else []:
                result.cells += 1
                if not (ROOT / committed / made.name).exists() or made.read_bytes() != (ROOT / committed / made.name).read_bytes():
                    result.wrong.append(f"{made} is not {committed}/{made.name}")
        differs |= bool(result.wrong)
        verdict = f"{len(result.wrong)} of {result.cells} differ" if result.wrong else f"the same, {result.cells} figures" if result.cells else f"made: {out}"
        print(f"{name:12} {verdict}", *result.wrong, sep="\n    ", flush=True)
    return int(differs)


if __name__ == "__main__":
    sys.exit(main())
