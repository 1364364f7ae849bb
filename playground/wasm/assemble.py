#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes one file of HTML of the playground's page: style, scripts, the program, and the licenses of what is in it."""

import argparse
import base64
import html
import pathlib
import sys

# In the order in which the page runs them.
SCRIPTS = ["core", "picture", "place", "timeline", "growth", "handles", "panels", "modes", "main"]
# The page is for slow lines, too.
MOST_BYTES = 700_000


def main():
    parser = argparse.ArgumentParser()
    for name in ("page", "program", "gpl", "mit", "gsl-version", "output"):
        parser.add_argument("--" + name, type=pathlib.Path, required=True)
    given = parser.parse_args()
    text = (given.page / "page.html").read_text()
    version = given.gsl_version.read_text().strip() if given.gsl_version.exists() else "of Debian"
    parts = {
        "/*@style@*/": (given.page / "page.css").read_text(),
        "/*@program@*/": given.program.with_suffix(".js").read_text(),
        "/*@script@*/": "\n".join((given.page / f"{name}.js").read_text() for name in SCRIPTS),
        "@wasm@": base64.b64encode(given.program.with_suffix(".wasm").read_bytes()).decode(),
        "@gpl@": html.escape(given.gpl.read_text()),
        "@mit@": html.escape(given.mit.read_text()),
        "@gsl-version@": html.escape(version),
    }
    for mark, part in parts.items():
        if text.count(mark) != 1:
            sys.exit(f"page.html has {text.count(mark)} places for {mark}, and should have one")
        if mark.startswith("/*") and "</" + "script" in part:
            sys.exit(f"what is put in for {mark} would end the script")
        text = text.replace(mark, part)
    size = len(text.encode())
    if size > MOST_BYTES:
        sys.exit(f"the page has {size} bytes, and may have {MOST_BYTES}")
    given.output.write_text(text)
    print(f"{given.output}: {size} bytes")


main()
