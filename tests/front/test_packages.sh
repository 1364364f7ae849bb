#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   test_packages.sh ROOT BUILD WORK
#
# Debian packages of the build tree BUILD, made in the directory WORK: what is in them, their licenses and dependencies; installed by
# dpkg under a root of their own, used from there, and purged without a trace. The machine stays as it was; nothing is downloaded.
set -euo pipefail
root=$1 build=$2 work=$3
debs=$work/packages
there=$work/root
export PATH=$PATH:/usr/sbin:/sbin # dpkg asks for ldconfig

fail() {
    printf 'FAILED: %s\n' "$*" >&2
    exit 1
}
# as_root COMMAND…: dpkg gives files to root, or believes so.
as_root() { if [ "$(id -u)" -eq 0 ]; then "$@"; else fakeroot -s "$work/fakeroot" -i "$work/fakeroot" "$@"; fi; }
# quietly COMMAND…: says what the command said if it fails
quietly() { "$@" >"$work/said" 2>&1 || fail "$*: $(tail -n 20 "$work/said")"; }

rm -rf "$work"
mkdir -p "$work"
touch "$work/fakeroot"
# Whose packages they are has to be said.
! cpack --config "$build/CPackConfig.cmake" -B "$debs" -D CPACK_PACKAGE_CONTACT= >"$work/said" 2>&1 || fail "packages of no maintainer were made"
grep -q 'BOOMERANG_PACKAGE_MAINTAINER' "$work/said" && [ -z "$(find "$debs" -name '*.deb' 2>/dev/null)" ] || fail "made without a maintainer: $(cat "$work/said")"
quietly cpack --config "$build/CPackConfig.cmake" -B "$debs" -D CPACK_DEBIAN_COMPRESSION_TYPE=none
names=(libboomerang-core1 libboomerang-kinetic1 libboomerang-box2d1 libboomerang-dev libboomerang-kinetic-dev boomerang-tools boomerang-testbed
    boomerang-doc python3-boomerang)
for name in "${names[@]}"; do
    [ -f "$(echo "$debs/$name"_*.deb)" ] || fail "there is no package $name"
