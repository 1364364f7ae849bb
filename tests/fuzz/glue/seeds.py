#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes first scripts for fuzz_glue: seeds.py DIRECTORY [COUNT [FIRST]]

A header, a few bodies, then steps with actions between them (script.h): what chance finds only after long. The same
files every time.
"""
import pathlib
import random
import sys

FIRST_STEP = 160
ACTIONS = 47
CREATING = [0, 1, 2, 3, 4]


def seed(number: int) -> bytes:
    rng = random.Random(number)
    script = [rng.choice([0, 2, 4, 8, 8, 8, 8, 10, 12, 32, 40]), rng.choice([0, 0, 0, 64, 64, rng.randrange(256)])]
    for _ in range(rng.randrange(3, 14)):
        script += [rng.choice(CREATING), rng.choice([0, 1, 8, 16, 24, 192, 208, rng.randrange(256)])]
        script += [rng.randrange(256), rng.randrange(256), rng.choice([0, 0, rng.randrange(256)])]
        script += [rng.randrange(256) for _ in range(rng.randrange(2, 6))]
    for _ in range(rng.randrange(4, 14)):
        script.append(rng.randrange(FIRST_STEP, 256))
        for _ in range(rng.randrange(0, 4)):
            script.append(rng.randrange(ACTIONS))
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
