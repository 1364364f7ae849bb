# SPDX-License-Identifier: MIT
"""Every figure and table of the pages: the command that makes it, as the page has it, and how the two are held against each other.

`quotes` are commands as they stand in a page, blanks aside. tests/gate/test_reproduce.py looks that each command of the pages that makes a
figure is in this list, and each picture. Kinds:

    picture   the file is the committed one, byte for byte
    counts    every number is the page's, as rounded there: counts do not depend on the machine
    ratios    instructions or times: told as measured over committed, and never a difference
    shown     made anew and shown; the page's words are its reader's to compare
"""
import math
import re

from compare import Events, block_with, exponent, rows_as_ratios, same_file, slope, table_after

TESTBED = "{build}/bin/boomerang-testbed"


class Experiment:
    """`commands` are lists of words, with {build}, {root} and {out}, a directory of their own, to be filled in; `check(run)` returns
    nothing and fills run.result. `seconds`: of one processor, of some machine."""

    def __init__(self, name, kind, what, seconds, quotes, commands, check=None, makes=(), packages=()):
        self.name, self.kind, self.what, self.seconds = name, kind, what, seconds
        self.quotes, self.commands, self.check, self.makes = quotes, commands, check, makes
        self.packages = packages # Debian's, that its commands need beside the build's


def words(command, *more):
    """A command as the page has it, to be run: the program by its place, environment first."""
    parts = command.replace("\\\n", " ").split()
    parts[0:1] = [TESTBED] if parts[0] == "boomerang-testbed" else parts[0:1]
    return parts + list(more)


def counted(name, what, seconds, quote, check):
    """An `events` command, whose runs are read as CSV."""
    return Experiment(name, "counts", what, seconds, [quote], [words(quote, "--quiet", "--csv", "{out}/events.csv")], check)


SATURATION = """boomerang-testbed events orbit spin tumble rigid-algebraic --n 12 --ratios 100,1000,10000,100000 --no-optimum \\
  --structures lazy-compass lazy-dudley active-cell-dudley free-fd2 hybrid two-lines"""
RIVALS = "boomerang-testbed events line tumble --structures rivals lazy-dudley hybrid predict-adaptive --n 1024 --ratios 2,1000 --no-optimum"
OPTIMUM = "boomerang-testbed events --structures rigid translation rivals --n 64 --ratios 128 --seeds 3"
SPIN = """boomerang-testbed events spin --shape regular --n 1024 --seeds 1 --ratios 8,32,128,512,2048,8192 --no-optimum \\
  --structures lazy-compass lazy-dudley active-cell-compass inflated-window free-fd2"""
GROWTH = """boomerang-testbed events line parabola algebraic orbit rigid-algebraic tumble spin --n 1024 --ratios 8:131072 --no-optimum \\
  --structures active-cell-compass active-cell-dudley lazy-compass lazy-dudley inflated-window free-fd2"""
GROWTH_OF_A_POINT = "boomerang-testbed events line parabola algebraic orbit --shape ellipse:point --structures points --n 1024 --ratios 8:131072 --no-optimum"
NEAR = ("boomerang-testbed events line orbit zigzag spin rigid-algebraic tumble rigid-wander --structures free-fd2 hybrid two-lines lazy-dudley predict-adaptive "
        "--n 1024 --seeds 2 --ratios 131072 --no-optimum")
RIGID = "BMR_TEST_SCALE=16 test_kinetic_rigid_search"
STRUCTURES = "boomerang-testbed compare needles plates planks coins-gas coins-pile gears bullets pyramid --structure "
WORLDS = ("boomerang-testbed world gas --boundary periodic --shape regular --vertices 8:64 --density 0.3 --sizes 1 --seconds 5 "
          "--growth 100,300,1000,3000,10000")


def name_in(cell):
    """The name between back quotes."""
    return re.search(r"`([^`]+)`", cell).group(1)


