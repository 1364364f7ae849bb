#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check_links.py DIRECTORY [PAGE...]: every link of the Markdown pages in DIRECTORY (or of these pages in it) leads to a file of
DIRECTORY and, where it names one, to a heading there. Links to other places are not followed. Prints the dead ones; 1 if there are any."""
import pathlib
import re
import sys


def plain(text):
    """The text without fenced blocks and code in a line, where a link is none."""
    text = re.sub(r"^(```|~~~).*?^\1[^\n]*$", "", text, flags=re.S | re.M)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(text):
    """The names that GitHub gives to headings, and those that the page itself gives."""
    names = set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))
    for heading in re.findall(r"^#{1,6} +(.+?) *$", re.sub(r"^```.*?^```[^\n]*$", "", text, flags=re.S | re.M), flags=re.M):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        again = 0
        while (name if not again else f"{name}-{again}") in names:
            again += 1
        names.add(name if not again else f"{name}-{again}")
    return names


def dead_links(directory, page):
    text = page.read_text()
    for target in re.findall(r"\]\(\s*<?([^()\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)", plain(text)) + re.findall(r"<(?:img|a) [^>]*(?:src|href)=\"([^\"]+)\"", plain(text)):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        there = (page.parent / path).resolve() if path else page.resolve()
        if not there.exists() or not there.is_relative_to(directory.resolve()):
            yield target
        elif anchor and there.suffix == ".md" and anchor not in anchors(there.read_text()):
            yield target


def main():
    directory = pathlib.Path(sys.argv[1])
    pages = [directory / page for page in sys.argv[2:]] or sorted(directory.rglob("*.md"))
    dead = [f"{page.relative_to(directory)}: {target} leads nowhere" for page in pages for target in dead_links(directory, page)]
    print("\n".join(dead) or f"{len(pages)} pages, no dead link")
    sys.exit(1 if dead or not pages else 0)


if __name__ == "__main__":
    main()
