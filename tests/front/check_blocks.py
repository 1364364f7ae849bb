#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does every block of code in the pages work when it is copied?

    check_blocks.py pages ROOT BUILD WORK      all but CMake's recipes, with the programs of the build tree BUILD
    check_blocks.py recipes ROOT BOX2D WORK    the recipes, each configured in an empty folder beside Box2D's sources BOX2D
    check_blocks.py recipes ROOT BOX2D WORK build   and built, and run

How a block is treated its language says, or the line above it:

    <!-- from FILE -->         it is a part of that file, which a test compiles and runs
    <!-- output of NAME -->    it is what NAME.c or NAME.py prints: check_quoted.sh
    ```cpp                     compiled with what the page includes, and run with a body that falls
    ```cmake                   `recipes`
    ```sh                      line by line: SHELL below
    ```                        PLAIN below

A block or a line of the shell for which there is no treatment fails."""
import json
import os
import pathlib
import re
import subprocess
import sys

PAGES = ["README.md", "CONTRIBUTING.md", "core/README.md", "docs/*.md", "playground/README.md"]
# Blocks without a language: what they begin with, and what becomes of them.
PLAIN = {
    "Box2D is a shared library here,": "shown", # what `boomerang try` says: tests/plugin/test_try.sh
    "How kinetic the world is:": "shown", # `run reproduce scenes` compares it
    "step:": "shown", # a sketch
    "# A rests; B passes above it": "motions",
}
# What the snippets of the pages in C++ are compiled with: what they speak of and do not make.
CPP = """
static void Block{number}(b2Body *body) {{
    static const b2Vec2 points[] = {{{{-2, -2}}, {{2, -2}}, {{2, 2}}, {{0, 1}}, {{-2, 2}}}}, window[] = {{{{-1, -1}}, {{-0.5f, -1}}, {{-0.5f, 0}}, {{-1, 0}}}},
                        door[] = {{{{0.5f, -1}}, {{1, -1}}, {{1, 0}}, {{0.5f, 0}}}};
    static const int count = 5;
    bmr::OutlineShape wall;
    (void)body, (void)points, (void)window, (void)door, (void)count, (void)wall;
#line {line} "{page}"
{code}
}}
"""
CPP_MAIN = """
#line 1 "main"
#include <box2d/box2d.h>
int main() {{
    b2World world(b2Vec2(0, -10));
    b2BodyDef def;
    def.type = b2_dynamicBody;
    b2Body *body = world.CreateBody(&def);
    {calls}
    world.Step(1 / 60.0f, 8, 3);
    return body->GetFixtureList() && body->GetLinearVelocity().y < 0 ? 0 : 1;
}}
"""


class Block:
    def __init__(self, page, line, mark, language, code):
        self.page, self.line, self.mark, self.language, self.code = page, line, mark, language, code

    def __str__(self):
        return f"{self.page}:{self.line}"


def blocks_of(page, text):
    for found in re.finditer(r"(?:^<!-- (.*?) -->\n)?^```([^\n]*)\n(.*?)^```$", text, flags=re.S | re.M):
        yield Block(page, text.count("\n", 0, found.start(3)) + 1, found[1] or "", found[2], found[3])


def run(command, **more):
    """Its output; an AssertionError where it fails."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False, stdin=subprocess.DEVNULL, **more)
    assert done.returncode == 0, f"{command} fails:\n{done.stdout[-3000:]}"
    return done.stdout


