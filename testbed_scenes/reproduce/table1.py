# SPDX-License-Identifier: MIT
"""Table 1 of the paper, as it is printed there, with what the runs of `growth-points` and `growth` counted below each of its rows."""
from compare import exponent, slope
import math

LOG, MU, MU_LOG, MU2, MU2_LOG2 = "O(log mu)", "O(mu)", "O(mu log mu)", "O(mu^2)", "O(mu^2 log^2 mu)"
# For each part: its title, the experiment that counts it, its structures, and the paper's rows: motion, compass, Dudley, and our motions.
PARTS = [
    ("One point, one polygon", "growth-points", {"triangle-levels": "active triangle", "point-lazy": "lazy"},
     [("convex", LOG, LOG, ["line"]), ("general", MU_LOG, MU, ["algebraic", "orbit"])]),
    ("Two polygons", "growth", {"active-cell": "active cell", "lazy": "lazy"},
     [("convex translation", LOG, MU, ["line", "parabola"]), ("general translation", MU_LOG, MU, ["algebraic", "orbit"]),
      ("rigid motion", MU2_LOG2, MU2, ["rigid-algebraic", "tumble", "spin"])]),
]
WIDTHS = (34, 30, 30, 5)
LEGEND = """\
mu is the smaller of n and the square root of D/sigma. Here n is 1024, and D/sigma goes from 8 to 131072.
events  at the least and at the greatest D/sigma, the mean of three motions
x2      how many more events each doubling of D/sigma brings, fitted: a constant where they are O(log mu)
power   the fitted power of D/sigma: O(mu) is 0.5, and O(mu^2) is 1
holds   both powers are at most 0.05 above that of the paper's bound; or the bound is a logarithm, and fits better than a power"""
GROWTH = {LOG: math.log2, MU: math.sqrt, MU_LOG: lambda x: math.sqrt(x) * math.log2(x), MU2: lambda x: x, MU2_LOG2: lambda x: x * math.log2(x) ** 2}


def row(*cells):
    return " | ".join(f"{cell:{width}}" for cell, width in zip(cells, WIDTHS)).rstrip()


def measured(events, motion, structure):
    means = events.means(motion, structure)
    doublings = [math.log2(ratio) for ratio in events.ratios]
    return f"{means[0]:6.1f} to {means[-1]:6.1f} {slope(doublings, means):+6.2f}   {exponent(events.ratios, means):5.2f}"


def off(curve, means):
    return sum((value - mean) ** 2 for value, mean in zip(curve, means))


def holds(bound, events, motion, structure):
    means, logs = events.means(motion, structure), [math.log2(ratio) for ratio in events.ratios]
    power, rise = exponent(events.ratios, means), slope(logs, means)
    if power <= exponent(events.ratios, [GROWTH[bound](ratio) for ratio in events.ratios]) + 0.05:
        return True
    middle, mean, factor = sum(logs) / len(logs), sum(means) / len(means), sum(math.log2(value) for value in means) / len(means)
    return bound == LOG and (off([mean + rise * (log - middle) for log in logs], means) <=
                             off([2 ** (factor + power * (log - middle)) for log in logs], means))


def table(runs):
    """`runs`: the Events of each experiment that ran, by its name; a part that did not run is left out."""
    rule = "=" * (sum(WIDTHS) + 6)
    lines = ["Table 1 of the paper, and below each row what was counted here:", "", row("Motion", "Compass", "Dudley"),
             row("", "  events            x2   power", "  events            x2   power", "holds"), rule]
    for title, experiment, structures, rows in PARTS:
        if experiment not in runs:
            continue
        lines += [title, "-" * len(rule)]
        for motion, compass, dudley, ours in rows:
            lines.append(row(motion, compass, dudley))
            for our in ours:
                for structure, name in structures.items():
                    lines.append(row(f"  {our}: {name}", *(measured(runs[experiment], our, f"{structure}-{hierarchy}")
                                                           for hierarchy in ("compass", "dudley")),
                                     "yes" if all(holds(bound, runs[experiment], our, f"{structure}-{hierarchy}")
                                                  for bound, hierarchy in ((compass, "compass"), (dudley, "dudley"))) else "no"))
        lines.append(rule)
    return "\n".join([*lines, LEGEND])
