#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A walk through the paper in cells (`# %%`: Jupyter, VS Code and Spyder open them as a notebook). core/python/README.md quotes what it prints."""

# %% Two polygons, asked once.
import boomerang as bmr

ellipse = bmr.Polygon([(2, 0), (1, 1), (-1, 1), (-2, 0), (-1, -1), (1, -1)])
answer = bmr.distance(ellipse, None, ellipse, bmr.Pose(5, 1, angle=1.5))
print(f"{answer.distance:.3f} apart, along ({answer.normal[0]:.2f}, {answer.normal[1]:.2f})")

# %% A pair that remembers why it is apart. Most steps find the proof still true.
pair = bmr.Pair(ellipse, ellipse)
for step in range(61):
    gap = pair.advance(bmr.Pose(-6 + 0.1 * step, 3.1, angle=0.02 * step))
print(f"{pair.checks} steps, {len(pair.events)} events: {', '.join(event.kind for event in pair.events)}")
print(f"now at least {gap:.3f} apart, by a line of body {pair.certificate['owner'].upper()} on level {pair.level}")

# %% The same motion, known beforehand: the events in the order of time. (From here on GSL is loaded.)
from boomerang import analysis, kinetic

motions = [kinetic.Motion.rest(), kinetic.Motion.screw((-6, 3.1), velocity=(12, 0), spin=2.4)]
simulation = kinetic.Simulation([ellipse, ellipse], motions, structure="lazy-dudley")
for event in simulation.run(until=1.0):
    print(f"{event.time:.4f} {event.kind:5} to level {event.level_after}, {event.steps} steps")
simulation.audit()

# %% When they touch, if one comes straight at the other.
arrives = kinetic.Motion.screw((-9, 0.5), velocity=(2, 0))
print(f"they touch at {kinetic.time_of_contact(ellipse, motions[0], ellipse, arrives, until=10):.4f}")

# %% A row of the paper's Table 1: events grow with the logarithm of D/sigma on convex paths, with its root on an orbit.
a, b = analysis.ngon("ellipse", 256), analysis.ngon("disc", 256)
ratios = [8, 32, 128, 512, 2048]
for name in ("line", "orbit"):
    runs = [[analysis.family(name, a, b, ratio, seed).run("lazy-dudley") for seed in (1, 2, 3)] for ratio in ratios]
    events = [round(sum(map(len, three)) / 3, 1) for three in runs]
    growth = analysis.fit_growth(ratios, events)
    print(f"{name:6} {events}: {growth.slope:+.2f} a doubling, or as (D/sigma)^{growth.exponent:.2f}")
