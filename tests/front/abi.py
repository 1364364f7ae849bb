#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a program that was compiled with an earlier version relies on, and whether it still holds.

    abi.py check ROOT LIB [WAS]     compares the libraries in LIB with the committed lists of symbols, and ROOT's headers with those in
                                    WAS (default: those of the last version that has a tag; where none has one, with nothing); 1 where
                                    something is gone or has changed
    abi.py add ROOT LIB             writes new symbols into the lists, with ROOT's version, and leaves the rest as it is
    abi.py anew ROOT LIB            writes the lists from nothing: before a new major version, and never else
    abi.py types ROOT c|cpp         prints what the headers say: constants, enumerations, records with their layout on x86-64, functions
                                    with their types, one a line

The lists, for the C libraries in core/abi and for the plugin in plugin/abi: libboomerang-NAME.symbols has every symbol of
libboomerang_NAME.so and the version that it came with, as Debian's packages have it (deb-symbols(5)). The linker's script is made
of those of core and kinetic.

Clang reads the headers; docs/stability.md says what is promised.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

LIBRARIES = {"core": "core/abi", "kinetic": "core/abi", "box2d": "plugin/abi"}
INCLUDES = {"c": ["core/include"], "cpp": ["core/include", "box2d_glue/include", "plugin/include"]}
HEADERS = {"c": ["core/include/boomerang"], "cpp": ["box2d_glue/include/boomerang", "plugin/include/boomerang"]}
# What core shows to libboomerang_kinetic alone, which comes from the same sources and asks for the same version.
PRIVATE = "BOOMERANG_PRIVATE"
REMEDY = "tests/front/abi.py add . build/lib"


def clang(root, language, source, *options):
    command = ["clang" if language == "c" else "clang++", "-x", "c" if language == "c" else "c++",
               "-std=c11" if language == "c" else "-std=c++17", "-fsyntax-only", "-"]
    command += [f"-I{root / folder}" for folder in INCLUDES[language]] + list(options)
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"clang does not take the public headers:\n{done.stderr}")
    return done.stdout


def include_all(root, language):
    """All public headers: a new one comes in by itself."""
    names = [header.name for folder in HEADERS[language] for header in sorted((root / folder).glob("*.h"))]
    if not names:
        sys.exit(f"no headers in {HEADERS[language]}")
    first = "#include <box2d/box2d.h>\n" if language == "cpp" else ""
    return first + "".join(f"#include <boomerang/{name}>\n" for name in names)


def values_of(enumeration):
    """(name, value) of each constant; a count of constants may grow, and is none of them."""
    value = -1
    for constant in enumeration.get("inner", []):
        if constant["kind"] != "EnumConstantDecl":
            continue
        given = [part["value"] for part in constant.get("inner", []) if "value" in part]
        value = int(given[0]) if given else value + 1
        if not constant["name"].lower().endswith("count"):
            yield constant["name"], value


def declarations(root, language, source):
    """What clang's syntax tree has of ours: (functions, enumerations, names of records)."""
    options = ["-Xclang", "-ast-dump=json"]
    if language == "cpp":
        options += ["-Xclang", "-ast-dump-filter=bmr::"]
    text = clang(root, language, source, *options)
    nodes, decoder, place = [], json.JSONDecoder(), 0
    while place < len(text):
        node, place = decoder.raw_decode(text, place)
        nodes += node.get("inner", []) if node["kind"] == "TranslationUnitDecl" else [node]
        while place < len(text) and text[place].isspace():
            place += 1
    functions, enums, records = {}, {}, set()
    for node in nodes:
        name = node.get("name", "")
        if language == "c" and (not name.lower().startswith("bmr_") or name.endswith("_")):
            continue
        if node["kind"] == "FunctionDecl" and language == "c":
            functions[name] = ("inline" if node.get("inline") else "function", node["type"]["qualType"])
        elif node["kind"] == "EnumDecl" and name:
            enums[name] = list(values_of(node))
        elif node["kind"] in ("RecordDecl", "CXXRecordDecl") and name and node.get("completeDefinition"):
            records.add(name)
    return functions, enums, records


def layouts(root, language, source, records):
    """The lines of clang's table of layouts, for records of ours."""
    scope, tag = ("", "struct ") if language == "c" else ("bmr::", "")
    asks = "".join(f"char ask_{name}[sizeof({tag}{scope}{name})];\n" for name in sorted(records))
    text = clang(root, language, source + asks, "-Xclang", "-fdump-record-layouts", "-Xclang", "-emit-llvm-only")
    for block in text.split("*** Dumping AST Record Layout\n")[1:]:
        lines = [line for line in block.splitlines() if "|" in line]
        head = re.match(r"\s*0 \| (?:struct|union|class) (\S+)", lines[0])
        if not head or head.group(1) not in {scope + name for name in records}:
            continue
        name = head.group(1)
        size = re.search(r"sizeof=(\d+).*?(?<!nv)align=(\d+)", block)
        yield f"record {name}: {size.group(1)} bytes, aligned to {size.group(2)}"
        for line in lines[1:]:
            member = re.match(r"\s*([\d:-]+) \|   (\S.*)$", line)  # members, not members of members
            if member:
                yield f"record {name} {member.group(1)}: {re.sub(r' at [^)]*|struct ', '', member.group(2))}"


def constants(root, source):
    """Macros of numbers: what is compiled into programs."""
    for line in clang(root, "c", source, "-E", "-dM").splitlines():
        macro = re.match(r"#define (BMR_\w+) (.*\d.*)$", line)
        if macro:
            yield f"constant {macro.group(1)} = {macro.group(2)}"


