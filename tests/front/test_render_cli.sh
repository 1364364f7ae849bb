#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# boomerang-testbed render: pictures against golden ones, layers, focus, series, and what it says of bad requests.
#
#   test_render_cli.sh DIRECTORY-OF-THE-PROGRAMS
#   BOOMERANG_WRITE_GOLDEN=1 test_render_cli.sh DIRECTORY…   writes the golden pictures instead of comparing
set -uo pipefail

# shellcheck source=cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/cli.sh"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# The golden pictures: small scenes, one of each kind of proof.
golden_arguments() {
    case $1 in
    pyramid) echo pyramid --size 5 --step 40 --width 500 ;;
    layers) echo coins-gas --size 8 --step 40 --width 500 --structure lazy-compass --all ;;
    why) echo planks --size 60 --step 120 --focus 30 --width 900 ;;
    bare) echo planks --size 60 --step 120 --bare --width 500 ;;
    esac
}

draw() {
    local output=$1
    shift
    expect 0 render "$@" -o "$output"
    err_empty
    case " $* " in
    *" --quiet "*) [ ! -s "$scratch/out" ] || fail "stdout is not empty" ;;
    *) grep -qF -- "${output%.*}" "$scratch/out" || fail "it does not say what it wrote" ;;
    esac
}

same_svg() { python3 "$here/picture.py" "$@" >"$scratch/out" 2>"$scratch/err"; }

test_pictures_are_the_golden_ones() {
    local name arguments
    for name in pyramid layers why bare; do
        read -ra arguments <<<"$(golden_arguments $name)"
        draw "$scratch/$name.svg" "${arguments[@]}"
        same_svg "$here/pictures.txt" "$scratch/$name.svg" || fail "not the golden picture"
        python3 "$here/picture.py" "$scratch/$name.svg" >>"$scratch/pictures.txt"
    done
    if [ -n "${BOOMERANG_WRITE_GOLDEN:-}" ]; then cp "$scratch/pictures.txt" "$here/"; fi
    # The control: a step later it is another picture.
    draw "$scratch/later.svg" pyramid --size 5 --step 45 --width 500
    ! same_svg "$scratch/pyramid.svg" "$scratch/later.svg" || fail "a later step passes for the golden picture"
    sed 's/stroke:rgb(100%, *35/stroke:rgb(10%,35/; s/stroke="rgb(100%, *35/stroke="rgb(10%,35/' \
        "$scratch/pyramid.svg" >"$scratch/recoloured.svg"
    ! same_svg "$scratch/pyramid.svg" "$scratch/recoloured.svg" || fail "another colour passes for the golden one"
}

test_every_layer_draws_something_of_its_own() {
    local layer
    draw "$scratch/none.svg" coins-gas --size 60 --step 60 --width 500 --structure lazy-compass --bare
    for layer in certificates slack handed-over contacts events aabbs; do
        draw "$scratch/layer-$layer.svg" coins-gas --size 60 --step 60 --width 500 --structure lazy-compass "--$layer"
    done
    ! same_svg "$scratch/none.svg" "$scratch"/layer-*.svg || fail "a layer draws nothing"
}

# (What is drawn: the golden pictures. A blank PNG of this size takes some 1,000 bytes.)
test_every_kind_of_file() {
    draw "$scratch/picture.png" pyramid --size 4 --step 3 --width 300
    head -c 8 "$scratch/picture.png" | grep -q PNG || fail "no PNG"
    [ "$(od -An -tu4 --endian=big -j 16 -N 4 "$scratch/picture.png")" -eq 300 ] || fail "it is not 300 pixels wide"
    [ "$(wc -c <"$scratch/picture.png")" -gt 4000 ] || fail "nothing is drawn"
    draw "$scratch/picture.pdf" pyramid --size 4 --step 3
    head -c 5 "$scratch/picture.pdf" | grep -q '%PDF-' || fail "no PDF"
    draw "$scratch/picture.svg" pyramid --size 4 --step 3 --plugin off
    grep -q '<svg' "$scratch/picture.svg" || fail "no SVG"
}

# Stock Box2D does not have these polygons: its place has the plugin switched off, and the picture says so.
test_scenes_that_stock_does_not_have() {
    draw "$scratch/on.svg" any-stack --step 5 --bare --width 400
    draw "$scratch/off.svg" any-stack --step 5 --bare --width 400 --plugin off
    ! same_svg "$scratch/on.svg" "$scratch/off.svg" || fail "the picture does not say that the plugin was off"
    draw "$scratch/caves.svg" caves --size 6 --step 2
    grep -q 'dasharray' "$scratch/caves.svg" || fail "no dashed lines, which are seams alone"
}

test_frames_tell_the_truth() {
    local scene structure
    for scene in "coins-gas --size 40" "planks --size 60" "chain-rocks --size 60"; do
        claim="boomerang-scene $scene --frames 20:50:10"
        : >"$scratch/out"
        # shellcheck disable=SC2086
        "$bin/boomerang-scene" $scene --steps 60 --frames 20:50:10 >"$scratch/stock" 2>"$scratch/err" || fail "the worker failed"
        for structure in "" free-direction lazy-dudley; do
            # shellcheck disable=SC2086
            "$bin/boomerang-scene-plugin" $scene --steps 60 --frames 20:50:10 ${structure:+--structure $structure} \
                >"$scratch/plugin.$structure" 2>"$scratch/err" || fail "the worker failed with '$structure'"
        done
        python3 "$here/check_frames.py" "$scratch/stock" "$scratch"/plugin.* 2>"$scratch/err" || fail "it is not what it should be"
    done
}

