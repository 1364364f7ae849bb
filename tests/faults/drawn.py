#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws sites of faults by a seed, and finds them again by what stands there, also when the code around them is another.

    drawn.py [--root DIR] SEED COUNT      COUNT sites of core, box2d_glue and plugin, as lines of sites.txt
    drawn.py --all FILE                   all sites of one file
    drawn.py [--root DIR] --gone FILE     the lines of FILE that stand nowhere

A line: file @ line @ line with the fault [@ who notices, or why nobody can]. `file#2` is the second of equal lines. What goes over several
lines of the file stands in one.

Every folder has its share by its lines of code; in a folder the operators take turns, so that those with few sites come up as often as
those with many. A larger sample begins with the smaller one. A site may change nothing that can be told:
`run --sites` says so where the object code is the same.
"""
import argparse
import collections
import random
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import sites  # noqa: E402

SUBJECTS = [("core", (".c", ".h")), ("box2d_glue", (".cpp", ".h")), ("plugin", (".cpp", ".h"))]


def read_sources(root):
    """{path below root: text} of everything that is made wrong."""
    paths = sorted(p for folder, ends in SUBJECTS for p in (root / folder).rglob("*") if p.suffix in ends)
    return {str(p.relative_to(root)): p.read_text() for p in paths if "examples" not in p.parts}


def places_of(line, text):
    """Where a line stands in a text, also broken into several: (start, end) of each."""
    pattern = r"\s+".join(re.escape(word) for word in line.split())
    return [m.span(1) for m in re.finditer(rf"(?m)^[ \t]*({pattern})[ \t]*$", text)]


def describe(site, text):
    """The site as a line of sites.txt; None where its lines cannot stand in one."""
    made = sites.apply(site, text)
    first, last = text.rfind("\n", 0, site.start) + 1, text.find("\n", site.end)
    before, after = text[first:last], made[first:last + len(made) - len(text)]
    if "@" in before or re.search(r"//.*\n|\\\n|(?m:^)\s*#", before):
        return None
    before, after = (" ".join(part.split()) or ";" for part in (before, after))
    number = [start <= site.start < end for start, end in places_of(before, text)].index(True) + 1
    return f"{site.file}{f'#{number}' if number > 1 else ''} @ {before} @ {after}"


def read(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


def find(root, line):
    """(file, its text with the fault) of a line of sites.txt; None where that is gone."""
    file, before, after = line.split(" @ ")[:3]
    file, _, number = file.partition("#")
    path = Path(root) / file
    text = path.read_text() if path.is_file() else ""
    places = places_of(before, text)
    if len(places) < int(number or 1):
        return None
    start, end = places[int(number or 1) - 1]
    # Lines stay where they are.
    return file, text[:start] + after + "\n" * text.count("\n", start, end) + text[end:]


def draw(sources, seed, count):
    lines, by_folder = collections.Counter(), collections.defaultdict(lambda: collections.defaultdict(list))
    for path, text in sources.items():
        folder = path.rpartition("/")[0]
        lines[folder] += sites.lines_of_code(text)
        for site in sites.sites_of(path, text):
            by_folder[folder][site.operator].append(site)
    turns = {}
    for folder, by_operator in by_folder.items():
        chance = random.Random(f"{seed} {folder}")
        operators = sorted(by_operator)
        chance.shuffle(operators)
        for operator in operators:
            chance.shuffle(by_operator[operator])
        longest = max(map(len, by_operator.values()))
        turns[folder] = [by_operator[o][k] for k in range(longest) for o in operators if k < len(by_operator[o])]
    # The folder that is farthest behind its share is next.
    drawn, taken = [], collections.Counter()
    while len(drawn) < count and any(turns.values()):
        folder = min((f for f in turns if turns[f]), key=lambda f: ((taken[f] + 0.5) / lines[f], f))
        site = turns[folder].pop(0)
        if line := describe(site, sources[site.file]):
            drawn.append(line)
            taken[folder] += 1
    return drawn


def main():
    options = argparse.ArgumentParser(usage=__doc__)
    options.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options.add_argument("--all", type=Path)
    options.add_argument("--gone", type=Path)
    options.add_argument("seed", nargs="?")
    options.add_argument("count", nargs="?", type=int)
    o = options.parse_args()
    if o.all:
        text = o.all.read_text()
        for site in sites.sites_of(o.all.name, text):
            print(f"{site.operator}: {(describe(site, text) or '').partition(' @ ')[2]}")
    elif o.gone:
        print("".join(f"{line}\n" for line in read(o.gone) if not find(o.root, line)), end="")
    elif not o.count:
        options.error("a seed and a count")
    else:
        print("\n".join(draw(read_sources(o.root), o.seed, o.count)))


if __name__ == "__main__":
    main()
