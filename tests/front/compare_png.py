#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares two PNG pictures as eyes do: compare_png.py GOLDEN OTHER [TOLERANCE].

Of the same size, and no patch of 8 by 8 pixels of a colour that differs by more than the tolerance (of 255, mean
over the patch, 12 by default): smoothing of edges and letters passes, a shape that is missing, moved or of another
colour does not. Exit status 1 and a line that says where, if they differ. Reads what cairo writes: 8 bits, RGB or
RGBA, not interlaced.
"""
import struct
import sys
import zlib

PATCH = 8


def read(path):
    """Width, height, bytes a pixel, and the rows."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        sys.exit(f"{path} is no PNG")
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", data[at + 8 : at + 8 + length])
        elif kind == b"IDAT":
            packed += data[at + 8 : at + 8 + length]
        at += 12 + length
    width, height, depth, colour, _, _, interlaced = header
    if depth != 8 or colour not in (2, 6) or interlaced:
        sys.exit(f"{path} is not of the kind that cairo writes")
    size = 3 if colour == 2 else 4
    return width, height, size, unfilter(zlib.decompress(packed), width * size, height, size)


def paeth(a, b, c):
    pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def unfilter(raw, stride, height, size):
    rows, above = [], bytearray(stride)
    for y in range(height):
        kind, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for x in range(stride if kind else 0):
            left = row[x - size] if x >= size else 0
            corner = above[x - size] if x >= size else 0
            guess = (left, above[x], (left + above[x]) // 2, paeth(left, above[x], corner))[kind - 1]
            row[x] = (row[x] + guess) & 255
        rows.append(row)
        above = row
    return rows


def main():
    tolerance = float(sys.argv[3]) if len(sys.argv) > 3 else 12.0
    (width, height, size, a), (other_width, other_height, other_size, b) = map(read, sys.argv[1:3])
    if (width, height) != (other_width, other_height):
        sys.exit(f"{width} by {height}, but {other_width} by {other_height}")
    for top in range(0, height, PATCH):
        for left in range(0, width, PATCH):
            rows, columns = range(top, min(top + PATCH, height)), range(left, min(left + PATCH, width))
            for channel in range(3):
                mean = sum(a[y][x * size + channel] - b[y][x * other_size + channel] for y in rows for x in columns)
                mean /= len(rows) * len(columns)
                if abs(mean) > tolerance:
                    sys.exit(f"the patch at {left}, {top} differs by {mean:.1f} of 255 in channel {channel}")


main()
