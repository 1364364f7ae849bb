#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays the actor on stock Box2D and with the plugin in each of its forms: each line must be stock's, and the ending.

    play.py PROGRAMS LIBRARY [CORPUS] [--first SEED] [--seeds COUNT] [--forms FORM,...] [--jobs N]

PROGRAMS: a directory with actor_stock, actor_linked and libactor_poison.so. Played are the inputs of CORPUS and the worlds of
seeds. Where one differs stock is held against itself, with other bytes in what Box2D frees and in fresh memory: from where these
decide, or a signal or one of Box2D's assertions ends it, a world is not compared.
Polygons of any size are held against the plugin without its hooks.

Without --first and --seeds: BMR_TEST_SEED (default 1) and 480 worlds times BMR_TEST_SCALE, no fewer than 24.
"""
import argparse
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

CHUNK = 12
ENOUGH = 5  # inputs that differ: the rest is not played
BASES = {"trapped": "stock trapped", "any-size": "switched off"}  # of the others it is stock
ROOT = pathlib.Path(__file__).resolve().parents[3]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("library", type=pathlib.Path)
    parser.add_argument("corpus", type=pathlib.Path, nargs="?")
    parser.add_argument("--first", type=int, default=int(os.environ.get("BMR_TEST_SEED", "1")))
    parser.add_argument("--seeds", type=int, default=max(24, int(480 * float(os.environ.get("BMR_TEST_SCALE", "1")))))
    parser.add_argument("--forms", default="preloaded,everywhere,linked,observed,dudley,trapped,any-size")
    parser.add_argument("--jobs", type=int, default=int(os.environ.get("BMR_JOBS", os.cpu_count())))
    return parser.parse_args()


class Stage:
    """Programs, what they play, and what they print: a list of lines for each input."""

    def __init__(self, given, traps):
        self.given = given
        self.poison = next(path for path in (given.programs / "libactor_poison.so", given.programs.parent / "lib/libactor_poison.so")
                           if path.exists())
        self.plays = [["seeds", str(first), str(min(CHUNK, given.first + given.seeds - first))]
                      for first in range(given.first, given.first + given.seeds, CHUNK)]
        if given.corpus:
            self.plays.append(["corpus", str(given.corpus)])
        plugin = {"LD_PRELOAD": str(given.library)}
        # Name: program, environment. (The library is linked as it was built; one that is preloaded comes first.)
        self.forms = {
            "stock": ("actor_stock", {"LD_PRELOAD": str(self.poison), "BMR_ACTOR_POISON": "165"}),
            "stock again": ("actor_stock", {"LD_PRELOAD": str(self.poison), "BMR_ACTOR_POISON": "85", "MALLOC_PERTURB_": "85"}),
            "stock trapped": ("actor_stock", {"LD_PRELOAD": traps}),
            "preloaded": ("actor_stock", plugin),
            "everywhere": ("actor_stock", {**plugin, "BOOMERANG_EVERYWHERE": "on"}),
            "linked": ("actor_linked", plugin),
            "observed": ("actor_linked", {**plugin, "BMR_ACTOR_INSTALL": "observed"}),
            "dudley": ("actor_stock", {**plugin, "BOOMERANG_PAIRS_BY": "lazy-dudley", "BOOMERANG_EVERYWHERE": "on"}),
            "trapped": ("actor_stock", {"LD_PRELOAD": f"{traps}:{given.library}", "BOOMERANG_EVERYWHERE": "on"}),
            "switched off": ("actor_linked", {**plugin, "BOOMERANG": "off"}),
            "any-size": ("actor_linked", {**plugin, "BOOMERANG_EVERYWHERE": "on"}),
        }

    def run(self, form, play, *options):
        program, environment = self.forms[form]
        # What goes round for ever ends: a hundred times what a chunk needs.
        command = ["bash", "-c", 'ulimit -c 0 -t 300; exec "$@"', "-", str(self.given.programs / program), *play, *options]
        done = subprocess.run(command, env={"PATH": "/usr/bin:/bin", "MALLOC_PERTURB_": "165", **environment},
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        lines = {}
        for line in done.stdout.splitlines():
            lines.setdefault(line.split(" ", 1)[0], []).append(line)
        return lines, done.stderr

    def dump(self, form, play, name, record):
        which = ["corpus", play[1], name] if play[0] == "corpus" else ["seeds", name, "1"]
        return self.run(form, which, *self.options(form), "--dump", record)[1].splitlines()

    @staticmethod
    def options(form):
        return ["--any-size"] if form in ("any-size", "switched off") else []


def held(lines, again):
    """What is compared of each input."""
    kept = {name: [] for name in lines}
    for name, own in lines.items():
        for line, other in zip(own, again.get(name, [])):
            if line != other or " ends signal " in line or " ends assertion " in line:
                break
            kept[name].append(line)
    return kept


def differing(expected, found):
    """The first line of each input that is not found."""
    bad = []
    for name, lines in expected.items():
        there = found.get(name, [])
        for i, line in enumerate(lines):
            if i >= len(there) or there[i] != line:
                bad.append((name, line, there[i] if i < len(there) else "nothing"))
                break
    return bad


class Verdicts:
    def __init__(self):
        self.passed = self.failed = 0

    def check(self, holds, text):
        self.passed += bool(holds)
        self.failed += not holds
        if not holds:
            print(f"FAILED: {text}", flush=True)
        return holds


def compare(stage, verdicts, form, expected, found, base):
    """`expected`, `found`: what each play printed."""
    bad = [(play, *one) for play, lines in expected.items() for one in differing(lines, found[play][0])]
    if verdicts.check(not bad, f"{form}: {len(bad)} inputs are not as in stock Box2D"):
        return
    play, name, line, there = bad[0]
    which = f"--first {name} --seeds 1" if play[0] == "seeds" else f"{play[1]} --seeds 0"
    print(f"  play it again: {sys.argv[0]} {stage.given.programs} {stage.given.library} {which} --forms {form}")
    record = line.split()[1]
    # Contacts, whose impulses move the bodies, come first; what contacts a body has in which order, a hash, comes last.
    one, other = (sorted(stage.dump(which, play, name, record) if record != "ends" else [],
                         key=lambda field: (not field.startswith("contact "), " contactOrder = " in field)) for which in (base, form))
    left, right = next((pair for pair in zip(one, other) if pair[0] != pair[1]), (line, there))
    print(f"  input {name}, record {record}\n  {base}: {left}\n  {form}: {right}")
    print("\n".join("  " + line for line in found[play][1].splitlines()[-2:]))


def main():
    given = arguments()
    verdicts = Verdicts()
    with tempfile.TemporaryDirectory() as temp, concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        traps = f"{temp}/traps.so"
        subprocess.run(["cc", "-shared", "-fPIC", "-o", traps, str(ROOT / "tests/stages/determinism/traps.c"), "-lm"], check=True)
        stage = Stage(given, traps)
        wanted = given.forms.split(",")
        bases = {form: BASES.get(form, "stock") for form in wanted}
        forms = dict.fromkeys(["stock", *bases.values(), *wanted])
        jobs = {tuple(play): {form: pool.submit(stage.run, form, play, *stage.options(form)) for form in forms} for play in stage.plays}
        outputs = {form: {} for form in forms}
        expected = {base: {} for base in ["stock", *bases.values()]}
        bad = 0
        for play, its in jobs.items():
            if bad >= ENOUGH:
                break
            for form, job in its.items():
                outputs[form][play] = job.result()
            for base, plays in expected.items():
                lines = outputs[base][play][0]
                plays[play] = held(lines, outputs["stock"][play][0] if base == "stock trapped" else lines)
            if any(differing(expected["stock"][play], outputs[form][play][0]) for form, base in bases.items() if base == "stock"):
                expected["stock"][play] = held(outputs["stock"][play][0], stage.run("stock again", play)[0])
            bad += sum(len(differing(expected[base][play], outputs[form][play][0])) for form, base in bases.items())
        pool.shutdown(cancel_futures=True)
        inputs = sum(map(len, expected["stock"].values()))

        def count(base, *endings):
            return sum(lines[-1:] != [] and lines[-1].endswith(endings) for names in expected[base].values() for lines in names.values())

        whole = count("stock", "ends done", "ends not finite")
        there = bad >= ENOUGH or inputs >= given.seeds * 9 // 10
        verdicts.check(there and 100 * whole >= 90 * inputs, f"stock Box2D survives {whole} of {inputs}")
        if "trapped" in wanted:
            trapped = count("stock trapped", "ends done")
            verdicts.check(2 * trapped >= inputs, f"of {inputs} inputs {trapped} trap nothing in stock Box2D")
        for form, base in bases.items():
            compare(stage, verdicts, form, expected[base], outputs[form], base)
        # Control: one unit in the last place of one velocity is found, and where it is.
        play = stage.plays[0]
        for record in (10, 11) if given.seeds >= CHUNK else ():
            perturbed = stage.run("stock", play, "--perturb", str(record))[0]
            bad = differing(expected["stock"][tuple(play)], perturbed)
            verdicts.check(any(line.split()[1] == str(record) for _, line, _ in bad),
                           f"control: perturbed at {record}, found {[line[:12] for _, line, _ in bad]}")
    print(f"{inputs} inputs, seeds {given.first} to {given.first + given.seeds - 1}, {whole} of them to their end: "
          f"{verdicts.passed} passed, {verdicts.failed} failed")
    return verdicts.failed > 0


if __name__ == "__main__":
    sys.exit(main())
