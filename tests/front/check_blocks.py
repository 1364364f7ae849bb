#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does the code of the pages work when it is copied?

    check_blocks.py pages ROOT BUILD WORK      snippets and commands, with the programs of the build tree BUILD
    check_blocks.py example ROOT PROGRAM WORK  one program of the build tree: a page quotes its source, and says what it prints
    check_blocks.py programs ROOT PREFIX WORK  whole programs, typed as they stand into an empty folder, on the installation PREFIX
    check_blocks.py recipes ROOT BOX2D WORK    CMake's recipes, each configured in an empty folder beside Box2D's sources BOX2D
    check_blocks.py recipes ROOT BOX2D WORK build   and built, and run

How a block is treated its language says, or the line above it:

    <!-- from FILE -->         it is a part of that file, which a test compiles and runs
    <!-- file NAME -->         `programs`: the file NAME of the folder, on which the next block of ```sh works
    <!-- output of NAME -->    it is what the program NAME prints
    ```cpp                     compiled with what the page includes, and run with a body that falls
    ```cmake                   `recipes`
    ```diff                    what it leaves stands in the files that it names
    ```sh                      each command of ours has the options that it is given"""
import os
import pathlib
import re
import subprocess
import sys

PAGES = ["README.md", "CONTRIBUTING.md", "core/README.md", "core/python/README.md", "docs/*.md", "box2d_glue/how-a-pair-is-remembered.md",
         "playground/README.md"]
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

    def shell(self, block):
        programs = {r"boomerang-testbed (\w[\w-]*).*": [self.build / "bin/boomerang-testbed"], r"\./testbed_scenes/run(?: (\w+))?.*": [self.root / "testbed_scenes/run"],
                    r"\./tests/run()(?: .*)?": [self.root / "tests/run"]}
        for line in block.code.replace("\\\n", " ").splitlines():
            line = re.sub(r"\s#.*", "", line).strip()
            for pattern, program in programs.items():
                found = re.fullmatch(pattern, line)
                if found:
                    said = run([*program, *([found[1]] if found[1] else []), "--help"])
                    for option in re.findall(r"(?<=\s)--?[a-z][a-z-]*", line):
                        assert re.search(rf"(?<![\w-]){option}(?![\w-])", said), f"{line} has no {option}"

    def quoted(self, block, name):
        assert any(block.code.strip("\n") in file.read_text() for file in self.files if file.as_posix().endswith(f"/{name}")), f"{name} has it otherwise"

    def diff(self, block):
        """A hunk that begins with @@ is in its file as it is; of a part without, all lines are there, in their order."""
        for part in re.split(r"^--- a/", block.code, flags=re.M)[1:]:
            name = part.split()[0]
            there = ["", *(line.rstrip(" \\") for line in (self.root / name).read_text().splitlines()), ""]
            hunks = re.split(r"^@@.*\n", part, flags=re.M)[1:]
            for hunk in hunks or [part.partition("\n")[2]]:
                lines, rest = [line[1:] for line in hunk.splitlines() if not line.startswith("-")], iter(there)
                stands = "\n".join(["", *lines, ""]) in "\n".join(there) if hunks else all(line in rest for line in lines)
                assert lines and stands, f"{name} has it otherwise"

    def example(self, pages, program):
        wrong, name, found = [], program.stem.removeprefix("example_"), set()
        for page, text in pages.items():
            for block in blocks_of(page, text):
                kind = re.fullmatch(rf"(from|output) (of )?{name}(\.\w+)?", block.mark)
                if kind:
                    found.add(kind[1])
                try:
                    if kind and kind[1] == "from":
                        self.quoted(block, block.mark[5:])
                    elif kind:
                        assert (said := run([program])) == block.code, f"it prints\n{said}"
                except AssertionError as error:
                    wrong.append(f"{block}: {error}")
        return wrong if len(found) == 2 else [f"no page quotes {name} and what it prints"]

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
        wrong, in_cpp = [], {}

        def attempt(where, function, *arguments):
            try:
                function(*arguments)
            except AssertionError as error:
                wrong.append(f"{where}: {error}")

        for page, text in pages.items():
            for block in blocks_of(page, text):
                kind, _, name = block.mark.partition(" ")
                if kind == "from":
                    attempt(block, self.quoted, block, name)
                elif kind in ("file", "output"):
                    pass
                elif block.language == "sh":
                    attempt(block, self.shell, block)
                elif block.language == "diff":
                    attempt(block, self.diff, block)
                elif block.language == "cpp":
                    in_cpp.setdefault(page, []).append(block)
        for page, blocks in in_cpp.items():
            attempt(page, self.cpp, page, blocks)
        return wrong


def check_programs(pages, prefix, work):
    """What a reader does: makes the files of a page, types its commands, and compares what is printed."""
    wrong, files, printed = [], 0, {}
    libraries = next(prefix.rglob("boomerang-core.pc")).parent
    environment = {**os.environ, "PKG_CONFIG_PATH": str(libraries), "LD_LIBRARY_PATH": str(libraries.parent)}
    for page, text in pages.items():
        typed = False
        for block in blocks_of(page, text):
            kind, _, name = block.mark.partition(" ")
            try:
                if kind == "file":
                    (work / name).write_text(block.code)
                    typed, files = True, files + 1
                elif typed and block.language == "sh":
                    typed = False
                    for line in block.code.splitlines():
                        said = run(["bash", "-c", line], cwd=work, env=environment)
                        printed.setdefault(line.split("#")[0].strip(), said)
                elif kind == "output" and f"./{block.mark[10:]}" in printed:
                    said = printed.pop(f"./{block.mark[10:]}")
                    assert said == block.code, f"it prints\n{said}"
            except AssertionError as error:
                wrong.append(f"{block}: {error}")
    wrong += [f"no page has what {line} prints" for line in printed if line.startswith("./")]
    return wrong if files else ["no page has a program"]


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


# Blocks that do not work, for the controls, and what is said of each.
BAD = {"recipes": ("```cmake\ncmake_minimum_required(VERSION 3.16)\nproject(game C CXX)\nset(BOX2D_BUILD_TESTBED OFF CACHE BOOL \"\")\nadd_subdirectory(box2d)\nboomerang_accelerate(box2d)\n```\n",
                   [r"a.md:2: .*Unknown CMake command"]),
       "pages": ("```sh\nboomerang-testbed events --nope\n```\n<!-- from queries.c -->\n```c\nint x;\n```\n```cpp\nbmr::Nothing x;\n```\n```sh\n./tests/run --sometimes\n```\n"
                 "```diff\n--- a/README.md\n+# Boomerang\n+Bumerang\n```\n```diff\n--- a/README.md\n@@ -1 +1 @@\n+# Boomerang\n+## What is promised\n```\n",
                 [r"a.md:2: .* has no --nope", r"a.md:6: queries.c has it otherwise", r"a.md:12: .* no --sometimes",
                  r"a.md:15: README.md has", r"a.md:20: README.md has", r"a.md: .*Block0"]),
       "example": ("<!-- from NAME.c -->\n```c\nint x;\n```\n<!-- output of NAME -->\n```\n2\n```\n", [r"a.md:3: .* has it otherwise", r"a.md:7: it prints"]),
       "programs": ("<!-- file a.c -->\n```c\n#include <stdio.h>\nint main(void) { puts(\"1\"); }\n```\n```sh\ncc a.c -o a\n./a\ncc b.c\n```\n<!-- output of a -->\n```\n2\n```\n",
                    [r"a.md:7: .*b\.c", r"a.md:13: it prints\n1"])}


def main():
    what, *places = sys.argv[1:5]
    root, other, work = (pathlib.Path(place).resolve() for place in places)

    def check(pages):
        run(["rm", "-rf", work])
        work.mkdir(parents=True)
        if what == "recipes":
            return check_recipes(pages, root, other, work, "build" in sys.argv[5:])
        if what == "example":
            return Checker(root, other, work).example(pages, other)
        return check_programs(pages, other, work) if what == "programs" else Checker(root, other, work).check(pages)

    text, wanted = BAD[what]
    found = check({"a.md": text.replace("NAME", other.stem.removeprefix("example_"))})
    if len(wanted) != len(found) or not all(re.match(pattern, line, flags=re.S) for pattern, line in zip(wanted, found)):
        sys.exit(f"FAILED: the control: not noticed: {wanted}\nnoticed: " + "\n".join(found))
    wrong = check({str(file.relative_to(root)): file.read_text() for pattern in PAGES for file in sorted(root.glob(pattern))})
    if wrong:
        sys.exit("FAILED:\n" + "\n".join(wrong))
    run(["rm", "-rf", work])
    print("passed")


if __name__ == "__main__":
    main()
