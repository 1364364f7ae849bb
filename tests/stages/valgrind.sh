# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# memcheck over two scenes, with --long over all, with the plugin, whose hashes must be stock's

# memcheck REFERENCE SCENE STEPS [PRELOADED]: nothing lost, nothing read that was not written, and the reference's hashes.
# REFERENCE: stock or off, which is what there is of a scene of polygons that stock has not.
memcheck() {
    local program=$BMR_BUILD_DIR/bin/boomerang-scene-plugin temp=$work/memcheck
    mkdir -p "$temp"
    if [ "$1" = stock ]; then
        "$BMR_BUILD_DIR/bin/boomerang-scene" "$2" --steps "$3" | grep '^step ' >"$temp/expected"
    else
        BOOMERANG=off "$program" "$2" --steps "$3" | grep '^step ' >"$temp/expected"
    fi
    [ "$(wc -l <"$temp/expected")" -eq "$3" ] || return 1
    if ! env ${4:+"LD_PRELOAD=$4"} BOOMERANG=on valgrind --quiet --error-exitcode=9 --leak-check=full \
        --errors-for-leak-kinds=definite,indirect,possible --num-callers=20 \
        "$program" "$2" --steps "$3" >"$temp/output" 2>"$temp/errors"; then
        [ -n "${4:-}" ] || head -n 60 "$temp/errors"
        return 1
    fi
    cmp "$temp/expected" <(grep '^step ' "$temp/output")
}

# A step that loses a kilobyte is found. (The library must see the step first, or it takes Box2D for another one.)
memcheck_control() {
    cc -shared -fPIC -O1 -o "$work/leaking_step.so" "$root/tests/stages/soak/leaking_step.c" -ldl &&
        ! memcheck stock chain-rocks 5 "$BMR_BUILD_DIR/lib/libboomerang_box2d.so $work/leaking_step.so" && grep -q 'are definitely lost' "$work/memcheck/errors"
}

# Every scene that there is, for some steps.
memcheck_all() {
    local scene reference
    while IFS=$'\t' read -r scene reference; do
        check "memcheck: $scene, 20 steps" memcheck "$reference" "$scene" 20 || true
    done < <("$BMR_BUILD_DIR/bin/boomerang-scene" --list-json | python3 -c '
import json, sys
for scene in json.load(sys.stdin):
    print(scene["name"], "off" if scene["vertices"] > 8 and scene["bodies"] == "one" else "stock", sep="\t")')
}

stage_valgrind() {
    build_release || return 1
    [ "$long" = no ] || memcheck_all
    check "memcheck: chain-rocks" memcheck stock chain-rocks 100 || true
    check "memcheck: any-bag" memcheck off any-bag 40 || true
    check "memcheck: control" memcheck_control
}
