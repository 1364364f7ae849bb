# SPDX-License-Identifier: MIT
"""What the pages say beside what was measured: Markdown tables, numbers as they were rounded, fits, files."""
import collections
import csv
import math
import re


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


def rows_as_ratios(result, page_rows, printed, key, columns):
    """Of a Markdown table that a command printed, each row beside the page's of the same key, number by number, as ratios.

    `key` is the printed column that names the page's row (its first cell); columns(row) gives pairs (printed column, page's column)."""
    def plain(cell):
        return cell.replace(",", "").strip()

    page = {plain(row[0]): row for row in page_rows}
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in printed.splitlines() if line.startswith("|")]
    for row in rows[2:]:
        if plain(row[key]) not in page:
            result.wrong.append(f"the page has no row {row[key]}")
            continue
        for ours, theirs in columns(row):
            result.ratio(page[plain(row[key])][theirs].split()[0], float(plain(row[ours]).split()[0]))
    if not result.ratios and not result.wrong:
        result.wrong.append("nothing was printed")
