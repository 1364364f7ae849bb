#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what two workers printed for --frames: check_frames.py STOCK PLUGIN...

The same worlds; no proof claims more than the distance that was measured.
The control: one slack is raised by a tenth of a millimetre more than the distance, and must be refused.
"""
import json
import sys


def read(path):
    with open(path, encoding="ascii") as file:
        return [json.loads(line.partition(" ")[2]) for line in file if line.startswith("frame ")]


def check(plugin, stock):
    proofs = 0
    for frame, other in zip(plugin, stock):
        assert frame["program"] == "plugin"
        for part in ("step", "bodies", "fixtures", "joints", "touching"):
            assert frame[part] == other[part], f"step {frame['step']}: other {part} than stock"
        for pair in frame["pairs"]:
            named = f"step {frame['step']}, bodies {pair['a']} and {pair['b']}"
            slack = min((proof["slack"] for proof in pair["proofs"]), default=0)
            assert slack <= max(0, pair["distance"]), f"{named}: more slack than distance"
            contacts = sum(proof["contacts"] for proof in pair["proofs"])
            assert contacts == pair["polygon_contacts"], f"{named}: not one proof for each contact"
            for proof in pair["proofs"]:
                proofs += proof["kind"] != "none"
    assert proofs > 0, "no proofs"


def main():
    stock = read(sys.argv[1])
    assert stock[0]["program"] == "stock" and len(sys.argv) > 2
    for path in sys.argv[2:]:
        plugin = read(path)
        assert len(plugin) == len(stock) > 1
        check(plugin, stock)
        pair = next(p for f in plugin for p in f["pairs"] if p["proofs"] and all(proof["slack"] > 0 for proof in p["proofs"]))
        for proof in pair["proofs"]:
            proof["slack"] = pair["distance"] + 1e-4
        try:
            check(plugin, stock)
        except AssertionError:
            continue
        sys.exit("too much slack is not noticed")


try:
    main()
except AssertionError as error:
    sys.exit(str(error))
