#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
#   test_abi.sh ROOT LIB
#
# What a compiled program relies on (docs/stability.md) still holds: the symbols of the shared libraries in LIB
# are those of the committed lists, and the public headers still say what those of the last version did.
set -u
root=$1 lib=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
failed=0

if ! python3 "$root/tests/front/abi.py" check "$root" "$lib"; then
    echo "FAILED: see docs/stability.md: what is gone must come back, or the next version is a major one"
    failed=1
fi

# The control: a copy of the headers and lists in which everything is wrong that this test is for.
mkdir -p "$room/core" "$room/box2d_glue" "$room/plugin"
cp "$root/CMakeLists.txt" "$room"
cp -r "$root/core/include" "$root/core/abi" "$room/core"
cp -r "$root/box2d_glue/include" "$room/box2d_glue"
cp -r "$root/plugin/include" "$root/plugin/abi" "$room/plugin"
headers=$room/core/include/boomerang
# wrong FILE SUBSTITUTION: and it must change something
wrong() {
    cp "$1" "$room/before"
    perl -0pi -e "$2" "$1"
    ! cmp -s "$1" "$room/before" || { echo "FAILED: the control changes nothing in $1"; failed=1; }
}
wrong "$headers/polygon.h" 's/size_t bmr_polygon_bytes\(size_t count\);//'
wrong "$headers/distance.h" 's/typedef struct bmr_overlap \{/typedef struct bmr_overlap {\n    double before_all;/'
wrong "$headers/error.h" 's/BMR_OK = 0,/BMR_OK = 0,\n    BMR_ERROR_ANOTHER,/'
wrong "$headers/kds.h" 's/(bool bmr_kds_in_contact\(const bmr_kds \*kds)\)/$1, int more)/'
wrong "$headers/kds.h" 's/BMR_KDS_MAX_CONDITIONS 8/BMR_KDS_MAX_CONDITIONS 9/'
wrong "$headers/mass.h" 's/(#ifdef __cplusplus\n\}\n)/void bmr_new_one(void);\n$1/'
wrong "$room/box2d_glue/include/boomerang/box2d_glue.h" 's/struct Options \{/struct Options {\n    double beforeAll = 0;/'
wrong "$room/core/abi/libboomerang-kinetic.symbols" 's/ bmr_fit_growth\@/ bmr_fit_growth_of_old\@BOOMERANG_1 1.0.0\n$&/'
wrong "$room/plugin/abi/libboomerang-box2d.symbols" 's/ _ZN3bmr7InstallERKNS_7OptionsE\@[^\n]*\n//'
if python3 "$root/tests/front/abi.py" check "$room" "$lib" "$root" >"$room/said" 2>&1; then
    echo "FAILED: the control: nothing is noticed"
    failed=1
fi
while read -r pattern; do
    grep -q "^$pattern" "$room/said" || {
        echo "FAILED: not noticed: $pattern"
        failed=1
    }
done <<'PATTERNS'
GONE or changed (c): function bmr_polygon_bytes: size_t (size_t)
NOT PUBLIC: bmr_polygon_bytes 
GONE or changed (c): record bmr_overlap: 56 bytes
GONE or changed (c): record bmr_overlap 0: double depth
GONE or changed (c): enum bmr_error BMR_ERROR_NULL_ARGUMENT = 1
GONE or changed (c): function bmr_kds_in_contact: .*(const bmr_kds \*)
GONE or changed (c): constant BMR_KDS_MAX_CONDITIONS = 8
NEW (c): function bmr_new_one: void (void)
NOT SHOWN: bmr_new_one 
GONE or changed (cpp): record bmr::Options: 40 bytes
GONE or changed (libboomerang-kinetic.symbols): bmr_fit_growth_of_old@BOOMERANG_1
NEW (libboomerang-box2d.symbols): _ZN3bmr7InstallERKNS_7OptionsE@BOOMERANG_1
PATTERNS
[ "$failed" -eq 0 ] && echo passed
exit "$failed"
