#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""test_mutate.py DIRECTORY [CMAKE_ARGUMENT...]: whether `mutate` finds what it should, and judges as it should.

The sites of sample.c are those of sample.txt; of one small file of core, a fault that its test knows is killed, one that
changes no answer survives, a comment changes no object code, and what is no C does not compile.
"""
import importlib.machinery
import importlib.util
import pathlib
import sys

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import sites  # noqa: E402
import workshop  # noqa: E402

SUBJECT, TEST = "core/geometry/predicates.c", "test_predicates"
failures = []


def expect(what, got, wanted):
    print(f"{'passed' if got == wanted else 'FAILED'}: {what}")
    if got != wanted:
        failures.append(what)
        print(f"  wanted {wanted!r}\n  got    {got!r}")


def load_mutate():
    loader = importlib.machinery.SourceFileLoader("mutate", str(HERE / "mutate"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("mutate", loader))
    loader.exec_module(module)
    return module


def listing(mutate, text):
    return [f"{s.line}:{s.column} {s.operator}: {mutate.describe(s, text)[1]}" for s in sites.sites_of("sample.c", text)]


def check_sites(mutate):
    text = (HERE / "sample.c").read_text()
    expect("the sites of sample.c", listing(mutate, text), (HERE / "sample.txt").read_text().splitlines())
    names = [sites.name_of(site) for site in sites.sites_of("sample.c", text)]
    expect("each site has a name of its own", len(set(names)), len(names))
    sources = {"a/one.c": text, "b/two.c": text + text, "c/three.h": "int x;\n"}
    few, many = (mutate.sample(sources, "1", count) for count in (9, 30))
    expect("a larger sample begins with the smaller one", many[:9], few)
    expect("a folder has its share by lines", sum(site.file == "a/one.c" for site in few), 3)
    expect("another seed, another sample", mutate.sample(sources, "2", 9) == few, False)


def check_verdicts(directory, arguments):
    shop = workshop.Workshop(directory, arguments, f"^{TEST}$")
    shop.fill(HERE.parents[1])
    shop.prepare(TEST)
    expect("the test passes without a mutant", (shop.try_out((1.0,)), [test.name for test in shop.tests]), ([], [TEST]))
    text = (shop.source / SUBJECT).read_text()
    after = {sites.apply(site, text) for site in sites.sites_of(SUBJECT, text)}

    def verdict(made):
        return shop.judge(SUBJECT, made, (1.0,))[:2]

    killed = text.replace("determinant = left - right", "determinant = left + right")
    expect("a sign that is another is among the sites", killed in after, True)
    expect("a sign that is another is killed", verdict(killed), ("killed", TEST))
    # The bound is above zero: what equals it has the sign that the exact path finds.
    survivor = text.replace("determinant > bound", "determinant >= bound")
    expect("a bound that is another is among the sites", survivor in after, True)
    expect("a bound that may be another survives", verdict(survivor), ("survived", "1 tests"))
    expect("a comment is no other object code", verdict(text + "// more\n")[0], "equivalent")
    expect("what is no C does not compile", verdict(text + "int int;\n")[0], "does not compile")
    expect("the file is what it was", (shop.source / SUBJECT).read_text() == text, True)
    expect("what waits too long is ended", workshop.run(["sleep", "60"], "/", 0.1)[0], None)
    expect("what computes too long is ended", workshop.run(["sh", "-c", "while :; do :; done"], "/", 1.0)[0], None)


if __name__ == "__main__":
    module = load_mutate()
    if sys.argv[1:] == ["--list"]:
        print("\n".join(listing(module, (HERE / "sample.c").read_text())))
        sys.exit(0)
    check_sites(module)
    check_verdicts(sys.argv[1], sys.argv[2:])
    print(f"{len(failures)} failed")
    sys.exit(1 if failures else 0)