done
[ "$(find "$debs" -maxdepth 1 -name '*.deb' | wc -l)" -eq ${#names[@]} ] || fail "another package than ${names[*]}"

# Whatever an installation has is in a package: each component is one.
packed=$(sed -n 's/^set(CPACK_COMPONENTS_ALL "\(.*\)")$/\1/p' "$build/CPackConfig.cmake" | tr ';' '\n' | LC_ALL=C sort)
installed=$(find "$build" -name cmake_install.cmake -not -path '*/tests/*' -exec grep -oh 'CMAKE_INSTALL_COMPONENT STREQUAL "[^"]*"' {} + |
    sed 's/.*"\(.*\)"/\1/' | LC_ALL=C sort -u)
[ "$packed" = "$installed" ] || fail "installed are the components" $installed ", and packed" $packed

# A root with nothing in it, and dpkg's knowledge of those of this machine's packages that ours ask for.
# fresh_root [WITHOUT]: as if that one were not installed
fresh_root() {
    local package version
    rm -rf "$there"
    mkdir -p "$there/var/lib/dpkg/info" "$there/var/lib/dpkg/updates" "$there/var/lib/dpkg/triggers"
    for deb in "$debs"/*.deb; do dpkg-deb -f "$deb" Depends; done | tr ',' '\n' | sed 's/^ *\([^ ]*\).*/\1/' | LC_ALL=C sort -u |
        while read -r package; do
            [ -n "$package" ] && [[ $package != libboomerang-* ]] && [ "$package" != "${1:-}" ] || continue
            version=$(dpkg-query -W -f '${Version}' "$package") || fail "a package asks for $package, which this machine has not"
            printf 'Package: %s\nStatus: install ok installed\nMaintainer: x\nArchitecture: %s\nMulti-Arch: same\nVersion: %s\nDescription: x\n\n' \
                "$package" "$(dpkg --print-architecture)" "$version"
            touch "$there/var/lib/dpkg/info/$package:$(dpkg --print-architecture).list"
        done >"$there/var/lib/dpkg/status"
}
dpkg_there() { as_root dpkg --root="$there" --force-not-root --force-unsafe-io --log="$work/dpkg.log" "$@"; }

# The control: without one of the libraries that they link, two of them are not installed.
fresh_root libgsl27
! dpkg_there -i "$debs"/libboomerang-core1_*.deb "$debs"/libboomerang-box2d1_*.deb "$debs"/libboomerang-kinetic1_*.deb "$debs"/boomerang-testbed_*.deb \
    >"$work/said" 2>&1 || fail "the control: installed without libgsl27"
for name in libboomerang-kinetic1 boomerang-testbed; do
    grep -q -E "$name(:\w+)? depends on libgsl27" "$work/said" || fail "the control: $name does not ask for libgsl27"
done
! grep -q -E "(libboomerang-core1|libboomerang-box2d1)(:\w+)? depends on libgsl27" "$work/said" || fail "a package under the MIT license asks for libgsl27"

fresh_root
(cd "$there" && find . ! -path './var/lib/dpkg/*') >"$work/before"
quietly dpkg_there -i "$debs"/*.deb
for name in "${names[@]}"; do
    quietly dpkg_there -s "$name"
    grep -q '^Status: install ok installed$' "$work/said" || fail "$name is not installed"
    grep -q '^License: Expat$' "$there/usr/share/doc/$name/copyright" || fail "$name has no license"
    case $name in
    libboomerang-kinetic1 | boomerang-testbed | libboomerang-kinetic-dev) wanted=0 ;;
    *) wanted=1 ;;
    esac
    status=0
    grep -q 'GNU General Public' "$there/usr/share/doc/$name/copyright" || status=1
    [ "$status" -eq "$wanted" ] || fail "the license of $name is another one's"
done

# Whoever links GSL is in a package that says so, and nobody else.
gsl=$(find "$there/usr" -type f \( -name '*.so*' -o -perm -100 \) -exec sh -c 'readelf -d "$1" 2>/dev/null | grep -q "NEEDED.*libgsl"' _ {} \; -print |
    while read -r file; do dpkg_there -S "${file#"$there"}" | cut -d : -f 1; done | LC_ALL=C sort -u)
[ "$gsl" = "boomerang-testbed
libboomerang-kinetic1" ] || fail "these packages link GSL:" $gsl

# Libraries lie in the architecture's folder, and each package of one is named after its soname.
multiarch=$(dpkg-architecture -q DEB_HOST_MULTIARCH)
[ -z "$(find "$there/usr/lib" -mindepth 1 -maxdepth 1 ! -name "$multiarch" ! -name python3)" ] || fail "besides $multiarch: $(ls "$there/usr/lib")"
while read -r library; do
    soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
    name=${soname/.so./}
    [ "$(dpkg_there -S "${library#"$there"}" | cut -d : -f 1)" = "${name//_/-}" ] || fail "$soname is in another package than ${name//_/-}"
done < <(find "$there/usr/lib/$multiarch" -maxdepth 1 -type f -name '*.so.*')

# The development of a game needs no GSL: with libboomerang-dev alone, CMake finds all but kinetic.
! dpkg-deb -f "$debs"/libboomerang-dev_*.deb Depends Recommends | grep -q gsl || fail "libboomerang-dev asks for GSL"
! dpkg_there -L libboomerang-dev | grep -v /share/boomerang/source/ | grep -i -e kinetic -e gsl >"$work/said" || fail "libboomerang-dev has: $(cat "$work/said")"

# Debian's own check finds no error and no warning, where it is installed, as it is in a long run. (A hundred packages of Perl are too
# much for the gate; and the test does not compress its packages.)
if command -v lintian >/dev/null; then
    lintian --allow-root --fail-on error,warning --suppress-tags uses-no-compression-for-data-tarball "$debs"/*.deb >"$work/said" 2>&1 ||
        fail "lintian: $(cat "$work/said")"
fi
# Used from there, and from nowhere else: in C by pkg-config (shared and static), in Python, by the testbed, preloaded.
libraries=$(dirname "$(find "$there/usr/lib" -name libboomerang_core.so.1)")
export LD_LIBRARY_PATH=$libraries PKG_CONFIG_PATH=$libraries/pkgconfig
for name in core kinetic; do
    read -ra flags < <(pkg-config --cflags --libs boomerang-$name)
    quietly cc -std=c11 "$root/tests/front/consumer/consume_$name.c" -o "$work/consume_$name" "${flags[@]}"
    quietly "$work/consume_$name"
    quietly ldd "$work/consume_$name"
    grep -q "libboomerang_$name.so.1 => $libraries/" "$work/said" || fail "consume_$name does not use the package"
done
# (As from its place: no path says where the libraries are but the module's own.)
(
    unset LD_LIBRARY_PATH BOOMERANG_LIBRARY_DIR
    example=$there/usr/share/doc/boomerang/core/python/examples/notebook.py
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$there/usr/lib/python3/dist-packages quietly /usr/bin/python3 "$example"
)
grep -q '^they touch at 2.7500$' "$work/said" || fail "the example in Python says: $(cat "$work/said")"
(cd / && unset LD_LIBRARY_PATH && quietly "$there/usr/bin/boomerang-testbed" compare needles --steps 5 --no-time)
grep -q '^needles .* identical *identical *identical$' "$work/said" || fail "the testbed does not run both ways: $(cat "$work/said")"
quietly "$there/usr/bin/boomerang" try --seconds 0.3 --rounds 1 -- "$there/usr/bin/boomerang-scene" needles --mode time --steps 100000
tr '\n' ' ' <"$work/said" | grep -q 'It runs whole steps' || fail "boomerang does not find its library: $(cat "$work/said")"
gzip -cd "$there/usr/share/man/man1/boomerang-testbed.1.gz" | grep -q '^compare' || fail "no manual page, or one without commands"

# No dead link; and the control, that one is found, of a file and of a heading.
documentation=$there/usr/share/doc/boomerang
quietly python3 "$root/tests/front/check_links.py" "$documentation"
quietly python3 "$root/tests/front/check_links.py" "$root" README.md CONTRIBUTING.md tests/README.md
cp -r "$documentation" "$work/documentation"
printf '[a](docs/nothing.md) and\n[b](README.md#nothing)\n\n`[c](docs/code.md)`\n' >>"$work/documentation/README.md"
! python3 "$root/tests/front/check_links.py" "$work/documentation" >"$work/said" || fail "the control: no dead link was found"
[ "$(grep -c -e 'README.md: docs/nothing.md leads nowhere' -e 'README.md: README.md#nothing leads nowhere' "$work/said")" -eq 2 ] &&
    [ "$(wc -l <"$work/said")" -eq 2 ] || fail "the control: found is $(cat "$work/said")"

quietly dpkg_there --purge "${names[@]}"
(cd "$there" && find . ! -path './var/lib/dpkg/*') >"$work/after"
diff "$work/before" "$work/after" >"$work/said" || fail "purged, and left: $(cat "$work/said")"
! grep -q boomerang "$there/var/lib/dpkg/status" || fail "dpkg still knows of a package"
rm -rf "$work"
echo passed