def check_lists(run, quote, structures_are_rows):
    """A table of motions and structures whose cells list the events, ratio by ratio."""
    head, *rows = table_after(*run.page(quote))
    events = Events(run.out / "events.csv")
    for side, *cells in rows:
        for top, cell in zip(head[1:], cells):
            motion, structure = (top, side) if structures_are_rows else (side, top)
            for ratio, text in zip(events.ratios, cell.split(",")):
                run.result.number(f"{motion}, {structure}, {ratio:g}", text.strip(), events.mean(motion, name_in(structure), ratio))


def check_optimum(run):
    events = Events(run.out / "events.csv")
    for index in range(3):
        head, *rows = table_after(*run.page(OPTIMUM), index)
        for motion, optimum, *cells in rows:
            if motion.startswith("**"): # the geometric mean of events, or of lines replaced; see the page
                motions, column = [row[0] for row in rows if not row[0].startswith("**")], motion.strip("*").split()[0]
                for structure, cell in zip(head[2:], cells):
                    shares = [events.mean(each, name_in(structure), 128, column) / max(1.0, events.mean(each, name_in(structure), 128, "optimum") - 1)
                              for each in motions]
                    run.result.number(f"{motion}, {structure}", cell.strip("*"), math.exp(sum(math.log(max(1.0, s)) for s in shares) / len(shares)))
                continue
            run.result.number(f"{motion}, optimum", optimum, events.mean(motion, "free-fd2", 128, "optimum"))
            for structure, cell in zip(head[2:], cells):
                run.result.number(f"{motion}, {structure}", cell, events.mean(motion, name_in(structure), 128))


def check_spin(run):
    _, *rows = table_after(*run.page(SPIN))
    events = Events(run.out / "events.csv")
    for structure, *cells in rows:
        means = events.means("spin", name_in(structure))
        for ratio, text, mean in zip(events.ratios, cells, means):
            run.result.number(f"{structure}, {ratio:g}", text, mean)
        run.result.number(f"{structure}, exponent", cells[-1], exponent(events.ratios, means))


# The rows of the table of growth, in its order: motion, what the structures' names begin with.
POINT_ROWS = [("line", "triangle-levels"), ("line", "point-lazy"), ("algebraic", "triangle-levels"), ("orbit", "triangle-levels"), ("orbit", "point-lazy")]
POLYGON_ROWS = [(motion, structure) for motion in ("line", "parabola", "algebraic", "orbit", "rigid-algebraic", "tumble", "spin")
                for structure in ("active-cell", "lazy")]


def check_growth(run, rows, first):
    events = Events(run.out / "events.csv")
    table = table_after(*run.page(GROWTH))[1 + first:]
    doublings = [math.log2(ratio) for ratio in events.ratios]
    for (motion, structure), cells in zip(rows, table):
        for hierarchy, cell in (("compass", cells[2]), ("dudley", cells[4])):
            where, means = f"{motion}, {structure}-{hierarchy}", events.means(motion, f"{structure}-{hierarchy}")
            for pattern, measured in ((r"e ([\d.]+)", exponent(events.ratios, means)), (r"\+([\d.]+)", slope(doublings, means)),
                                      (r"([\d.]+) sqrt", max(mean / math.sqrt(ratio) for mean, ratio in zip(means, events.ratios))),
                                      (r"\(([\d.]+)\)", means[-1])):
                found = re.search(pattern, cell)
                if found:
                    run.result.number(where, found.group(1), measured)


