#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_gif.py FILE PICTURES WIDTH: a GIF of so many pictures, that plays for ever, with the delays and areas it should have.

Reads the blocks as the specification (GIF89a) has them; the pixels are not decoded.
"""

import sys

path, pictures, width = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
data = open(path, "rb").read()
assert data[:6] == b"GIF89a", "not a GIF89a"
size = int.from_bytes(data[6:8], "little"), int.from_bytes(data[8:10], "little")
assert size[0] == width, f"{size[0]} wide"
assert data[10] & 0x80 == 0, "a global palette"


def blocks(at):
    """The bytes of a chain of sub-blocks, and where it ends."""
    got = b""
    while data[at]:
        got += data[at + 1:at + 1 + data[at]]
        at += 1 + data[at]
    return got, at + 1


at, delays, areas, loops = 13, [], [], None
while data[at] != 0x3B:
    if data[at] == 0x21:
        label = data[at + 1]
        body, at = blocks(at + 2)
        if label == 0xF9:
            delays.append(int.from_bytes(body[1:3], "little"))
        elif label == 0xFF:
            assert body[:11] == b"NETSCAPE2.0"
            loops = int.from_bytes(body[12:14], "little")
    else:
        assert data[at] == 0x2C, f"no block begins with {data[at]:#x}"
        left, top, wide, high = (int.from_bytes(data[at + i:at + i + 2], "little") for i in (1, 3, 5, 7))
        areas.append((left, top, wide, high))
        assert data[at + 9] & 0x80, "no palette of its own"
        body, at = blocks(at + 10 + 3 * 2 ** ((data[at + 9] & 7) + 1) + 1)
        assert body, "no pixels"
assert at == len(data) - 1, "something behind the end"
assert len(areas) == len(delays) == pictures, f"{len(areas)} pictures"
assert loops == 0, "it ends"
assert areas[0] == (0, 0, *size), "the first picture is not whole"
assert all(left + wide <= size[0] and top + high <= size[1] for left, top, wide, high in areas)
assert any(area != areas[0] for area in areas[1:]), "what does not change is written again"
# Two steps of a sixtieth of a second: 3.33 hundredths, and what is rounded off is made good.
assert set(delays) == {3, 4} and abs(sum(delays) - 100 * pictures * 2 / 60) < 1, delays
