#!/bin/bash
# SPDX-License-Identifier: MIT
#
#   test_version.sh ROOT
#
# Every place that names the version names the same.
set -u
root=$1
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT

# versions ROOT: place and version, a line each
versions() {
    (
        cd "$1" || exit
        sed -n 's/^project(boomerang VERSION \([0-9.]*\) .*/CMakeLists.txt \1/p' CMakeLists.txt
        sed -n 's/^version: /CITATION.cff /p' CITATION.cff
        sed -n 's/^__version__ = "\(.*\)"/core\/python \1/p' core/python/boomerang/__init__.py
        sed -n 's/^## \[\([0-9].*\)\].*/CHANGELOG.md \1/p' CHANGELOG.md | head -n 1
    )
}
# one_version ROOT: are all four places there, and do they agree?
one_version() { [ "$(versions "$1" | wc -l)" -eq 4 ] && [ "$(versions "$1" | cut -d ' ' -f 2 | sort -u | wc -l)" -eq 1 ]; }

failed=0
one_version "$root" || {
    echo "FAILED: versions differ:"
    versions "$root"
    failed=1
}
# The control: one of them another.
mkdir -p "$room/core/python/boomerang"
for file in CMakeLists.txt CITATION.cff CHANGELOG.md core/python/boomerang/__init__.py; do cp "$root/$file" "$room/$file"; done
for file in CMakeLists.txt CITATION.cff CHANGELOG.md core/python/boomerang/__init__.py; do
    sed -E '/project\(|^version|__version__|^## \[/s/[0-9]+\.[0-9]+\.[0-9]+/77.0.0/' "$root/$file" >"$room/$file"
    ! one_version "$room" || {
        echo "FAILED: the control: another version in $file is not noticed"
        failed=1
    }
    cp "$root/$file" "$room/$file"
done
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