class Checker:
    def __init__(self, root, build, work):
        self.root, self.build, self.work = root, build, work
        self.files = [file for folder in ("core", "plugin", "tests") for file in (root / folder).rglob("*") if file.suffix in (".c", ".cpp", ".py", ".txt")]
        self.said = {}

    def help(self, *command):
        if command not in self.said:
            self.said[command] = run([*command, "--help"])
        return self.said[command]

    def has_options(self, line, *command):
        """Each option of a line is one of the command's."""
        for option in re.findall(r"(?<=\s)--?[a-z][a-z-]*", line):
            assert re.search(rf"(?<![\w-]){option}(?![\w-])", self.help(*command)), f"{' '.join(map(str, command))} has no {option}"

    # What SHELL names, by the words that its patterns found.
    def testbed(self, line, command):
        self.has_options(line, self.build / "bin/boomerang-testbed", command)

    def run_script(self, line, command):
        run([self.root / "testbed_scenes/run", *([command] if command else []), "--help"])

    def gate(self, line):
        self.has_options(line, self.root / "tests/run")

    def preset(self, line, name):
        assert name in [preset["name"] for preset in json.loads((self.root / "CMakePresets.json").read_text())["configurePresets"]], f"no preset {name}"

    def targets(self, line, names):
        for name in names.split():
            run(["ninja", "-C", self.build, "-t", "query", name])

    def ctest(self, line, pattern):
        said = run(["ctest", "--test-dir", self.build, "-N", "-R", pattern])
        assert len(re.findall(r"^ *Test +#", said, flags=re.M)) > pattern.count("|"), f"{pattern} names no test, or one less than it says"

    def packages(self, line):
        known = re.findall(r"boomerang_package\(\w+ (\S+)", (self.root / "cmake/BoomerangPackages.cmake").read_text())
        for name in re.findall(r"\./([\w-]+)_\*\.deb", line):
            assert name in known, f"there is no package {name}"

    def game(self, line):
        """As it stands, with a scene in the place of the game, and the library of the build tree."""
        scene = f"{self.build}/bin/boomerang-scene pyramid --steps 20"
        line = re.sub(r"(\./)?\bgame( --level 3)?$", scene, line).replace("/path/to/", f"{self.build}/lib/")
        line = re.sub(r"^boomerang try", f"{self.build}/bin/boomerang try --seconds 0.3 --rounds 1", line)
        assert scene in line, "names no game"
        run(["bash", "-c", line], cwd=self.work)

    def example(self, line, settings, name):
        """A program of docs/first-steps.md, as the build tree has it."""
        program = next((file for file in (self.build / "bin").glob(f"*{name}") if os.access(file, os.X_OK)), None)
        assert program, f"there is no {name}"
        run(["bash", "-c", f"{settings}{program}"], cwd=self.work)

    def source(self, line, name):
        assert any(file.name == name for file in self.files), f"there is no {name}" # example_first_...

    def python(self, line):
        assert (self.root / line.split()[-1]).exists(), "no such file" # it is run by python_example

    def measured(self, line, script):
        assert os.access(self.root / script, os.X_OK), f"no program {script}"

    def nothing(self, line):
        pass

    SHELL = [
        (r"boomerang-testbed (\w[\w-]*)\b.*", testbed),
        (r"\./testbed_scenes/run(?: (\w+))?", run_script),
        (r"\./tests/run(?: .*)?", gate),
        (r"cmake --preset (\w+)", preset),
        (r"cmake --build build --target ([\w ]+)", targets),
        (r"ctest --test-dir build -R '(.*)'", ctest),
        (r"(?:cpack|sudo apt-get (?:install|purge)) .*", packages), # tests/front
        (r"(?:boomerang try|(?:\w+=\S+ )*LD_PRELOAD=\S+) .*", game),
        (r"((?:BOOMERANG=\w+ )?)\./(first_\w+)", example),
        (r"c(?:c|\+\+ -std=c\+\+17) (\S+) \$\(pkg-config --cflags --libs boomerang-\w+\) -o \w+", source),
        (r"PYTHONPATH=\S+ BOOMERANG_LIBRARY_DIR=\S+ python3 \S+", python),
        (r"(tests/bench/\w+\.sh) .*", measured),
        # tests/front/consumer
        (r"(?:git clone \S+(?: \w+)?(?: && cd \w+)?|cmake -S \. -B build(?: -D\S+=(?:\"[^\"]*\"|\S+))*(?: && cmake --build build -j\d+)?|cmake --build build(?: -j\d*)?|(?:sudo )?cmake --install build.*|sudo cmake --build build --target uninstall)",
         nothing),
    ]

    def shell(self, block):
        for line in block.code.replace("\\\n", " ").splitlines():
            line = re.sub(r"\s+", " ", re.sub(r"\s#.*", "", line)).strip()
            if not line or line.startswith("#"):
                continue
            for pattern, treatment in self.SHELL:
                found = re.fullmatch(pattern, line)
                if found:
                    treatment(self, line, *found.groups())
                    break
            else:
                raise AssertionError(f"no treatment for the line {line!r}")

    def quoted(self, block, name):
        assert any(block.code.strip("\n") in file.read_text() for file in self.files if file.as_posix().endswith(f"/{name}")), f"{name} has it otherwise"
        tag = re.search(r"GIT_TAG (\S+?)\)", block.code)
        assert not tag or tag[1] == "main" or run(["git", "-C", self.root, "tag", "--list", tag[1]]), f"there is no tag {tag and tag[1]}"

    def plain(self, block):
        treatments = [treatment for begin, treatment in PLAIN.items() if block.code.startswith(begin)]
        assert treatments, "no treatment for this block: a language, a mark above it, or a line in PLAIN"
        if treatments == ["motions"]:
            (self.work / "motions.txt").write_text(block.code)
            (self.work / "square.txt").write_text("1 1\n-1 1\n-1 -1\n1 -1\n")
            square = ["--polygon", "square.txt"]
            run([self.build / "bin/boomerang-testbed", "events", *square, *square, "--motion", "motions.txt", "--structures", "lazy-dudley", "--no-optimum"],
                cwd=self.work)

    def cpp(self, page, blocks):
        """All of a page in one program: a later block may do without what an earlier one includes."""
        text, calls = "", ""
        for number, block in enumerate(blocks):
            text += "".join(re.findall(r"^#include .*\n", block.code, flags=re.M))
        for number, block in enumerate(blocks):
            code = re.sub(r"^#include .*$", "", block.code, flags=re.M)
            text += CPP.format(number=number, line=block.line, page=page, code=code)
            calls += f"Block{number}(body);"
        source = self.work / (page.replace("/", "-") + ".cpp")
        source.write_text(text + CPP_MAIN.format(calls=calls))
        headers = [f"-I{self.root / folder / 'include'}" for folder in ("core", "box2d_glue", "box2d_glue/recorder", "box2d_glue/repair", "plugin")]
        repair = ["-lboomerang_repair", "-lboomerang_core", "-lpolyclipping"] if "boomerang/repair.h" in text else []
        run([os.environ.get("CXX", "c++"), "-std=c++17", "-Wall", "-Wextra", "-Werror", *headers, source, "-o", source.with_suffix(""), f"-L{self.build}/lib",
             f"-Wl,-rpath,{self.build}/lib", "-lboomerang_box2d", "-lbox2d", *repair])
        run([source.with_suffix("")])

    def check(self, pages):
        """What is wrong, a line each."""
        wrong, in_cpp, printed = [], {}, set()

        def attempt(where, function, *arguments):
            try:
                function(*arguments)
            except AssertionError as error:
                wrong.append(f"{where}: {error}")

        for page, text in pages.items():
            for block in blocks_of(page, text):
                kind, _, name = block.mark.partition(" ")
                if kind == "from":
                    printed.add(name.rsplit(".", 1)[0])
                    attempt(block, self.quoted, block, name)
                elif block.mark.startswith("output of "):
                    if block.mark[10:] not in printed:
                        wrong.append(f"{block}: no block above it is from {block.mark[10:]}")
                elif block.language == "sh":
                    attempt(block, self.shell, block)
                elif block.language == "cpp":
                    in_cpp.setdefault(page, []).append(block)
                elif block.language == "":
                    attempt(block, self.plain, block)
                elif block.language != "cmake":
                    wrong.append(f"{block}: no treatment for {block.language}")
        for page, blocks in in_cpp.items():
            attempt(page, self.cpp, page, blocks)
        return wrong


