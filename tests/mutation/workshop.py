# SPDX-License-Identifier: MIT
"""A copy of the sources with a build tree of its own, where one file at a time is made wrong, built and tested."""
import collections
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tarfile
import time

Test = collections.namedtuple("Test", "name labels command environment directory passes artefacts scaled")

# What a build needs, by first part of its path.
SOURCES = ("CMakeLists.txt", "cmake", "core", "box2d_glue", "plugin", "testbed_scenes", "tests", "docs", "README.md",
           "CHANGELOG.md", "LICENSE", "tools")
# Mutants are no subject of these: they build something anew, or look at pages and texts.
OTHER_LABELS = {"controls", "faults", "consumer", "browser", "mutation", "examples", "fuzz", "coverage", "determinism"}
LABEL_ORDER = ["claims", "glue", "unit", "property", "hooks", "plugin", "preloaded"]
# In C, a swap of arguments whose types do not fit is an error like any other.
C_FLAGS = "-Werror=implicit-function-declaration -Werror=int-conversion -Werror=incompatible-pointer-types"
SLACK = 10.0  # seconds that a test may take beyond three times what it takes without a mutant


class BuildError(Exception):
    pass


def run(command, directory, timeout=None, environment=None):
    """Runs it in a process group of its own. (exit code or None where it took too long, output, seconds)

    `timeout`: so many seconds of the processor for each of its processes. What waits without using any has twenty times as many
    by the clock, which goes on where the machine is busy with other things."""
    started = time.monotonic()
    if timeout is not None:
        seconds = max(1, math.ceil(timeout))
        command = ["prlimit", f"--cpu={seconds}:{seconds + 60}", *command]
        timeout *= 20
    process = subprocess.Popen(command, cwd=directory, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               stdin=subprocess.DEVNULL, start_new_session=True,
                               env={**os.environ, **(environment or {})})
    try:
        output, _ = process.communicate(timeout=timeout)
        code = process.returncode if process.returncode not in (-signal.SIGXCPU, 128 + signal.SIGXCPU) else None
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        code = None
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        raise
    return code, output.decode(errors="replace"), time.monotonic() - started


def digest(data):
    return hashlib.sha256(data).hexdigest()[:16]


