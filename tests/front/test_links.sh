#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# test_links.sh ROOT: no link of a page in the sources is dead.
set -euo pipefail
root=$1
cd "$root"
# A page of a build directory is none of ours.
mapfile -t pages < <(ls ./*.md && find docs core box2d_glue playground tests -name '*.md')
python3 tests/front/check_links.py . "${pages[@]}"
# The control: two dead links, and one that is code.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
printf '[a](docs/nothing.md) and\n[b](README.md#nothing)\n\n`[c](docs/code.md)`\n' >"$work/README.md"
! python3 tests/front/check_links.py "$work" >"$work/said" || { echo "FAILED: the control: no dead link was found"; exit 1; }
[ "$(grep -c 'leads nowhere' "$work/said")" -eq 2 ] || { echo "FAILED: the control: $(cat "$work/said")"; exit 1; }
