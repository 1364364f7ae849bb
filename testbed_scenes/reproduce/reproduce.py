# SPDX-License-Identifier: MIT
"""Makes the figures and tables of the pages anew, and holds them against the committed ones.

    ./testbed_scenes/run reproduce              pictures and counts: about two minutes of one processor
    ./testbed_scenes/run reproduce table-1      the paper's Table 1, beside what is counted here: half a minute of one processor
    ./testbed_scenes/run reproduce NAME ...     these alone
    ./testbed_scenes/run reproduce --all        instructions and times, too: some three hours
    ./testbed_scenes/run reproduce --list       what there is, how it is compared, and how long it takes
    --output DIR                                keep what was made in this directory (default: reproduced/)

What an experiment needs is built first: that takes minutes, once.

Pictures must be the committed ones byte for byte, and counts the pages' as they are rounded there. Instructions and times are told as
measured over committed: they never count as a difference. Exit codes: 0 nothing differs; 1 something does; 2 the request makes no sense;
3 a command failed.
"""
import argparse
import pathlib
import platform
import re
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from catalogue import EXPERIMENTS, TESTBED  # noqa: E402
from compare import Events, Result  # noqa: E402
import table1  # noqa: E402

# One name for several experiments.
GROUPS = {"table-1": [experiment for _, experiment, *_ in table1.PARTS]}
# Commands of boomerang-testbed that play no scene, and so need no worker.
WITHOUT_WORKERS = {"events", "figures"}
ROOT = pathlib.Path(__file__).resolve().parents[2]


def pages(root=ROOT):
    """The pages with figures, by their names."""
    return {str(file.relative_to(root)): file.read_text() for file in [root / "README.md", root / "core/README.md", root / "box2d_glue/proofs/thresholds.md", root / "box2d_glue/a-step-as-data.md", *sorted((root / "docs").glob("*.md"))]}


def normal(command):
    """A command in one line, one blank between words."""
    return " ".join(command.replace("\\\n", " ").split())


class Run:
    """One experiment as it runs: its directory, what its commands said, what was found."""

    def __init__(self, out):
        self.root, self.out, self.said, self.result = ROOT, out, [], Result()

    def page(self, quote):
        """(a page that has this command, the command as it stands there)"""
        pattern = r"[\s\\]+".join(re.escape(word) for word in normal(quote).split())
        for text in pages().values():
            found = re.search(pattern, text)
            if found:
                return text, found.group()
        raise ValueError(f"no page has the command {quote}")

    def page_with(self, words):
        return next(text for text in pages().values() if words in text)


def machine(build):
    """What the counts do not depend on, and times do."""
    model = re.search(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text() if pathlib.Path("/proc/cpuinfo").exists() else "")
    commit = subprocess.run(["git", "-C", str(ROOT), "describe", "--always", "--dirty"], capture_output=True, text=True, check=False).stdout.strip()
    compiler = re.search(r"CMAKE_CXX_COMPILER:\w+=(.*)", (pathlib.Path(build) / "CMakeCache.txt").read_text())
    return (f"machine: {model.group(1) if model else platform.machine()}, {platform.platform()}\n"
            f"tree: {commit or 'unknown'}, built by {compiler.group(1) if compiler else '?'}\n"
            "seeds: 1, 2, .. of each command, as many as its --seeds says (3 where it says none)")


def bar(done, of, what):
    if sys.stderr.isatty():
        filled = 30 * done // max(1, of)
        sys.stderr.write(f"\r[{'#' * filled}{'-' * (30 - filled)}] {done}/{of} {what:40}")
        sys.stderr.flush()


def take(experiment, build, output):
    """Runs one experiment; its Run, or None where a command failed."""
    out = output / experiment.name
    out.mkdir(parents=True, exist_ok=True)
    run = Run(out)
    for index, command in enumerate(experiment.commands):
        command = [word.format(build=build, root=ROOT, out=out) for word in command]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        (out / f"said-{index}.txt").write_text(done.stdout + done.stderr)
        if done.returncode not in (0, 1):
            print(f"{experiment.name}: failed ({done.returncode}): {' '.join(command)}\n{done.stderr[-2000:]}")
            return None
        run.said.append(done.stdout)
    if experiment.check:
        experiment.check(run)
    return run