def check_event_cost(run):
    """A line of fits for each structure, and below it three of means: n = 64, 2048, 32768 by D/s = 8 .. 2^15."""
    fits = r"^(\S+): (\S+) \(log2 min\{n, D/s\}\)\^(\S+) steps an event, at most (\d+); x (\S+) from .*\n((?: .*\n){3})"
    said = {match.group(1): match.groups()[1:] for match in re.finditer(fits, run.said[0], re.M)}
    _, *rows = table_after(*run.page("build/bin/test_claims_time"))
    for structure, *cells in rows:
        factor, power, most, growth, means = said[name_in(structure)]
        means = [line.split(",") for line in means.splitlines()]
        for column, (text, measured) in enumerate(zip(cells, (factor, power, means[0][0], means[2][0], means[2][4], most, growth))):
            run.result.number(f"{structure}, column {column + 2}", text, float(measured))


def check_competitive(run):
    """The means that the page has in brackets behind the command."""
    text, quote = run.page("BMR_TEST_SCALE=5 test_kinetic_competitive")
    committed = re.findall(r"\d\.\d\d", re.search(r"\(([^)]*)\)", text[text.index(quote):]).group(1))
    measured = re.findall(r"^(\S+) (\d\.\d+)$", run.said[0], re.M)
    for text, (structure, mean) in zip(committed, measured, strict=True):
        run.result.number(structure, text, float(mean))


def check_rigid(run):
    """The motions by hand: events at three distances, and the exponents with their half widths."""
    structures = ("lazy-compass", "lazy-dudley", "free-fd2")
    for motion, distances, *columns, exponents in table_after(*run.page(RIGID))[1:]:
        motion = name_in(motion)
        for place, distance in enumerate(re.sub(",(?=\\d)", "", distances).split(", ")):
            found = re.search(rf"^{motion} +D/sigma +{distance}: events +(\d+) +(\d+) +(\d+)$", run.said[0], re.M)
            for structure, cell, measured in zip(structures, columns, found.groups() if found else ("nan",) * 3):
                run.result.number(f"{motion}, {structure}, {distance}", cell.split(", ")[place], float(measured))
        for structure, fit in zip(structures, exponents.split(", ")):
            found = re.search(rf"^{motion} +{structure} +exponent (\S+) \+- (\S+)$", run.said[0], re.M)
            for text, measured in zip(fit.split(" +- "), found.groups() if found else ("nan", "nan")):
                run.result.number(f"{motion}, {structure}, exponent", text, float(measured))


def check_worlds(run):
    """Events, pairs and bytes are counts; the clock's column is told as a ratio."""
    _, *rows = table_after(*run.page(WORLDS))
    printed = [line.split() for line in run.said[0].splitlines() if re.match(r"\d+ ", line)]
    for row, line in zip(rows, printed):
        line = [word for word in line if not word.startswith("(")]
        where = f"{row[0]} bodies"
        run.result.number(where, re.sub(",", "", row[0]), float(line[0]))
        run.result.number(f"{where}, events", row[1].split()[0], float(line[8]))
        for kind, text, measured in zip(("cross", "near", "repair", "contact"), row[2].split(", "), (line[2], line[3], line[4], line[6])):
            run.result.number(f"{where}, {kind}", text, float(measured))
        run.result.number(f"{where}, pairs", row[3], float(line[9]))
        run.result.number(f"{where}, bytes", row[4].split()[0], float(line[10]))
        run.result.ratios.append(float(line[12]) / float(row[5].split()[0]))


def check_scenes(run):
    """The table of pairs and looks, line by line."""
    title = "How kinetic the world is: pairs and who was looked at, per step"
    said = set(run.said[0].splitlines())
    for line in block_with(run.page_with(title), title):
        if re.search(r"\d", line):
            run.result.cells += len(line.split()) - 1
            if line not in said:
                run.result.wrong.append(f"not printed: {line}")


def picture(name, what, seconds, quotes, commands, makes):
    def check(run):
        for file in makes:
            same_file(run.result, run.out / file.split("/")[-1], run.root / file)

    return Experiment(name, "picture", what, seconds, quotes, commands, check, makes)


COSTS = ["calls", "bodies", "asleep", "listeners"] # in the order of the page


