#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes first scripts for fuzz_glue: seeds.py DIRECTORY [COUNT [FIRST]]

A header, a few bodies, then steps with actions between them (script.h): what chance finds only after long. In every
eighth, bodies of many fixtures beside each other, whose vertices are pulled about within them; in another one, worlds that are
emptied, crowded and listened to by others. The same files every time.
"""
import pathlib
import random
import sys

FIRST_STEP = 160
ACTIONS = 47
LATER = [157, 158, 159]  # emptying, a crowd, other listeners (script.cpp: kLaterActions)
CREATING = [0, 1, 2, 3, 4]


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


def seed(number: int) -> bytes:
    rng = random.Random(number)
    if number % 8 == 7:
        return rows(rng)
    script = [rng.choice([0, 2, 4, 8, 8, 8, 8, 10, 12, 32, 40]), rng.choice([0, 0, 0, 64, 64, rng.randrange(256)])]
    for _ in range(rng.randrange(3, 14)):
        script += [rng.choice(CREATING), rng.choice([0, 1, 8, 16, 24, 192, 208, rng.randrange(256)])]
        script += [rng.randrange(256), rng.randrange(256), rng.choice([0, 0, rng.randrange(256)])]
        script += [rng.randrange(256) for _ in range(rng.randrange(2, 6))]
    for _ in range(rng.randrange(4, 14)):
        script.append(rng.randrange(FIRST_STEP, 256))
        for _ in range(rng.randrange(0, 4)):
            script.append(rng.choice(LATER) if number % 8 == 6 and rng.randrange(4) == 0 else rng.randrange(ACTIONS))
            script += [rng.randrange(256) for _ in range(rng.randrange(1, 5))]
    return bytes(script)


def main() -> int:
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    directory = pathlib.Path(sys.argv[1])
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    directory.mkdir(parents=True, exist_ok=True)
    for number in range(first, first + count):
        (directory / f"seed-{number:05d}").write_bytes(seed(number))
    return 0


if __name__ == "__main__":
    sys.exit(main())