test_focus_on_bodies_and_places() {
    draw "$scratch/one.svg" planks --size 60 --step 60 --focus 30
    draw "$scratch/two.svg" planks --size 60 --step 60 --focus 12
    draw "$scratch/place.svg" planks --size 60 --step 60 --focus -3,-2,8,6
    ! same_svg "$scratch/one.svg" "$scratch/two.svg" || fail "two bodies look alike"
    local bad
    for bad in x 1,2,3 '1,' 3,3 0,0,-1,2 0,0,0,2 1.5 nan -4; do
        expect 2 render pyramid --size 4 --step 3 "--focus=$bad" -o "$scratch/picture.svg"
        err_has 'a body or a rectangle'
    done
    expect 2 render pyramid --size 4 --step 3 --focus '' -o "$scratch/picture.svg"
    expect 2 render pyramid --size 4 --step 3 --focus 4711 -o "$scratch/picture.svg"
    err_has 'there is no body 4711 after step 3; the largest number is [0-9]+'
}

test_a_series_is_numbered_and_of_one_size() {
    draw "$scratch/series.svg" coins-gas --size 30 --frames 10:19:3 --quiet --width 400
    local name
    for name in 0000 0001 0002 0003; do [ -s "$scratch/series-$name.svg" ] || fail "no series-$name.svg"; done
    [ ! -e "$scratch/series-0004.svg" ] || fail "one picture too many"
    [ ! -e "$scratch/series.svg" ] || fail "a picture without a number"
    [ "$(grep -h '<svg' "$scratch"/series-*.svg | grep -o ' height="[^"]*"' | sort -u | wc -l)" -eq 1 ] ||
        fail "pictures of different heights"
    ! same_svg "$scratch/series-0000.svg" "$scratch/series-0003.svg" || fail "nothing moves"
    local bad
    for bad in 3 5:3 -1:4 1:2:0 1:2: 1:2:3:4 a:b; do
        says 'FIRST:LAST or FIRST:LAST:EVERY is wanted' 2 render pyramid "--frames=$bad" -o "$scratch/picture.svg"
    done
}

# The body in focus, those beside it and no others are numbered, and how far it is apart is said.
test_bodies_in_focus_are_numbered() {
    draw "$scratch/why.pdf" planks --step 150 --focus 100
    pdftotext "$scratch/why.pdf" "$scratch/seen.txt"
    local name
    for name in 100 82 17 18; do grep -qx "$name" "$scratch/seen.txt" || fail "body $name is not numbered"; done
    ! grep -qx 99 "$scratch/seen.txt" || fail "a body that is not beside it is numbered"
    [ "$(grep -cE '^[0-9.]+ m$' "$scratch/seen.txt")" -ge 4 ] || fail "it does not say how far apart they are" # and the scale
}

test_requests_that_make_no_sense() {
    says 'trails: of a kinetic world alone' 2 render planks --step 1 --trails -o "$scratch/picture.svg"
    says 'which step' 2 render pyramid -o "$scratch/picture.svg"
    expect 2 render pyramid --step -1 -o "$scratch/picture.svg"
    says 'no whole number from 0 to 100000000' 2 render pyramid --step 100000001 -o "$scratch/picture.svg"
    expect 2 render pyramid --step 1 --frames 1:2 -o "$scratch/picture.svg"
    expect 2 render pyramid --step 1 --all --bare -o "$scratch/picture.svg"
    says 'should end in .svg, .png or .pdf' 2 render pyramid --step 1 -o "$scratch/picture.jpeg"
    expect 3 render pyramid --step 1 -o "$scratch/no/such/directory.png"
    err_has 'cannot write .*no/such/directory.png: there is no directory .*/no/such$'
    local ending
    for ending in png svg pdf; do
        echo old >"$scratch/kept.$ending"
        expect 2 render pyramid --size 4 --step 3 --focus 4711 -o "$scratch/kept.$ending"
        echo old | cmp -s - "$scratch/kept.$ending" || fail "the old picture is gone"
        draw "$scratch/kept.$ending" pyramid --size 4 --step 3
        ! echo old | cmp -s - "$scratch/kept.$ending" || fail "control: the old picture is still there"
        [ -z "$(find "$scratch" -name '*.part')" ] || fail "an unfinished picture is left"
    done
    says 'Layers:' 0 render --help
    out_has '--focus'
    clean
}

test_progress_on_a_terminal_alone() {
    command -v script >/dev/null || return 0
    local line="'$testbed' render pyramid --size 6 --frames 0:60:5 --width 400 -o '$scratch/terminal.png'"
    claim=$line
    : >"$scratch/err"
    script -qec "$line" /dev/null </dev/null >"$scratch/out" || fail "it failed"
    LC_ALL=C grep -q $'\r.*ETA' "$scratch/out" || fail "no progress"
    script -qec "$line --quiet" /dev/null </dev/null >"$scratch/out" || fail "it failed"
    ! LC_ALL=C grep -q 'ETA' "$scratch/out" || fail "progress though quiet"
}

run_tests
