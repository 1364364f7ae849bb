#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts drawn faults into core, the glue and the plugin, one at a time, and lists those that no test notices.

    draw_faults.py [SEED [COUNT]]

A fault is one line with another operator, with another constant, or deleted. The same SEED (1) draws the same COUNT (100) faults from
the same sources; no list is kept. They are made in a copy of the working tree, in build-faults. A fault that does not compile, or that
leaves the libraries as they are, is drawn again. All tests that are about the code run until one fails, the quick ones first; one
that hangs notices, too. BMR_JOBS in the environment: how many at once. The exit status is 0 if all faults were tried.
"""
import hashlib
import json
import os
import random
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
JOBS = os.environ.get("BMR_JOBS") or str(os.cpu_count())
LIBRARIES = ("core/all", "box2d_glue/all", "plugin/all")
NOT_ASKED = "^(front|gate)$"  # labels
SECONDS = 300  # after which a test that takes a few of them is taken to hang
SWAPS = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||",
         "||": "&&", "+=": "-=", "-=": "+=", "++": "--", "--": "++", "&": "|", "|": "&"}
# (Formatted sources have a blank on both sides of a binary operator.)
OPERATOR = re.compile(r"(?<= )(?:[<>=!]=|&&|\|\||[-+]=|[-+*/<>&|])(?= )|\+\+|--")
CONSTANT = re.compile(r"(?<![\w.])(?:0x[\da-fA-F.]+(?:p[-+]?\d+)?|\d+(?:\.\d*)?(?:e[-+]?\d+)?)(?=[fuUL]*\b)|\b(?:true|false)\b")
STATEMENT = re.compile(r"\s+(?=\S)(?!(return|using|static_assert|case|default|namespace|typedef|struct|class|enum|extern)\b)[^{}]*;\s*$")


def changes(line):
    """{kind: [lines with that fault]} for one line of a source."""
    code = re.sub(r'//.*|"(?:\\.|[^"\\])*"', lambda m: " " * len(m[0]), line)
    if code.lstrip().startswith(("#", "*", "/*")) or "assert(" in code.lower() or not code.strip():
        return {}

    def with_each(pattern, other):
        return [line[:m.start()] + other(m[0]) + line[m.end():] for m in pattern.finditer(code)]
    found = {"operator": with_each(OPERATOR, SWAPS.get), "constant": with_each(CONSTANT, another),
             "deleted": [line[:len(line) - len(line.lstrip())] + ";"] if STATEMENT.match(code) else []}
    return {kind: made for kind, made in found.items() if made}


def another(constant):
    if constant in ("true", "false"):
        return "false" if constant == "true" else "true"
    if constant.isdecimal():
        return str(int(constant) + 1)
    is_whole = constant.startswith("0x") and "p" not in constant
    return f"({constant} * 2 + 1)" if is_whole else "1.0" if not constant.strip("0.") else f"(2 * {constant})"


def sources(*folders):
    return sorted(subprocess.check_output(["git", "ls-files", "--", *folders], cwd=ROOT, text=True).splitlines())


def draws(seed):
    """(file, line's number, kind, line, line with the fault), without end: every line of code is as likely as another."""
    files = [file for file in sources("core", "box2d_glue", "plugin") if re.search(r"^(?!.*/examples/).*\.(c|h|cpp)$", file)]
    lines = [(file, number, line) for file in files
             for number, line in enumerate((ROOT / file).read_text().splitlines()) if changes(line)]
    chance = random.Random(seed)
    while True:
        file, number, line = chance.choice(lines)
        kind = chance.choice(["operator", "constant", "deleted"])
        if made := changes(line).get(kind):
            yield file, number, kind, line, chance.choice(made)


class Tree:
    def __init__(self):
        self.source, self.build = ROOT / "build-faults", ROOT / "build-faults/build"
        for file in sources():
            there, here = ROOT / file, self.source / file
            if there.is_file() and (not here.is_file() or here.read_bytes() != there.read_bytes()):
                here.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(there, here)
                here.touch()
        self._run("cmake", "--preset", "release", "-S", self.source, "-B", self.build, "-DBOOMERANG_QUICK_BUILD=ON",
                  f"-DBOOMERANG_TEST_TIMEOUT={SECONDS}")
        if not self.makes(*LIBRARIES) or not self.makes("tests/all"):
            sys.exit(f"draw_faults.py: {self.source} does not build")
        self.code = self.libraries()
        self._choose()

    def _choose(self):
        """Runs all tests without a fault. Those that pass are asked: in three batches, by the seconds that they took."""
        said = self._run("ctest", "--label-exclude", NOT_ASKED, "--parallel", JOBS).stdout
        took = {name: (float(seconds), verdict) for name, verdict, seconds in re.findall(
            r"Test +#\d+: (\S+) \.*[ *]*(Passed|[A-Z]\w+) .*?([\d.]+) sec", said)}
        everyone = json.loads(self._run("ctest", "--show-only=json-v1").stdout)["tests"]
        asked = [(took[t["name"]][0], n) for n, t in enumerate(everyone, 1) if took.get(t["name"], (0, ""))[1] == "Passed"]
        numbers = {n for _, n in asked}
        words = {word for n, t in enumerate(everyone, 1) if n in numbers for word in t["command"] if word.startswith(f"{self.build}/")}
        self.programs = sorted(os.path.relpath(word, self.build) for word in words
                               if os.path.isfile(word) and Path(word).open("rb").read(4) == b"\x7fELF")  # (a script is no target)
        if not self.makes(*self.programs):
            sys.exit(f"draw_faults.py: not all of these are targets: {self.programs}")
        self.batches = [[n for seconds, n in asked if low <= seconds < high] for low, high in ((0, 0.5), (0.5, 3), (3, 1e9))]
        failed = [name for name, (_, verdict) in took.items() if verdict != "Passed"]
        print(f"{len(asked)} tests are asked, which take {sum(s for s, _ in asked):.0f} s; not asked, for they fail: {failed}", flush=True)

    def _run(self, *words):
        return subprocess.run([str(word) for word in words], cwd=self.build if self.build.is_dir() else self.source, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace", env=os.environ | {"BMR_TEST_SCALE": "0.1"})

    def makes(self, *targets):
        return self._run("cmake", "--build", self.build, "--parallel", JOBS, "--target", *targets).returncode == 0

    def libraries(self):
        made = re.compile(r"libboomerang_(core|kinetic|box2d\w*|repair|recorder)\.")
        return [hashlib.sha256(path.read_bytes()).digest() for path in sorted(self.build.glob("lib/*")) if made.match(path.name)]

    def asks(self, file, number, line):
        """Who notices this line in the place of the file's own; nothing: no test; None: it is no fault."""
        path = self.source / file
        text = path.read_text()
        lines = text.splitlines()
        path.write_text("\n".join(lines[:number] + [line] + lines[number + 1:]) + "\n")
        try:
            if not self.makes(*LIBRARIES) or self.libraries() == self.code:
                return None
            if not self.makes(*self.programs):
                return "the compiler, in what the libraries do not hold"
            for batch in filter(None, self.batches):
                numbers = "0,0,0," + ",".join(map(str, batch))
                run = self._run("ctest", "--stop-on-failure", "--parallel", JOBS, "-I", numbers)
                if run.returncode != 0:
                    return re.findall(r"Test +#\d+: (\S+) \.*(?!.* Passed )", run.stdout)[0]
            return ""
        finally:
            path.write_text(text)


def main():
    seed, count = sys.argv[1:] + ["1", "100"][len(sys.argv) - 1:]
    drawn, tree = draws(int(seed)), Tree()
    tried = survived = 0
    while tried < int(count):
        file, number, kind, before, after = next(drawn)
        fault = f"{file}:{number + 1}: {kind}: {before.strip()}  ->  {after.strip()}"
        who = tree.asks(file, number, after)
        if who is None:
            continue
        tried, survived = tried + 1, survived + (not who)
        print(f"{tried} {f'noticed by {who}' if who else 'SURVIVES'}: {fault}", flush=True)
    print(f"{tried} faults, {tried - survived} noticed, {survived} survive")


main()
