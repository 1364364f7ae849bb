# SPDX-License-Identifier: MIT
"""What core's public headers say, as clang reads them: constants, enumerations, records with their layout, functions with their types."""
import json
import re
import subprocess
import sys

INCLUDE = "core/include"


def clang(root, source, *options):
    command = ["clang", "-x", "c", "-std=c11", "-fsyntax-only", "-", f"-I{root / INCLUDE}", *options]
    done = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"clang does not take the public headers:\n{done.stderr}")
    return done.stdout


def include_all(root):
    """All public headers: a new one comes in by itself."""
    return "".join(f"#include <boomerang/{header.name}>\n" for header in sorted((root / INCLUDE / "boomerang").glob("*.h")))


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


def declarations(root, source):
    """What clang's syntax tree has of ours: (functions, enumerations, names of records)."""
    nodes = json.loads(clang(root, source, "-Xclang", "-ast-dump=json"))["inner"]
    functions, enums, records = {}, {}, set()
    for node in nodes:
        name = node.get("name", "")
        if not name.lower().startswith("bmr_") or name.endswith("_"):
            continue
        if node["kind"] == "FunctionDecl":
            functions[name] = ("inline" if node.get("inline") else "function", node["type"]["qualType"])
        elif node["kind"] == "EnumDecl" and name:
            enums[name] = list(values_of(node))
        elif node["kind"] == "RecordDecl" and name and node.get("completeDefinition"):
            records.add(name)
    return functions, enums, records


def layouts(root, source, records):
    """The lines of clang's table of layouts, for records of ours."""
    asks = "".join(f"char ask_{name}[sizeof(struct {name})];\n" for name in sorted(records))
    text = clang(root, source + asks, "-Xclang", "-fdump-record-layouts", "-Xclang", "-emit-llvm-only")
    for block in text.split("*** Dumping AST Record Layout\n")[1:]:
        lines = [line for line in block.splitlines() if "|" in line]
        head = re.match(r"\s*0 \| (?:struct|union) (\S+)", lines[0])
        if not head or head.group(1) not in records:
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
    for line in clang(root, source, "-E", "-dM").splitlines():
        macro = re.match(r"#define (BMR_\w+) (.*\d.*)$", line)
        if macro:
            yield f"constant {macro.group(1)} = {macro.group(2)}"


def types(root):
    source = include_all(root)
    functions, enums, records = declarations(root, source)
    lines = [f"{kind} {name}: {shape}" for name, (kind, shape) in functions.items()]
    lines += [f"enum {name} {constant} = {value}" for name, pairs in enums.items() for constant, value in pairs]
    return sorted({*lines, *layouts(root, source, records), *constants(root, source)})