def types(root, language):
    source = include_all(root, language)
    functions, enums, records = declarations(root, language, source)
    lines = [f"{kind} {name}: {shape}" for name, (kind, shape) in functions.items()]
    lines += [f"enum {name} {constant} = {value}" for name, pairs in enums.items() for constant, value in pairs]
    lines += layouts(root, language, source, records)
    lines += constants(root, source) if language == "c" else []
    return sorted(set(lines)), {name for name, (kind, _) in functions.items() if kind == "function"}


def exported(library):
    """SYMBOL@NODE of all that a shared library defines."""
    text = subprocess.run(["nm", "-D", "--defined-only", "--with-symbol-versions", str(library)], capture_output=True, text=True, check=True).stdout
    found = {line.split()[-1].replace("@@", "@") for line in text.splitlines()}
    return {symbol for symbol in found if "@" in symbol and not symbol.startswith(("BOOMERANG_", "_init", "_fini"))}


def committed(file):
    """{SYMBOL@NODE: the rest of its line}"""
    rows = (line.split(maxsplit=1) for line in file.read_text().splitlines() if line.startswith(" ")) if file.exists() else ()
    return {row[0]: row[1] for row in rows}


def write_symbols(file, name, symbols):
    head = (f"libboomerang_{name}.so.1 libboomerang-{name}1 #MINVER#\n"
            f"| libboomerang-{name}1 (= #VERSION#)\n")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(head + "".join(f" {symbol} {rest}\n" for symbol, rest in sorted(symbols.items())))


def show_new(root, libraries, names, version):
    """Writes public functions that no library shows yet into the list of the one that has them; the next build shows them."""
    for name in LIBRARIES:
        archive, file = libraries / f"libboomerang_{name}.a", root / LIBRARIES[name] / f"libboomerang-{name}.symbols"
        if not archive.exists() or not names:
            continue
        text = subprocess.run(["nm", "--defined-only", "--extern-only", str(archive)], capture_output=True, text=True, check=True).stdout
        ours = names & {line.split()[-1] for line in text.splitlines() if line}
        write_symbols(file, name, {**committed(file), **{f"{symbol}@BOOMERANG_1": version for symbol in ours}})
        print("".join(f"{symbol}: in {file.name}; the next build shows it\n" for symbol in sorted(ours)), end="")


def compare(what, was, now, grows=False):
    """Prints what differs. False where something is gone or has changed, and where something is new that is to be listed."""
    for line in sorted(was - now):
        print(f"GONE or changed ({what}): {line}")
    for line in sorted(now - was):
        print(f"NEW ({what}): {line}")
    return was <= now and (grows or was == now)


def last_release(root, folder):
    """Lays the headers of the last version that has a tag into `folder`. False: none has one."""
    git = ["git", "-C", str(root)]
    tag = subprocess.run([*git, "describe", "--tags", "--abbrev=0", "--match", "v*"], capture_output=True, text=True, check=False).stdout.strip()
    if not tag:
        return False
    headers = subprocess.run([*git, "archive", tag, *INCLUDES["cpp"]], capture_output=True, check=True).stdout
    subprocess.run(["tar", "-x", "-C", folder], input=headers, check=True)
    return True


def check_types(root, was):
    """Are the headers of `was` still what they were? What is new is welcome."""
    good = True
    for language in HEADERS:
        good = compare(language, set(types(was, language)[0]), set(types(root, language)[0]), grows=True) and good
    return good


def check_public(root, public):
    """Each function of core's headers is in a list of symbols, and the other way round."""
    functions = types(root, "c")[1]
    for name in sorted(functions - public):
        print(f"NOT SHOWN: {name} is in a public header, and in no .symbols; to have it shown: {REMEDY}")
    for name in sorted(public - functions):
        print(f"NOT PUBLIC: {name} is in a .symbols, and in no public header")
    return functions == public


def symbols(action, root, libraries, version):
    """Compares or writes the lists: (are they as they were?, the public functions of core)."""
    good, public = True, set()
    for name, folder in LIBRARIES.items():
        library, file = libraries / f"libboomerang_{name}.so", root / folder / f"libboomerang-{name}.symbols"
        if not library.exists():
            sys.exit(f"there is no {library}")
        was, now = committed(file), exported(library)
        if action == "check":
            good = compare(file.name, set(was), now) and good
        else:
            rest = {symbol: version + (" 1" if symbol.endswith("@" + PRIVATE) else "") for symbol in now}
            write_symbols(file, name, {**rest, **({} if action == "anew" else was)})
        if name != "box2d":
            public |= {symbol.split("@")[0] for symbol in now if not symbol.endswith("@" + PRIVATE)}
    if not good:
        print(f"to have new symbols kept from now on: {REMEDY}")
    return good, public


def main():
    arguments = sys.argv[1:]
    if len(arguments) not in (3, 4) or arguments[0] not in ("check", "add", "anew", "types") or (len(arguments) == 4) > (arguments[0] == "check"):
        sys.exit(__doc__)
    action, root = arguments[0], pathlib.Path(arguments[1])
    if action == "types":
        print("\n".join(types(root, arguments[2])[0]))
        return
    libraries = pathlib.Path(arguments[2])
    version = re.search(r"VERSION (\d+\.\d+\.\d+) LANGUAGES", (root / "CMakeLists.txt").read_text()).group(1)
    good, public = symbols(action, root, libraries, version)
    if action != "check":
        show_new(root, libraries, types(root, "c")[1] - public, version)
        return
    good = check_public(root, public) and good
    with tempfile.TemporaryDirectory() as folder:
        if len(arguments) == 4:
            good = check_types(root, pathlib.Path(arguments[3])) and good
        elif last_release(root, folder):
            good = check_types(root, pathlib.Path(folder)) and good
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