def costs(table, seconds):
    """A table of measure_costs.sh: the page has it as it is printed, below the command that prints it."""
    page = COSTS if table in COSTS else [table]
    quote = "tests/bench/measure_costs.sh build " + " ".join(page)

    def check(run):
        rows = table_after(*run.page(quote), page.index(table))
        rows_as_ratios(run.result, rows, run.said[0], 0, lambda row: [(column, column) for column in range(1, len(row))])

    return Experiment(f"cost-{table}", "ratios", f"instructions, by callgrind: {table}", seconds, [quote],
                      [["{root}/tests/bench/measure_costs.sh", "{build}", table]], check)


def shown(name, what, seconds, quotes, commands, makes=(), packages=()):
    return Experiment(name, "shown", what, seconds, quotes, commands, None, makes, packages)


FIGURES = ["boomerangs", "coarse-line", "dudley", "free-direction", "growth", "inflated", "mixed-events", "mixed-full", "mixed-insertion", "pair-events", "point-events",
           "time-line", "window"]

EXPERIMENTS = [
    picture("figures", "the figures of core/README.md, from the real structures", 3,
            ["boomerang-testbed figures -o docs/figures"],
            [[TESTBED, "figures", "-o", "{out}"]], [f"docs/figures/{name}.svg" for name in FIGURES]),
    picture("planks", "a scene with what proves its bodies apart", 1, ["boomerang-testbed render planks --step 150 --focus 100 -o docs/planks.png"],
            [[TESTBED, "render", "planks", "--step", "150", "--focus", "100", "-o", "{out}/planks.png"]], ["docs/planks.png"]),
    picture("any-size", "polygons of any size", 1, ["boomerang-testbed render any-bag --step 380 --bare -o docs/any-size.png"],
            [[TESTBED, "render", "any-bag", "--step", "380", "--bare", "-o", "{out}/any-size.png"]], ["docs/any-size.png"]),
    Experiment("growth-points", "counts", "Table 1 for a point: events against D/sigma", 4, [GROWTH_OF_A_POINT],
               [words(GROWTH_OF_A_POINT, "--quiet", "--csv", "{out}/events.csv")], lambda run: check_growth(run, POINT_ROWS, 0)),
    Experiment("growth", "counts", "Table 1 for two polygons: events against D/sigma", 12, [GROWTH],
               [words(GROWTH, "--quiet", "--csv", "{out}/events.csv")], lambda run: check_growth(run, POLYGON_ROWS, len(POINT_ROWS))),
    counted("spin", "the costliest rigid motion: a regular polygon spins", 7, SPIN, check_spin),
    counted("saturation", "events once mu is n", 1, SATURATION, lambda run: check_lists(run, SATURATION, True)),
    counted("rivals", "rivals, far and near", 2, RIVALS, lambda run: check_lists(run, RIVALS, False)),
    counted("optimum", "events over the best that was possible", 4, OPTIMUM, check_optimum),
    Experiment("worlds", "counts", "what grows with the number of bodies of a kinetic world", 5, [WORLDS], [words(WORLDS)], check_worlds),
    Experiment("scenes", "counts", "pairs, looks and events in every scene", 70, ["boomerang-testbed compare --no-time --details"],
               [[TESTBED, "compare", "--no-time", "--details"]], check_scenes),
    costs("calls", 40), costs("bodies", 200), costs("asleep", 40), costs("listeners", 200), costs("sizes", 60), costs("outlines", 40),
    shown("drifters", "the moving picture of the first page", 8,
          ["boomerang-testbed render drifters --frames 30:240:3 --focus=-7.4,-3.8,14.8,7.6 --certificates --slack --contacts --events --width 640 -o drifters.png"],
          [[TESTBED, "render", "drifters", "--frames", "30:240:3", "--focus=-7.4,-3.8,14.8,7.6", "--certificates", "--slack", "--contacts",
            "--events", "--width", "640", "-o", "{out}/drifters.png"],
           ["sh", "-c", "convert -delay 7 {out}/drifters-*.png -layers optimize {out}/drifters.gif"]], ["docs/drifters.gif"], ["imagemagick"]),
    shown("times", "times of every scene's step, stock over plugin", 400, ["boomerang-testbed compare --repeat 15 --markdown FILE"],
          [[TESTBED, "compare", "--repeat", "15", "--markdown", "{out}/tables.md"]]),
    shown("structures", "each structure in the place of the remembered edge", 200, [STRUCTURES + "NAME"],
          [words(STRUCTURES + structure) for structure in ("free-direction", "lazy-compass", "lazy-dudley")]),
    shown("life", "what the pairs of two scenes go through", 10, ["boomerang-testbed compare --steps 200 --no-time --details needles coins-pile"],
          [[TESTBED, "compare", "--steps", "200", "--no-time", "--details", "needles", "coins-pile"]]),
    shown("any-size-worlds", "worlds of polygons of any size", 60, ["boomerang-testbed compare any-gas any-pile any-bag"],
          [[TESTBED, "compare", "any-gas", "any-pile", "any-bag"]]),
    shown("cold", "steps of small worlds with cold caches", 200, ["tests/bench/cold_steps.sh build"], [["{root}/tests/bench/cold_steps.sh", "{build}"]]),
    counted("near", "the structures of the open question, very near", 10, NEAR, lambda run: check_lists(run, NEAR, False)),
    shown("chains", "convex chains of 32 to 4096 vertices, in long double", 1, ["build/bin/test_chain_model"], [["{build}/bin/test_chain_model"]]),
    shown("convex-paths", "parts of the bounds that convex paths use", 150, ["build/bin/test_kds_convex_paths"],
          [["{build}/bin/test_kds_convex_paths"]]),
    shown("few-vertices", "rigid motions of few vertices, ever nearer", 30, ["build/bin/test_kinetic_claims"], [["{build}/bin/test_kinetic_claims"]]),
    Experiment("event-cost", "counts", "steps of an event", 4, ["build/bin/test_claims_time"], [["{build}/bin/test_claims_time"]], check_event_cost),
]
EXPERIMENTS.append(Experiment("competitive", "counts", "lines over the optimum, policies that the library has", 3, ["BMR_TEST_SCALE=5 test_kinetic_competitive"],
                              [["env", "BMR_TEST_SCALE=5", "{build}/bin/test_kinetic_competitive"]], check_competitive))
