#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares two SVG pictures by structure and numbers: compare_svg.py GOLDEN OTHER.

The same shapes in the same order, with the same colours and widths, every coordinate within a twentieth of a
point. Letters are left out: their outlines are the font's. Exit status 1 and a line that says where, if they
differ.
"""
import re
import sys
import xml.etree.ElementTree as ET

TOLERANCE = 0.05  # points: below what anybody sees, above what other libm's last bits do
COLOUR_TOLERANCE = 0.5  # per cent
STYLES = ("fill", "fill-opacity", "stroke", "stroke-opacity", "stroke-width", "stroke-dasharray")
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def local(tag):
    return tag.rsplit("}", 1)[-1]


def styles_of(element):
    style = dict(part.split(":", 1) for part in element.get("style", "").split(";") if ":" in part)
    values = {key.strip(): value.strip() for key, value in style.items()}
    values.update({key: element.get(key) for key in STYLES if element.get(key)})
    return [(key, values[key]) for key in STYLES if key in values]


def shapes_of(path):
    """(kind, styles, words and numbers) of every shape, in order."""
    shapes = []

    def walk(element):
        kind = local(element.tag)
        if kind in ("defs", "symbol", "use", "clipPath"):
            return
        if kind in ("path", "rect", "circle", "ellipse", "line", "polyline", "polygon"):
            text = " ".join(element.get(key, "") for key in ("d", "points", "x", "y", "width", "height", "transform"))
            shapes.append((kind, styles_of(element), text))
        for child in element:
            walk(child)

    walk(ET.parse(path).getroot())
    return shapes


def split(text):
    return NUMBER.sub("#", text).split(), [float(number) for number in NUMBER.findall(text)]


def differ(a, b, tolerance):
    words, numbers = split(a)
    other_words, other_numbers = split(b)
    if words != other_words or len(numbers) != len(other_numbers):
        return True
    return any(abs(x - y) > tolerance for x, y in zip(numbers, other_numbers))


def main():
    golden, other = (shapes_of(path) for path in sys.argv[1:3])
    if len(golden) < 10:
        sys.exit(f"{sys.argv[1]}: {len(golden)} shapes are no picture")
    if len(golden) != len(other):
        sys.exit(f"{len(golden)} shapes, but {len(other)}")
    for index, (a, b) in enumerate(zip(golden, other)):
        if a[0] != b[0] or differ(a[2], b[2], TOLERANCE):
            sys.exit(f"shape {index}: {a[0]} {a[2][:90]}, but {b[0]} {b[2][:90]}")
        if len(a[1]) != len(b[1]) or any(
            x[0] != y[0] or differ(x[1], y[1], COLOUR_TOLERANCE) for x, y in zip(a[1], b[1])
        ):
            sys.exit(f"shape {index}: style {a[1]}, but {b[1]}")


main()