def recipe(block, root, box2d, work, build):
    """A project of its own, in a folder with nothing in it but what the recipe says: Boomerang's sources, Box2D's, and the game."""
    work.mkdir(parents=True)
    (work / "CMakeLists.txt").write_text(block.code)
    (work / "main.cpp").write_text('#include <box2d/box2d.h>\n#include <boomerang/box2d.h>\n'
                                   "int main() { b2World world(b2Vec2(0, -10)); world.Step(0.1f, 8, 3); return 0; }\n")
    (work / "boomerang").symlink_to(root)
    (work / "box2d").symlink_to(box2d)
    (work / "physics").mkdir()
    (work / "physics/box2d").symlink_to(box2d)
    said = run(["cmake", "-S", work, "-B", work / "build", "-G", "Ninja", f"-DFETCHCONTENT_SOURCE_DIR_BOX2D={box2d}"])
    assert "game" in run(["ninja", "-C", work / "build", "-t", "query", "game"])
    listed = run(["ninja", "-C", work / "build", "-t", "targets", "all"])
    assert "boomerang.dir" in listed, "Boomerang is not compiled with it"
    assert "testbed" not in listed and "unit_test" not in listed, "Box2D's own programs are made, too"
    if build:
        run(["cmake", "--build", work / "build", "--target", "game"])
        said = run([next((work / "build").rglob("game"))], env={**os.environ, "BOOMERANG_VERBOSE": "1"})
        assert "compiled with Box2D" in said, said


