#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   test_package.sh BUILD WORK
#
# `cpack -G DEB` makes a package of the build tree BUILD, in the directory WORK. dpkg installs it under a root of its own, its testbed
# runs from there, and nothing is left when it is purged. The machine stays as it was.
set -euo pipefail
build=$1 work=$2
there=$work/root
export PATH=$work/bin:$PATH:/usr/sbin:/sbin # dpkg asks for what is there

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}
# as_root COMMAND…: dpkg gives files to root, or believes so.
as_root() { if [ "$(id -u)" -eq 0 ]; then "$@"; else fakeroot -s "$work/fakeroot" -i "$work/fakeroot" "$@"; fi; }
# quietly COMMAND…: says what the command said if it fails
quietly() { "$@" >"$work/said" 2>&1 || fail "$*: $(tail -n 20 "$work/said")"; }
# (There is no shell in that root. The package's scripts call ldconfig, which is to leave the machine as it is.)
dpkg_there() { as_root dpkg --root="$there" --force-not-root --force-unsafe-io --force-script-chrootless --log="$work/dpkg.log" "$@"; }

rm -rf "$work"
mkdir -p "$work/bin" "$there/var/lib/dpkg/info" "$there/var/lib/dpkg/updates" "$there/var/lib/dpkg/triggers"
ln -s /bin/true "$work/bin/ldconfig"
touch "$work/fakeroot" "$there/var/lib/dpkg/status"
# Making a package overwrites the list of what was installed from this tree, which may be somebody's real installation.
manifest=$build/install_manifest.txt
[ ! -f "$manifest" ] || mv "$manifest" "$work/manifest"
trap 'rm -f "$manifest"; [ ! -f "$work/manifest" ] || mv "$work/manifest" "$manifest"' EXIT
quietly cpack -G DEB --config "$build/CPackConfig.cmake" -B "$work/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=none
packages=("$work"/packages/*.deb)
[ ${#packages[@]} -eq 1 ] || fail "these packages: ${packages[*]}"
(cd "$there" && find . ! -path './var/lib/dpkg/*') >"$work/before"
quietly dpkg_there -i "${packages[0]}"
testbed=$(find "$there" -name boomerang-testbed -type f)
(cd / && quietly "$testbed" compare needles --steps 5 --no-time)
grep -q '^needles .* identical *identical *identical$' "$work/said" || fail "the testbed does not run both ways: $(cat "$work/said")"
quietly dpkg_there --purge boomerang
(cd "$there" && find . ! -path './var/lib/dpkg/*') >"$work/after"
diff "$work/before" "$work/after" >"$work/said" || fail "purged, and left: $(cat "$work/said")"
rm -rf "$work/root" "$work/packages"
echo passed
