#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Where a kinetic world's instructions go: cells, disks and the queue; structures; failure times and roots. Under callgrind, so
# the shares repeat themselves whatever else the machine does.
set -euo pipefail

usage() {
    cat <<'TEXT'
usage: world_share.sh BUILD_DIRECTORY ARGUMENTS-OF-boomerang-testbed-world...

    world_share.sh build gas --bodies 10000 --boundary periodic --shape regular --sizes 1 --density 0.3 --seconds 0.2

What bmr_world_advance does is counted. A function counts to the room whose object file has it (nm), with its own instructions
alone; GSL's count to the roots, and libm's and those of malloc stand by themselves.
Exit codes: 0 done; 2 wrong usage; 3 a program failed.
TEXT
}

[[ ${1:-} != --help ]] || { usage; exit 0; }
[[ $# -ge 1 && -x $1/bin/boomerang-testbed ]] || { usage >&2; exit 2; }
build=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
valgrind --tool=callgrind --toggle-collect=bmr_world_advance --callgrind-out-file="$scratch/out" "$build/bin/boomerang-testbed" world "$@" --quiet 2>"$scratch/err" ||
    { cat "$scratch/err" >&2; exit 3; }
callgrind_annotate --threshold=100 "$scratch/out" >"$scratch/annotated"

# "function object" of all of core's functions, static ones as well.
(cd "$build/core" && find . -name '*.o' -print0 | while IFS= read -r -d '' object; do
    nm "$object" | awk -v object="$object" '$2 ~ /^[tT]$/ { print $3, object }'
done) >"$scratch/functions"

python3 - "$scratch/functions" "$scratch/annotated" <<'PYTHON'
import collections, re, sys

BROAD = ("cells", "resident", "agenda", "gate", "memory")
room_of = {}
for line in open(sys.argv[1]):
    name, source = line.split()
    if "/world/" in source:
        broad = source.split("/")[-1].split(".")[0] in BROAD
        room = "broad phase: cells, disks, queue" if broad else "pairs and contacts"
    elif "boomerang_kinetic.dir" in source:
        room = "failure times and roots"
    else:
        room = "structures and geometry"
    room_of.setdefault(name, set()).add(room)
shares, all_of_it = collections.Counter(), 0
for line in open(sys.argv[2]):
    match = re.match(r"\s*([\d,]+) \(\s*[\d.]+%\)\s+(\S+?):(\S+)(.*)", line)
    if not match or "PROGRAM TOTALS" in line:
        continue
    count, name, rest = int(match[1].replace(",", "")), match[3], match[4]
    all_of_it += count
    plain = re.sub(r"('\d+|\.(constprop|part|isra|cold)\.?\d*)+$", "", name)
    rooms = room_of.get(plain) or room_of.get(name)
    if rooms:
        for room in rooms: # a static function's name in several files: an equal part each
            shares[room] += count / len(rooms)
    elif "libgsl" in rest:
        shares["failure times and roots"] += count
    elif "libm" in rest or "/math/" in line or "fpu" in line:
        shares["libm: sines and lengths"] += count
    else:
        shares["all else: memory, what calls"] += count
print(f"{all_of_it:,} instructions")
for room, count in shares.most_common():
    print(f"{100 * count / all_of_it:5.1f} %  {room}")
PYTHON