def check_recipes(pages, root, box2d, work, build):
    wrong, count = [], 0
    for page, text in pages.items():
        for block in blocks_of(page, text):
            if block.language == "cmake" and not block.mark:
                count += 1
                try:
                    recipe(block, root, box2d, work / str(count), build)
                except AssertionError as error:
                    wrong.append(f"{block}: {error}")
    return wrong


def main():
    what, *places = sys.argv[1:5]
    root, other, work = (pathlib.Path(place).resolve() for place in places)
    run(["rm", "-rf", work])
    work.mkdir(parents=True)
    pages = {str(file.relative_to(root)): file.read_text() for pattern in PAGES for file in sorted(root.glob(pattern))}
    recipes = what == "recipes"
    # The controls: a block of each kind that does not work.
    if recipes:
        control = {"a.md": "```cmake\ncmake_minimum_required(VERSION 3.16)\nproject(game C CXX)\nset(BOX2D_BUILD_TESTBED OFF CACHE BOOL \"\")\nadd_subdirectory(box2d)\nboomerang_accelerate(box2d)\n```\n"}
        wanted = [r"a.md:2: .*Unknown CMake command"]
        found = check_recipes(control, root, other, work / "control", False)
    else:
        control = {"a.md": "```sh\nboomerang-testbed events --nope\n```\n```sh\nmake\n```\n```\nwords\n```\n<!-- from queries.c -->\n```c\nint x;\n```\n"
                           "```cpp\nbmr::Nothing x;\n```\n```rust\n```\n<!-- output of none -->\n```\n```\n```sh\n./tests/run --sometimes\n```\n"
                           "```sh\ncmake --build build --target no_target\n```\n```sh\nsudo apt-get install ./libboomerang-none_*.deb\n```\n"}
        wanted = [r"a.md:2: .* has no --nope", r"a.md:5: no treatment for the line 'make'", r"a.md:8: no treatment", r"a.md:12: queries.c has it otherwise",
                  r"a.md:18: no treatment for rust", r"a.md:21: no block above", r"a.md:23: .* no --sometimes", r"a.md:26: .*no_target",
                  r"a.md:29: there is no package", r"a.md: .*Block0"]
        found = Checker(root, other, work).check(control)
    missed = [pattern for pattern, line in zip(wanted, found) if not re.match(pattern, line, flags=re.S)] if len(wanted) == len(found) else wanted
    if missed:
        sys.exit("FAILED: the control: not noticed: " + "; ".join(missed) + "\nnoticed: " + "\n".join(found))
    wrong = check_recipes(pages, root, other, work, "build" in sys.argv[5:]) if recipes else Checker(root, other, work).check(pages)
    if wrong:
        sys.exit("FAILED:\n" + "\n".join(wrong))
    run(["rm", "-rf", work])
    print("passed")


if __name__ == "__main__":
    main()
