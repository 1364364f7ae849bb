#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks what two workers printed for --record: check_recording.py STOCK PLUGIN...

The same worlds; no proof claims more than the distance that was measured; every named outline and fixture was sent.
The control: one slack is raised by a tenth of a millimetre more than the distance, and must be refused.
"""
import json
import sys


def read(path):
    frames = []
    with open(path, encoding="ascii") as file:
        for line in file:
            word, _, rest = line.partition(" ")
            if word == "frame":
                frames.append(json.loads(rest))
            elif word == "recording":
                head = json.loads(rest)
    return head, frames


def check(plugin, stock):
    fixtures, outlines, proofs = set(), set(), 0
    for frame, other in zip(plugin, stock):
        for part in ("bodies", "fixtures", "joints", "touching", "gone"):
            assert frame.get(part) == other.get(part), f"step {frame.get('step', 0)}: other {part} than stock"
        fixtures -= {tuple(gone) for gone in frame.get("gone", [])}
        fixtures |= {(f.get("body", 0), f.get("number", 0)) for f in frame.get("fixtures", [])}
        outlines |= {outline["id"] for outline in frame.get("outlines", [])}
        for pair in frame.get("pairs", []):
            named = f"step {frame.get('step', 0)}, bodies {pair.get('a', 0)} and {pair.get('b', 0)}"
            assert pair.get("slack", -1) <= max(0, pair.get("distance", -1)), f"{named}: more slack than distance"
            contacts = sum(proof.get("contacts", 1) for proof in pair.get("proofs", []))
            assert contacts == pair.get("polygon_contacts", 0), f"{named}: not one proof for each contact"
            for proof in pair.get("proofs", []):
                proofs += proof.get("kind", "none") != "none"
                for outline in proof.get("hulls", []) + proof.get("envelopes", []):
                    assert outline == 0 or outline in outlines, f"{named}: outline {outline} was never sent"
                for body, number in zip((pair.get("a", 0), pair.get("b", 0)), proof.get("fixtures", [])):
                    assert number == -1 or (body, number) in fixtures, f"{named}: a fixture was never sent"
    assert proofs > 0, "no proofs"


def main():
    stock_head, stock = read(sys.argv[1])
    assert stock_head["program"] == "stock" and len(sys.argv) > 2
    for path in sys.argv[2:]:
        head, plugin = read(path)
        assert head["program"] == "plugin" and len(plugin) == len(stock) > 1
        check(plugin, stock)
        pair = next(p for f in plugin for p in f["pairs"] if p.get("slack", 0) > 0)
        pair["slack"] = pair["distance"] + 1e-4
        try:
            check(plugin, stock)
        except AssertionError:
            continue
        sys.exit("too much slack is not noticed")


try:
    main()
except AssertionError as error:
    sys.exit(str(error))
