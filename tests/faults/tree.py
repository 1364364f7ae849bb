# SPDX-License-Identifier: MIT
"""A build tree of Ninja's, and programs of it in which one file of the sources is another.

Who links what stands in build.ninja, how a file is compiled in compile_commands.json. Nothing about a test has to be written down for it to be asked.
"""
import json
import os
import re
import shlex
import subprocess
from pathlib import Path

PARTS = ("core", "box2d_glue", "plugin")
LINKER = re.compile(r"C(XX)?_(EXECUTABLE|STATIC_LIBRARY|SHARED_LIBRARY|SHARED_MODULE)_LINKER__")
DOCTEST = "lib/libboomerang_doctest.a"


class DoesNotBuild(Exception):
    """Says why."""


class Tree:
    """The targets of one build tree, and the tests registered in it."""

    def __init__(self, root, build):
        self.root, self.build = Path(root).resolve(), Path(build).resolve()
        self.inputs, self.aliases = {}, {}  # of a linked file its inputs; of a name or a symbolic link what it stands for
        for line in (self.build / "build.ninja").read_text().splitlines():
            if not line.startswith("build "):
                continue
            outputs, _, rest = line[len("build "):].partition(": ")
            rule, _, inputs = rest.partition(" ")
            inputs = inputs.split(" || ")[0].replace(" | ", " ").split()
            if LINKER.match(rule):
                self.inputs[outputs.split()[0]] = inputs
            elif rule in ("phony", "CMAKE_SYMLINK_LIBRARY") and len(inputs) == 1:
                self.aliases.update({output: inputs[0] for output in outputs.split()})
        self.compiled = {}  # of an object its source and its command
        for entry in json.loads((self.build / "compile_commands.json").read_text()):
            words = shlex.split(entry["command"])
            self.compiled[words[words.index("-o") + 1]] = (entry["file"], words)
        self._tests, self._includers, self._names, self._commands = None, None, {}, {}

    def product(self, name):
        """The linked file (a path in the build tree) that a target's name or any path of it stands for; or None."""
        name = str(name)
        if name.startswith(f"{self.build}/"):
            name = name[len(str(self.build)) + 1:]
        for _ in range(9):
            if name in self.inputs or name not in self.aliases:
                break
            name = self.aliases[name]
        return name if name in self.inputs else None

    def tests(self):
        """The registered tests: of each name its command, its environment and its labels."""
        if self._tests is None:
            found = subprocess.run(["ctest", "--show-only=json-v1"], cwd=self.build, stdout=subprocess.PIPE, check=True).stdout
            self._tests = {}
            for test in json.loads(found)["tests"]:
                properties = {p["name"]: p["value"] for p in test.get("properties", [])}
                variables = dict(v.split("=", 1) for v in properties.get("ENVIRONMENT", []))
                self._tests[test["name"]] = (test.get("command", []), variables, properties.get("LABELS", []))
        return self._tests

    def objects_of(self, file):
        """The objects that a source is compiled to; those of all that include it, if it is a header."""
        file = str(self.root / file)
        if not file.endswith(".h"):
            return {o for o, (source, _) in self.compiled.items() if source == file}
        if self._includers is None:
            listed = subprocess.run(["ninja", "-C", self.build, "-t", "deps"], stdout=subprocess.PIPE, text=True, check=True).stdout
            self._includers = [block.splitlines() for block in listed.split("\n\n") if block]
        name = f"/{os.path.basename(file)}"
        return {head.split(": ")[0] for head, *lines in self._includers if any(
            line.endswith(name) and os.path.normpath(self.build / line.strip()) == file for line in lines)} & self.compiled.keys()

    def names(self, file):
        """The names that an object, or whatever is linked, defines."""
        if file not in self._names:
            listed = subprocess.run(["nm", "-P", "--defined-only", self.build / file], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            kinds = "TDBR" if file.endswith(".o") else "TtDdBbRr"
            self._names[file] = {name for name, kind, *_ in map(str.split, listed.stdout.splitlines()) if kind in kinds}
        return self._names[file]

    def taken(self, product, objects):
        """Which of the objects are linked into this product. It takes of an archive what it needs."""
        found = objects.intersection(self.inputs[product])
        for archive in filter(None, map(self.product, self.inputs[product])):
            if archive.endswith(".a"):
                found |= {o for o in objects.intersection(self.inputs[archive]) if self.names(o) & self.names(product)}
        return found

    def loaded(self, product):
        """The libraries that a product loads, and itself."""
        inner = [p for p in map(self.product, self.inputs[product]) if p and not p.endswith(".a")]
        return {product}.union(*map(self.loaded, inner))

    def link_command(self, product):
        if product not in self._commands:
            commands = subprocess.run(["ninja", "-t", "commands", "-s", product], cwd=self.build, stdout=subprocess.PIPE, text=True, check=True)
            self._commands[product] = shlex.split(commands.stdout.split(" && ")[1])
        return self._commands[product]

    def is_doctest(self, product):
        return DOCTEST in self.inputs[product]


class Faulty:
    """The products of a tree of which `objects` are compiled anew, in `place`, where one file of the sources has another text."""

    def __init__(self, tree, place, objects, file, text):
        self.tree, self.place, self.objects, self.file = tree, Path(place), objects, file
        self.made, self.linked, self.count = {}, {}, 0
        # All others are symbolic links to what they are, also folders beside the file's own.
        for part in PARTS:
            self._show(part, file)
        (self.place / file).write_bytes(text)

    def _show(self, path, file):
        there, here = self.tree.root / path, self.place / path
        if path == file:
            return
        if not file.startswith(f"{path}/"):
            here.symlink_to(there)
            return
        here.mkdir()
        for inner in there.iterdir():
            self._show(f"{path}/{inner.name}", file)

    def _run(self, words):
        done = subprocess.run(words, cwd=self.tree.build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace",
                              env=os.environ | {"CCACHE_DISABLE": "1"})
        if done.returncode != 0:
            raise DoesNotBuild("does not build: " + "\n".join(done.stdout.splitlines()[:5]))

    def _compile(self, output):
        if output in self.made:
            return self.made[output]
        # Optimised as little as can be, and with assertions: all that is asked is whether the test fails.
        words, sources = [], re.compile(f"{re.escape(str(self.tree.root))}/(?=({'|'.join(PARTS)})(/|$))")
        for word in self.tree.compiled[output][1]:
            if not re.fullmatch(r"-O.|-DNDEBUG|-Werror|-W[a-z][^,]*", word):
                words.append(("-O1" if "-std=c11" in words else "-O0") if word == "-c" else sources.sub(f"{self.place}/", word))
                words += ["-w", "-c"] if word == "-c" else []
        self.count += 1
        made = self.place / f"{self.count}-{Path(output).name}"
        words[words.index("-o") + 1] = str(made)
        self._run(words)
        self.made[output] = str(made)
        return str(made)

    def differs(self):
        """Is what was compiled (all, if nothing was) other code than without the fault?"""
        made, self.made = self.made or {output: self._compile(output) for output in self.objects}, {}
        (self.place / self.file).write_bytes((self.tree.root / self.file).read_bytes())
        return any(Path(file).read_bytes() != Path(self._compile(output)).read_bytes() for output, file in made.items())

    def path(self, product):
        """Where the faulty one is; None where the fault is not in what it links. A library that it loads is made, too."""
        if product not in self.linked:
            changed = {i: self._compile(i) for i in self.tree.taken(product, self.objects)}
            for i in self.tree.inputs[product]:
                inner = self.tree.product(i)
                if inner and not inner.endswith(".a"):
                    self.path(inner)
            self.linked[product] = self._link(product, changed) if changed else None
        return self.linked[product]

    def _link(self, product, changed):
        made = self.place / f"{len(self.linked)}" / Path(product).name
        made.parent.mkdir()
        words = [changed.pop(w, w) for w in self.tree.link_command(product)]
        output = words.index("-o")
        # Of an archive nothing is taken that is there already.
        words[output:output + 2] = ["-o", str(made), *changed.values()]
        self._run(words)
        # What is linked against a library asks for it by its soname.
        for word in words:
            if "soname," in word:
                (self.place / word.split("soname,")[1]).symlink_to(made)
        return str(made)
