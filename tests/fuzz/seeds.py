#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes first inputs for a fuzzer: seeds.py FUZZER DIRECTORY [COUNT]

Every byte string is an input (bytes.h), so these are the choices of the first bytes, one after another, and bytes at
random behind them: some even, some small numbers, some long runs of one byte. The same files every time. For fuzz_glue
every eighth is a script: bodies of many fixtures beside each other, whose vertices are pulled about within them.
"""
import pathlib
import random
import sys


def seed(rng: random.Random, i: int) -> bytes:
    length = rng.choice([12, 24, 48, 96, 192, 384, 768])
    head = bytes([i % 256, rng.randrange(256), (37 * i) % 256])
    kind = i % 4
    if kind == 0:
        body = rng.randbytes(length)
    elif kind == 1:
        body = bytes(rng.randrange(16) for _ in range(length))
    elif kind == 2:
        body = b"".join(bytes([rng.randrange(256)]) * rng.randrange(1, 9) for _ in range(length // 4))
    else:
        body = rng.randbytes(4) * (length // 4)
    return head + body


def row(x: int, y: int) -> list[int]:
    """Creates a body of seven upright boxes in a diagonal row (script_bodies.cpp: CreateBody)."""
    made = [0, 192, x % 256, y % 256, 0, 5]
    for i in range(-3, 4):
        made += [8, 0, 4, 2, 1]
        for side_x, side_y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            made += [(26 * i + 24 * side_x) % 256, (26 * i + 24 * side_y) % 256]
    return made


def rows(rng: random.Random) -> bytes:
    """Two rows without gravity, and before each of some steps a fixture of each is pulled about (script_shapes.cpp)."""
    aside = rng.randrange(15, 18)
    script = [2, 0] + row(0, 0) + row(-aside, aside) + [160]
    for _ in range(24):
        for body in range(2):
            script += [26, body, rng.randrange(7), 0xE1, 0x0F]
            for _ in range(4):
                script += [rng.randrange(7), rng.randrange(4), rng.randrange(256)]
        script.append(160)
    return bytes(script)


def main() -> int:
    if len(sys.argv) < 3 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 400
    directory = pathlib.Path(sys.argv[2])
    directory.mkdir(parents=True, exist_ok=True)
    rng = random.Random(sys.argv[1])
    for i in range(count):
        is_script = sys.argv[1] == "fuzz_glue" and i % 8 == 7
        (directory / f"seed-{i:03d}").write_bytes(rows(rng) if is_script else seed(rng, i))
    return 0


if __name__ == "__main__":
    sys.exit(main())