def verdict(experiment, run):
    result = run.result
    if result.wrong:
        text = f"{len(result.wrong)} of {result.cells} differ"
    elif experiment.kind == "shown":
        text = f"made: {run.out}"
    else:
        text = f"the same, {result.cells} {'files' if experiment.kind == 'picture' else 'figures'}" if experiment.kind != "ratios" else f"{result.cells} figures"
    if result.ratios:
        ordered = sorted(result.ratios)
        text += f"; measured over committed {ordered[0]:.2f} to {ordered[-1]:.2f}, median {ordered[len(ordered) // 2]:.2f}"
    return text


def targets(chosen):
    """What has to be built for these experiments."""
    found = set()
    for experiment in chosen:
        for command in experiment.commands:
            found |= {word.split("/")[-1] for word in command if word.startswith("{build}/bin/")}
            plays = TESTBED in command and command[command.index(TESTBED) + 1] not in WITHOUT_WORKERS
            costs = any("measure_costs" in word for word in command)
            if plays or costs or "--box2d" in command:
                found |= {"boomerang-scene", "boomerang-scene-plugin", "boomerang-count"}
            if costs:
                found |= {"boomerang-testbed", "bench_worlds"}
    return found


def choose(options):
    by_name = {experiment.name: experiment for experiment in EXPERIMENTS}
    for name in options.names:
        if name not in by_name and name not in GROUPS:
            sys.exit(print(f"reproduce: there is no {name!r}; there are {', '.join([*GROUPS, *by_name])}", file=sys.stderr) or 2)
    if options.names:
        return [by_name[each] for name in options.names for each in GROUPS.get(name, [name])]
    return [experiment for experiment in EXPERIMENTS if options.all or experiment.kind in ("picture", "counts")]


def main():
    parser = argparse.ArgumentParser(prog="reproduce", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(ROOT / "build"), help=argparse.SUPPRESS)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("names", nargs="*", metavar="NAME")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--targets", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--output", default="reproduced", metavar="DIR")
    parser.add_argument("--packages", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    chosen = choose(options)
    if options.list:
        for group, names in GROUPS.items():
            print(f"{group:28} {' and '.join(names)}")
        for experiment in EXPERIMENTS:
            print(f"{experiment.name:28} {experiment.kind:8} {experiment.seconds:5} s  {experiment.what}")
        return 0
    if options.targets:
        print(*sorted(targets(chosen)))
        return 0
    if options.packages:
        print(*sorted({package for experiment in chosen for package in experiment.packages}))
        return 0
    seconds = sum(experiment.seconds for experiment in chosen)
    print(machine(options.build))
    print(f"{len(chosen)} experiments, about {max(1, round(seconds / 60))} min of one processor", flush=True)
    differs = failed = False
    counted = {}
    for done, experiment in enumerate(chosen):
        bar(done, len(chosen), experiment.name)
        began = time.monotonic()
        run = take(experiment, options.build, pathlib.Path(options.output).resolve())
        failed |= run is None
        if run is None:
            continue
        differs |= bool(run.result.wrong)
        if experiment.name in GROUPS["table-1"]:
            counted[experiment.name] = Events(run.out / "events.csv")
        if sys.stderr.isatty():
            sys.stderr.write("\r" + " " * 80 + "\r")
        print(f"{experiment.name:28} {time.monotonic() - began:6.0f} s  {verdict(experiment, run)}", flush=True)
        for line in run.result.wrong:
            print(f"    {line}")
    if counted:
        print(f"\n{table1.table(counted)}")
    return 3 if failed else 1 if differs else 0


if __name__ == "__main__":
    sys.exit(main())