class Workshop:
    def __init__(self, directory, arguments=(), tests="", within=float("inf"), say=print):
        self.source = pathlib.Path(directory).resolve() / "source"
        self.tree = self.source.parent / "tree"
        self.arguments, self.wanted, self.within, self.say = list(arguments), re.compile(tests), within, say
        self.tests, self.objects, self.digests, self.linked, self.normal = [], {}, {}, {}, {}

    # -- the copy and its tree

    def fill(self, root, commit=None):
        """Makes the copy what the sources are, in the working tree or in a commit; what is as it was stays untouched."""
        if commit:
            archive = subprocess.Popen(["git", "-C", root, "archive", commit], stdout=subprocess.PIPE)
            with tarfile.open(fileobj=archive.stdout, mode="r|") as tar:
                files = {member.name: (tar.extractfile(member).read(), member.mode) for member in tar if member.isfile()}
            if archive.wait() != 0:
                raise BuildError(f"no commit {commit}")
        else:
            paths = [p for part in SOURCES for p in [root / part, *(root / part).rglob("*")] if p.is_file()]
            files = {str(p.relative_to(root)): (p.read_bytes(), p.stat().st_mode & 0o777) for p in paths
                     if "__pycache__" not in p.parts}
        for name, (data, mode) in files.items():
            path = self.source / name
            if not path.is_file() or path.read_bytes() != data:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
                path.chmod(mode)
        for path in [p for p in self.source.rglob("*") if p.is_file()]:
            if str(path.relative_to(self.source)) not in files:
                path.unlink()

    def configure(self):
        launchers = [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX") if shutil.which("ccache")]
        code, output, _ = run(
            ["cmake", "-S", self.source, "-B", self.tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DBOOMERANG_BUILD_TESTS=ON", "-DBOOMERANG_BUILD_PLAYGROUND=ON",
             "-DBOOMERANG_WARNINGS_AS_ERRORS=OFF",
             f"-DCMAKE_C_FLAGS={C_FLAGS}", "-DCMAKE_EXE_LINKER_FLAGS=-Wl,-Map=%.map",
             "-DCMAKE_SHARED_LINKER_FLAGS=-Wl,-Map=%.map", *launchers, *self.arguments], "/")
        if code != 0:
            raise BuildError(output)

    def ninja(self, *targets, timeout=7200):
        """(whether it was built, what the compiler said)"""
        code, output, _ = run(["ninja", "-C", str(self.tree), "-j", "1", *targets], "/", timeout)
        return code == 0, output

    def prepare(self, *targets):
        """Configures, builds (these targets or all), and learns what is compiled from what, and which test sees it."""
        self.configure()
        ok, output = self.ninja(*targets)
        if not ok:
            raise BuildError(output[-4000:])
        self.tests = self._find_tests()  # (ctest tells no command of a program that is not there)
        self._find_objects()
        self._find_links()
        self.digests = {o: digest((self.tree / o).read_bytes()) for objects in self.objects.values() for o in objects}

    def _query(self, *command):
        code, output, _ = run([str(word) for word in command], self.tree)
        if code != 0:
            raise BuildError(output)
        return output

    def _find_tests(self):
        outputs = dict(line.split(": ") for line in self._query("ninja", "-t", "targets", "all").splitlines())
        tests = []
        for entry in json.loads(self._query("ctest", "--show-only=json-v1"))["tests"]:
            properties = {p["name"]: p["value"] for p in entry.get("properties", [])}
            labels = properties.get("LABELS", [])
            if not self.wanted.search(entry["name"]) or OTHER_LABELS & set(labels) or not entry.get("command") \
                    or entry["name"].endswith(("_control", "_controls")):
                continue
            command = entry["command"]
            artefacts = {name for word in command for name in self._artefacts(word.split("=")[-1], outputs)}
            if not artefacts:
                continue
            texts = [self.source / "tests" / folder / (entry["name"] + end) for folder in ("claims", "glue")
                     for end in (".c", ".cpp")]
            texts = [t for t in texts if t.is_file()] + [pathlib.Path(w) for w in command if w.endswith(".sh")]
            scaled = any(re.search("test_scaled|BMR_TEST_SCALE", t.read_text()) for t in texts)
            tests.append(Test(entry["name"], labels, command, dict(e.split("=", 1) for e in properties.get("ENVIRONMENT", [])),
                              properties.get("WORKING_DIRECTORY", str(self.tree)),
                              properties.get("PASS_REGULAR_EXPRESSION", []), sorted(artefacts), scaled))
        return tests

    def _artefacts(self, word, outputs):
        """What of the tree an argument of a test names: a program, a library, or the programs of a directory."""
        path = os.path.relpath(word, self.tree) if os.path.isabs(word) else ""
        if path in outputs and not path.endswith((".a", ".o")) and not (self.tree / path).is_dir():
            return [path]
        return [o for o, rule in outputs.items() if path and os.path.dirname(o) == path and "EXECUTABLE_LINKER" in rule
                and not os.path.basename(o).startswith("test_")]

    def _find_objects(self):
        """Which objects each file of the sources is compiled into."""
        self.objects, current = collections.defaultdict(list), None
        for line in self._query("ninja", "-t", "deps").splitlines():
            if line and not line[0].isspace():
                current = line.split(": ")[0]
            elif line.strip():
                path = os.path.normpath(os.path.join(self.tree, line.strip()))
                if path.startswith(str(self.source) + "/") and (self.tree / current).is_file():
                    self.objects[os.path.relpath(path, self.source)].append(current)

    def _find_links(self):
        """Which objects each program and library has inside, and which libraries beside it."""
        for path in self.tree.rglob("*.map"):
            text = path.read_text(errors="replace").split("Memory Configuration")
            inside = set(re.findall(r"^(\S+\.a)\((\S+\.o)\)$", text[0], re.MULTILINE))
            loads = re.findall(r"^LOAD (\S+)$", text[-1], re.MULTILINE)
            self.linked[str(path.relative_to(self.tree))[:-4]] = (inside, set(loads))

    def _sees(self, artefact, objects, seen=()):
        """Whether one of the objects is in a program, or in a library of the tree that it loads. (An archive's map
        names files without their folders: namesakes count as each other.)"""
        names = {os.path.basename(o) for o in objects}
        inside, loads = self.linked.get(artefact, (set(), set()))
        if any(member in names for _, member in inside) or loads & set(objects):
            return True
        beside = {os.path.relpath(os.path.realpath(self.tree / load), self.tree) for load in loads if ".so" in load}
        return any(self._sees(b, objects, (*seen, artefact)) for b in beside if b in self.linked and b not in seen)

    # -- the tests

    def try_out(self, scales):
        """Runs all tests without a mutant. Those that fail are put aside, and named."""
        failed = []
        for test in self.tests:
            for scale in scales:
                if scale != scales[0] and not test.scaled:
                    continue
                passed, seconds, _ = self.run_test(test, scale, 1800.0)
                self.normal[test.name, scale] = seconds
                if not passed:
                    failed.append(test.name)
                    break
            self.say(f"{'fails' if test.name in failed else 'passes'} without a mutant: {test.name}"
                     f" ({', '.join(f'{self.normal[test.name, s]:.1f} s' for s in scales if (test.name, s) in self.normal)})")
        self.tests = [test for test in self.tests if test.name not in failed]
        return failed

    def run_test(self, test, scale, timeout):
        """(passed, seconds, whether it took too long)"""
        code, output, seconds = run(test.command, test.directory, timeout,
                                    {**test.environment, "BMR_TEST_SCALE": str(scale)})
        if test.passes and code is not None:
            return any(re.search(p, output) for p in test.passes), seconds, False
        return code == 0, seconds, code is None

    def tests_for(self, file, scale):
        """The tests that see a file: those named after it first, then by kind, then the quick ones."""
        stem = {word for word in re.split(r"[_./]", file) if len(word) > 2} - {"core", "cpp", "include", "boomerang"}

        def alike(test):
            return len(stem & (set(test.name.split("_")) - {"test"}))

        def order(test):
            label = test.labels[0] if test.labels else ""
            kind = LABEL_ORDER.index(label) if label in LABEL_ORDER else len(LABEL_ORDER)
            return -alike(test), kind, self.normal[test.name, scale]

        objects = self.objects.get(file, [])
        return sorted((t for t in self.tests if any(self._sees(a, objects) for a in t.artefacts)
                       and (alike(t) or self.normal[t.name, scale] <= self.within)), key=order)

    # -- one mutant

    def judge(self, file, text, scales):
        """Puts this text into a file, builds and tests. (verdict, by which test or why, seconds)"""
        path, started = self.source / file, time.monotonic()
        original = path.read_text()
        path.write_text(text)
        try:
            verdict, why = self._verdict(file, scales)
        finally:
            path.write_text(original)
        return verdict, why, time.monotonic() - started

    def _differs(self, objects):
        """Whether the object code of any is another than without the mutant. None: one does not compile. Of a header's
        many objects no more are compiled than it takes; what a test needs besides is built with it."""
        for first in range(0, len(objects), 4):
            some = objects[first:first + 4]
            if not self.ninja(*some)[0]:
                return None
            if any(digest((self.tree / o).read_bytes()) != self.digests[o] for o in some):
                return True
        return False

    def _verdict(self, file, scales):
        objects = sorted(self.objects.get(file, []), key=lambda o: (not o.startswith("core"), o))
        tests = [o for o in objects if o.startswith("tests/") and "boomerang_test_support" not in o]
        for part in ([o for o in objects if o not in tests], tests):
            differs = self._differs(part) if part else False
            if differs is None:
                return "does not compile", ""
            if differs:
                break
        else:
            return "equivalent", "the same object code"
        seen = self.tests_for(file, scales[0])
        for scale in scales:
            for test in seen:
                if scale != scales[0] and not test.scaled:
                    continue
                if not self.ninja(*test.artefacts)[0]:
                    return "does not compile", test.name
                limit = 3.0 * self.normal[test.name, scale] + SLACK
                passed, _, late = self.run_test(test, scale, limit)
                if late:  # once more: the machine may have been busy, or the campaign been stopped for a while
                    passed, _, late = self.run_test(test, scale, limit)
                if not passed:
                    return ("timed out" if late else "killed"), test.name + (f" at scale {scale:g}" if scale != scales[0] else "")
        return "survived", f"{len(seen)} tests"
