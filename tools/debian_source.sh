#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   debian_source.sh PACKAGE SOURCE FILE PLACE
#
# Leaves Debian's source of an installed package in PLACE/source: the source package SOURCE that PACKAGE was built from, in that
# very version, which must have FILE in it. apt checks the archive's signature and the hashes. A second call finds it there and
# asks nobody.
#
# Few machines have deb-src entries. So one is made, in a directory of its own, from each of the machine's own entries for
# Debian's main component; the machine's configuration and package lists stay as they are.
set -euo pipefail
if [ $# -ne 4 ] || [ "$1" = --help ]; then
    sed -n '4,12s/^# \{0,1\}//p' "$0"
    [ "${1:-}" = --help ] || exit 2
    exit 0
fi
package=${1:?} name=${2:?} file_in_it=${3:?} place=${4:?}
log=$place/get-source.log

# fail WHAT: ends with a line that says what is missing, and with the end of what apt said.
fail() {
    [ ! -s "$log" ] || tail -n 15 "$log" >&2
    printf 'debian_source.sh: %s\n' "$*" >&2
    exit 1
}

# deb822_entries SUITES FILE...: those of type deb that are in use, of component main and of such a suite, as deb-src.
deb822_entries() {
    awk -v suites="$1" 'BEGIN { RS = ""; FS = "\n" }
        {
            kept = ""
            is = ofSuite = ofMain = 0
            off = 0
            for (i = 1; i <= NF; ++i) {
                if ($i ~ /^#/) continue
                if ($i ~ /^Types:.*[ \t]deb([ \t]|$)/) is = 1
                if ($i ~ "^Suites:.*[ \t]" suites) ofSuite = 1
                if ($i ~ /^Components:.*[ \t]main([ \t]|$)/) ofMain = 1
                if (tolower($i) ~ /^enabled:[ \t]*no/) off = 1
                if ($i !~ /^(Types|Architectures):/) kept = kept $i "\n"
            }
            if (is && ofSuite && ofMain && !off) printf "Types: deb-src\n%s\n", kept
        }' "${@:2}"
}

# The same for entries of one line.
line_entries() {
    sed -E -n "/^deb[ \t].*[ \t]($1)[^ \t]*[ \t](.*[ \t])?main([ \t]|\$)/s/^deb/deb-src/p" "${@:2}"
}

command -v dpkg-source >/dev/null || fail "dpkg-source is missing (package dpkg-dev)"
# shellcheck disable=SC2016  # the field is dpkg's
version=$(dpkg-query -W -f='${source:Version}' "$package" 2>/dev/null) || fail "$package is not installed"
[ "$(cat "$place/source/.version" 2>/dev/null)" != "$version" ] || exit 0

mkdir -p "$place"
place=$(cd "$place" && pwd) # what follows changes directories
log=$place/get-source.log
temp=$(mktemp -d)
trap 'rm -rf "$temp"' EXIT
mkdir -p "$temp/parts" "$temp/lists/partial" "$temp/cache/archives/partial" "$temp/out"
# shellcheck source=/dev/null
suites=$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-stable}")
shopt -s nullglob
files=(/etc/apt/sources.list.d/*.sources)
[ ${#files[@]} -eq 0 ] || deb822_entries "($suites|stable)" "${files[@]}" >"$temp/parts/source.sources"
files=(/etc/apt/sources.list /etc/apt/sources.list.d/*.list)
existing=()
for file in "${files[@]}"; do [ ! -r "$file" ] || existing+=("$file"); done
[ ${#existing[@]} -eq 0 ] || line_entries "$suites|stable" "${existing[@]}" >"$temp/parts/source.list"
[ -s "$temp/parts/source.sources" ] || [ -s "$temp/parts/source.list" ] ||
    fail "apt has no entry here for main of $suites: where is the source of $name to come from?"

apt=(apt-get -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$temp/parts" -o Dir::State::lists="$temp/lists"
    -o Dir::Cache="$temp/cache" -o APT::Sandbox::User="$(id -un)")
# One of several mirrors may be down; whether the one that matters was, the next command says.
"${apt[@]}" update >"$log" 2>&1 || true
(cd "$temp/out" && "${apt[@]}" source --only-source "$name=$version" >>"$log" 2>&1) ||
    fail "apt-get source $name=$version failed (is there a network?); all it said is in $log"
extracted=("$temp/out/$name"-*/)
[ ${#extracted[@]} -eq 1 ] && [ -e "${extracted[0]}$file_in_it" ] ||
    fail "the source package $name $version has no $file_in_it"
printf '%s\n' "$version" >"${extracted[0]}.version"
rm -rf "$place/source" "$place/source.new"
cp -r "${extracted[0]}" "$place/source.new"
mv "$place/source.new" "$place/source"
