#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes first inputs for a fuzzer: seeds.py FUZZER DIRECTORY [COUNT]

Every byte string is an input (bytes.h), so these are the choices of the first bytes, one after another, and bytes at
random behind them: some even, some small numbers, some long runs of one byte. The same files every time.
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


def main() -> int:
    if len(sys.argv) < 3 or sys.argv[1].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 400
    directory = pathlib.Path(sys.argv[2])
    directory.mkdir(parents=True, exist_ok=True)
    rng = random.Random(sys.argv[1])
    for i in range(count):
        (directory / f"seed-{i:03d}").write_bytes(seed(rng, i))
    return 0


if __name__ == "__main__":
    sys.exit(main())
