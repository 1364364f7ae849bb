# SPDX-License-Identifier: MIT
"""What core's public headers say, as clang reads them: records with their layout, functions with their types."""
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


def declarations(root, source):
    """What clang's syntax tree has of ours: ({function: type}, names of records)."""
    nodes = json.loads(clang(root, source, "-Xclang", "-ast-dump=json"))["inner"]
    functions, records = {}, set()
    for node in nodes:
        name = node.get("name", "")
        if not name.lower().startswith("bmr_") or name.endswith("_"):
            continue
        if node["kind"] == "FunctionDecl":
            functions[name] = node["type"]["qualType"]
        elif node["kind"] == "RecordDecl" and name and node.get("completeDefinition"):
            records.add(name)
    return functions, records


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


def types(root):
    source = include_all(root)
    functions, records = declarations(root, source)
    return sorted({*(f"function {name}: {shape}" for name, shape in functions.items()), *layouts(root, source, records)})
