# SPDX-License-Identifier: MIT
"""What the pages say beside what was measured: Markdown tables, numbers as they were rounded, fits, files."""
import collections
import csv
import math
import re

NUMBER = re.compile(r"[-+]?\d[\d,]*\.?\d*")


class Result:
    """What one experiment found. `cells`: how many figures were held against each other; `wrong`: a line for each that differs;
    `ratios`: measured over committed, where nothing is to be equal; `note`: what else is to be said."""

    def __init__(self):
        self.cells, self.wrong, self.ratios, self.note = 0, [], [], ""

    def number(self, where, committed, measured):
        """Does the measured number, rounded as the committed text is, say the same? (Half of its last digit, either way.)"""
        self.cells += 1
        text = committed.replace(",", "")
        decimals = len(text.partition(".")[2])
        if not abs(measured - float(text)) <= 0.5 * 10**-decimals * (1 + 1e-9):
            self.wrong.append(f"{where}: {committed} in the page, {measured:.{decimals + 1}f} measured")

    def ratio(self, committed, measured):
        self.cells += 1
        value = float(committed.replace(",", ""))
        if value != 0:
            self.ratios.append(measured / value)


def table_after(text, anchor, index=0):
    """The rows of the Markdown table number `index` after a text, each a list of cells, the head first."""
    start = text.index(anchor) + len(anchor)
    tables = re.findall(r"(?:^\|.*\|[^\n]*\n)+", text[start:], flags=re.M)
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in tables[index].splitlines()]
    return [row for row in rows if not re.fullmatch(r"[-: ]+", row[0]) or any(re.search(r"\w", cell) for cell in row)]


def block_with(text, line):
    """The lines of the fenced block that has this line."""
    for block in re.findall(r"^```[^\n]*\n(.*?)^```", text, flags=re.S | re.M):
        if line in block.splitlines():
            return block.splitlines()
    raise ValueError(f"no fenced block has the line {line!r}")


class Events:
    """What `boomerang-testbed events --csv` wrote."""

    def __init__(self, path):
        self.rows = collections.defaultdict(list)
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                self.rows[row["motion"], row["structure"], float(row["wanted_ratio"])].append(row)
        self.ratios = sorted({key[2] for key in self.rows})

    def mean(self, motion, structure, ratio, column="events"):
        rows = self.rows[motion, structure, float(ratio)]
        return sum(float(row[column]) for row in rows) / len(rows)

    def means(self, motion, structure):
        return [self.mean(motion, structure, ratio) for ratio in self.ratios]


def slope(x, y):
    """Least squares of y on x."""
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def exponent(x, y):
    pairs = [(math.log(a), math.log(b)) for a, b in zip(x, y) if b > 0]
    return slope([a for a, _ in pairs], [b for _, b in pairs])


def same_file(result, made, committed):
    """Byte for byte."""
    result.cells += 1
    if not made.exists():
        result.wrong.append(f"{committed.name}: was not made")
    elif made.read_bytes() != committed.read_bytes():
        result.wrong.append(f"{committed.name}: differs from {made}")


def rows_as_ratios(result, page, printed):
    """Of the Markdown tables that a command printed, each row that a page has, too: by its first cell, number by number."""
    def numbers(cells):
        return [match.group() for cell in cells for match in NUMBER.finditer(cell)]

    def rows(text):
        lines = [line.strip().strip("|").split("|") for line in text.splitlines() if line.startswith("|")]
        return {re.sub(r"\W+", " ", cells[0]).strip(): cells[1:] for cells in lines}

    ours = rows(page)
    for label, cells in rows(printed).items():
        measured, committed = numbers(cells), numbers(ours.get(label, []))
        if label and len(measured) == len(committed):
            for a, b in zip(committed, measured):
                result.ratio(a, float(b.replace(",", "")))
    if not result.ratios:
        result.wrong.append("the page has none of the rows that were printed")
