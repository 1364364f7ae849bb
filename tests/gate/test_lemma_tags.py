#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_lemma_tags.py ROOT

A lemma is found where it is realised and where it is tested: the table "statements" of core/README.md names both, and both
carry the statement as a comment "/// Lemma 3.3(a): ...". No row without its tags, no tag without its row, and the numbered
statements are the paper's, all of them. Other tests that the page names are there, too."""
import pathlib
import re
import sys

ROOT, TABLE = pathlib.Path(sys.argv[1]), "core/README.md"
NUMBERED = {f"Lemma {of}" for of in "3.1 3.2 3.3(a) 3.3(b) 3.3(c) 3.3(d) 3.4(a) 3.4(b) 3.4(c) 3.4(d) 4.1 4.2 4.3 4.4(a) 4.4(b) 6.1".split()}
NUMBERED |= {f"Theorem {of}" for of in "5.1 5.2 5.3 6.2".split()}


def places(page):
    """(file, function, tag, statement) of each place where the table wants a tag."""
    for row in re.findall(r"^\| (.*) \|$", page.partition("<!-- statements -->\n")[2].partition("\n\n")[0], re.M)[2:]:
        tag, says, code, test, _ = row.split(" | ")
        for folder, column in (("core/", code), ("tests/", test)):
            for file, name in re.findall(r"`(.*?)`: `(.*?)`", column) or [("", "")]:
                yield folder + file, name, re.sub(r" \([a-z][a-z0-9-]+\)$", "", tag), says + "."


def tags(file, text):
    """The same of all tags of a file: those above a line that is no comment are of the function that it names."""
    above = []
    for line in text.split("\n"):
        tag = re.match(r"/// ((?:Lemma|Theorem) [0-9][^:]*|Section [0-9]+, [^:]*(?=: ))(?:: (.*))?$", line)
        if tag:
            above.append((tag[1], tag[2] or ""))
        elif not line.startswith("//"):
            name = re.sub(r".*[ *]", "", re.sub(r"[()].*", "", line.removeprefix("TEST(")))
            yield from ((file, name, *of) for of in above)
            above = []


def wrong(texts):
    """What is wrong, a line each."""
    asked = set(places(texts[TABLE]))
    there = {tag for file, text in texts.items() if file != TABLE for tag in tags(file, text)}
    rows = {tag for _, _, tag, _ in asked if not tag.startswith("Section")}
    return "\n".join([f"the table has no {tag}" for tag in NUMBERED - rows] +
                     [f"the paper has no {tag}, which the table has" for tag in rows - NUMBERED] +
                     [f'{file}: {name} has no "/// {tag}: {says}"' for file, name, tag, says in asked - there] +
                     [f"{file} has no {name}" for file, name in re.findall(r"`(claims/[^`]*)`: `([^`]*)`", texts[TABLE])
                      if name not in texts.get("tests/" + file, "")] +
                     [f"{file}: {name} has a tag that no row of the table has: {tag}: {says}" for file, name, tag, says in there - asked])


texts = {str(file.relative_to(ROOT)): file.read_text() for folder in ("core", "tests/claims") for file in (ROOT / folder).rglob("*")
         if file.suffix in (".c", ".h", ".cpp")}
texts[TABLE] = (ROOT / TABLE).read_text()
failed = wrong(texts)

# What is wrong in a copy in which one thing is another.
CONTROLS = [
    ("bmr_hierarchy_height has no \"/// Lemma 3.1", "core/hierarchy/query.c", r"/// Lemma 3.1:[^\n]*\n", ""),
    ("the_tiling_is_of_linear_size has no \"/// Lemma 4.1", "tests/claims/test_mixed.c", r"/// Lemma 4.1:[^\n]*\n", ""),
    ("bmr_hierarchy_height has no", "core/hierarchy/query.c", r"(?s)(/// Lemma 3.1:[^\n]*\n)(.*?\n}\n)", r"\2\1void other(void) {\n}\n"),
    ("has no \"/// Lemma 4.1", "core/hierarchy/mixed_tiling.c", r"(/// Lemma 4.1: .*?)m\) cells", r"\1n) cells"),
    ("a tag that no row of the table has: Lemma 9.9", "core/hierarchy/compass.c", r"/// Lemma 3.3\(a\)", r"/// Lemma 9.9: all is well.\n\g<0>"),
    ("a tag that no row of the table has: Lemma 3.2", "core/geometry/hull.c", r"\nstatic ", r"\n/// Lemma 3.2\nstatic "),
    ("test_pair.c has no a_flat_box_sliding", "tests/claims/test_pair.c", "a_flat_box", "a_round_box"),
    ("the paper has no Lemma 9.9", TABLE, r"\| Lemma 3.1 ", "| Lemma 9.9 "),
    ("the table has no Theorem 5.3", TABLE, r"\| Theorem 5.3 [^\n]*\n", ""),
    ("the table has no Lemma 3.1", TABLE, "<!-- statements -->", ""),
]
for said, file, pattern, other in CONTROLS:
    changed = re.sub(pattern, other, texts[file], count=1)
    if changed == texts[file] or said not in wrong(texts | {file: changed}):
        failed += f"\nnot noticed: {pattern} in {file}"
print(failed or "passed")
sys.exit(bool(failed))