EXPERIMENTS.append(Experiment("rigid", "counts", "rigid motions that were sought to be dear", 21, [RIGID], [["env", RIGID.split()[0], "{build}/bin/" + RIGID.split()[1]]],
                              check_rigid))
for test, scale, seconds in (("test_distance", 40, 60), ("test_kinetic_every_structure", 400, 3000),
                             ("test_glue_rounding_margins", 15, 900)):
    EXPERIMENTS.append(shown(test.replace("test_", "").replace("_", "-"), f"{test} with {scale} times its iterations", seconds,
                             [f"BMR_TEST_SCALE={scale} {test}"], [["env", f"BMR_TEST_SCALE={scale}", f"{{build}}/bin/{test}"]]))

# Commands in the pages that are there to be used, and make no figure of theirs.
USAGE = [
    "boomerang-testbed compare",
    "boomerang-testbed events --list",
    "boomerang-testbed events --polygon A.txt --polygon B.txt --motion M.txt --trace T.txt",
    "boomerang-testbed events --structures NAME",
    "boomerang-testbed world",
    "boomerang-testbed world --list",
    "boomerang-testbed world gas --bodies 1000 --check --audit",
    "boomerang-testbed world cooling --answer 0.8 --picture run.png --frames 0:300:10 --all",
]
# Pictures that are drawn by hand.
BY_HAND = ["docs/figures/pair-memory.svg", "docs/figures/step-as-data.svg"]
