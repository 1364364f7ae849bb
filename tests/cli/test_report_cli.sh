#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# `boomerang-testbed report`: what is on the page, where it goes, and what it will not read.
#
#   test_report_cli.sh DIRECTORY-OF-THE-PROGRAMS
set -uo pipefail

# shellcheck source=support/cli.sh
source "$(dirname "${BASH_SOURCE[0]}")/support/cli.sh"

"$testbed" compare pyramid needles --steps 8 --repeat 1 --quiet --json "$scratch/compare.json" >/dev/null
"$testbed" events line orbit --structures lazy-compass,closest-features --seeds 1 --n 16 --ratios 8,32,128 --quiet \
    --json "$scratch/events.json"
printf '%s\n' 'series,bodies,instructions a step' stock,1000,5000 stock,2000,9000 plugin,1000,3000 plugin,2000,6000 \
    >"$scratch/costs.csv"

page_has() { grep -Eq -- "$1" "$scratch/page.html" || fail "the page lacks /$1/"; }
page_lacks() { if grep -Eq -- "$1" "$scratch/page.html"; then fail "the page has /$1/"; fi; }

make_page() {
    expect 0 report --json "$scratch/compare.json" --json "$scratch/events.json" --costs "$scratch/costs.csv" \
        -o "$scratch/page.html"
}

test_a_report_shows_everything_that_it_was_given() {
    make_page
    out_has 'page\.html$'
    err_empty
    clean
    page_has '2 of 2</dd>'
    page_has '<th scope="row">needles</th>'
    page_has '<caption[^>]*><span>Time per step'
    page_has 'Plot: orbit, n = 16\.'
    page_has '<th scope="row">closest-features</th>'
    page_has 'Plot: instructions a step against bodies\.'
    [ "$(grep -c '<section ' "$scratch/page.html")" -eq 3 ] || fail "not three sections"
}

# with_ratios LEAST MEDIAN GREATEST: the page of a comparison whose steps took so much.
with_ratios() {
    python3 - "$scratch/compare.json" "$scratch/ratios.json" "$@" <<'PYTHON'
import json, sys
told = json.load(open(sys.argv[1]))
for scene in told["scenes"]:
    figures = scene["figures"]
    figures["ratio"].update(zip(("step_least", "step", "step_greatest"), map(float, sys.argv[3:])))
    figures["ratio_register"]["step"] = 1.5
json.dump(told, open(sys.argv[2], "w"))
PYTHON
    expect 0 report --json "$scratch/ratios.json" -o "$scratch/page.html"
}

test_a_ratio_whose_runs_lie_on_both_sides_of_1_is_no_difference() {
    with_ratios 0.81 0.92 1.13
    page_has '>0\.92 no difference<'
    page_lacks 'slower<'
    with_ratios 0.81 0.92 0.93
    page_has '>0\.92 slower<'
    page_lacks 'no difference<'
    with_ratios 1.11 1.22 1.33
    page_has '>1\.22<'
    page_lacks 'no difference<|slower<'
}

# What was not given is not there: the control of the test above.
test_a_report_shows_nothing_else() {
    expect 0 report --json "$scratch/events.json" -o "$scratch/page.html"
    page_has 'id="events"'
    page_lacks 'id="scenes"'
    page_lacks 'id="costs"'
    expect 0 report --costs "$scratch/costs.csv" -o "$scratch/page.html"
    page_has 'id="costs"'
    page_lacks 'id="events"'
}

test_a_page_needs_nothing_but_itself() {
    make_page
    # Names of XML are the only addresses.
    if grep -Eo '(https?:)?//[a-z][^" <]*' "$scratch/page.html" | grep -v 'www\.w3\.org'; then
        fail "an address"
    fi
    page_lacks '<script|<link|<img|@import'
    page_has "default-src 'none'"
    # Plots that share a page have their own ids.
    [ -z "$(grep -Eo ' id="[^"]+"' "$scratch/page.html" | sort | uniq -d)" ] || fail "an id is there twice"
    grep -Eo ' href="#[^"]+"' "$scratch/page.html" | sed 's/.*#//; s/"//' | sort -u >"$scratch/wanted"
    grep -Eo ' id="[^"]+"' "$scratch/page.html" | sed 's/.*="//; s/"//' | sort -u >"$scratch/there"
    [ -z "$(comm -23 "$scratch/wanted" "$scratch/there")" ] || fail "a reference leads nowhere"
}

test_names_from_files_are_text() {
    sed 's/"needles"/"<b onclick=\\"x()\\">\&"/' "$scratch/compare.json" >"$scratch/named.json"
    expect 0 report --json "$scratch/named.json" -o "$scratch/page.html"
    page_has '&lt;b onclick=&quot;x\(\)&quot;&gt;&amp;'
    page_lacks '<b onclick'
}

test_a_difference_is_told_and_is_the_exit_code() {
    "$testbed" compare needles --steps 8 --perturb 3 --quiet --json "$scratch/different.json" >/dev/null
    expect 1 report --json "$scratch/different.json" -o "$scratch/page.html"
    page_has 'class="alarm"><strong>needles</strong> differs at step 3'
    page_has '0 of 1</dd>'
    page_has 'DIFFERENT'
}

test_figures_are_files_too() {
    expect 0 report --json "$scratch/compare.json" --json "$scratch/events.json" --costs "$scratch/costs.csv" \
        --figures "$scratch/figures"
    local name
    for name in speed-up-step speed-up-narrow-phase calls-saved events-line events-orbit cost-bodies; do
        out_has "/$name\\.svg\$"
        grep -q '<svg' "$scratch/figures/$name.svg" || fail "no picture $name"
    done
    expect 3 report --json "$scratch/events.json" --figures "$scratch/costs.csv/below"
    err_has 'cannot make the directory'
}

# One scene at several sizes shows how cost grows; at one size it does not.
test_sizes_of_a_scene_are_a_plot() {
    local size
    for size in 10 20; do
        "$testbed" compare needles --size "$size" --steps 4 --repeat 1 --quiet --json "$scratch/size$size.json" >/dev/null
    done
    expect 0 report --json "$scratch/size10.json" --json "$scratch/size20.json" -o "$scratch/page.html"
    page_has 'Plot: needles, larger and larger'
    page_has 'size20\.json: 1 scene, 1 of them known already'
    expect 0 report --json "$scratch/size10.json" -o "$scratch/page.html"
    page_lacks 'larger and larger'
}

test_a_piped_report_is_the_page_and_nothing_else() {
    expect 0 report --json "$scratch/compare.json"
    head -n 1 "$scratch/out" | grep -q '^<!doctype html>$' || fail "something before the page"
    err_empty
    clean
    expect 2 report --json "$scratch/compare.json" -o - --figures "$scratch/figures"
}

test_what_is_not_measured_now_is_measured() {
    expect 0 report pyramid --parts scenes --steps 5 --repeat 1 -o "$scratch/page.html"
    err_empty
    page_has '<th scope="row">pyramid</th><td class="first">20</td><td class="first">5</td>'
    page_lacks '<th scope="row">needles</th>'
}

# Stock Box2D does not have these polygons: its place has the plugin told to be off.
test_scenes_that_stock_does_not_have() {
    expect 0 report any-stack --parts scenes --steps 3 --repeat 1 -o "$scratch/page.html"
    page_has '<td class="good first">identical</td><td class="good">identical</td><td class="none">–</td>'
    page_has 'BOOMERANG=off'
}

# A worker that fails before it is done is no agreement, and where the programs lie is nobody's business.
test_a_worker_that_fails_is_not_identical() {
    mkdir -p "$scratch/workers/bin" "$scratch/workers/lib"
    ln -sf "$bin"/boomerang-scene "$bin"/boomerang-scene-plugin "$scratch/workers/bin/"
    expect 0 --workers "$scratch/workers/bin" report pyramid --parts scenes --steps 3 --repeat 1 -o "$scratch/page.html"
    rm "$scratch/workers/bin/boomerang-scene"
    cat >"$scratch/workers/bin/boomerang-scene" <<STUB
#!/bin/sh
[ "\$1" != --list-json ] || exec "$bin/boomerang-scene" --list-json
"$bin/boomerang-scene" "\$@"
echo "\$0: broken" >&2
exit 3
STUB
    chmod +x "$scratch/workers/bin/boomerang-scene"
    expect 3 --workers "$scratch/workers/bin" report pyramid --parts scenes --steps 3 --repeat 1 -o "$scratch/page.html"
    page_lacks '>identical<'
    page_has 'boomerang-scene: broken'
    page_lacks "$scratch"
}

test_other_files_are_refused() {
    echo '{"scene": 1}' >"$scratch/other.json"
    expect 2 report --json "$scratch/other.json" -o "$scratch/page.html"
    err_has 'other\.json: neither what'
    echo '{"scenes": [' >"$scratch/half.json"
    expect 2 report --json "$scratch/half.json" -o "$scratch/page.html"
    err_has 'half\.json: cannot be read as JSON'
    sed 's/"verdict"/"judgement"/' "$scratch/compare.json" >"$scratch/other.json"
    expect 2 report --json "$scratch/other.json" -o "$scratch/page.html"
    err_has 'verdict'
    echo 'series,x,y' >"$scratch/bad.csv"
    echo 'a,1' >>"$scratch/bad.csv"
    expect 2 report --costs "$scratch/bad.csv" -o "$scratch/page.html"
    expect 2 report --json "$scratch/missing.json" -o "$scratch/page.html"
    expect 2 report --json "$scratch/compare.json" --steps 5 -o "$scratch/page.html"
    expect 2 report peedles -o "$scratch/page.html"
    err_has 'nearest is "needles"'
}

test_a_page_that_cannot_be_written_leaves_the_old_one() {
    expect 3 report --json "$scratch/compare.json" -o "$scratch/no/such/directory.html"
    err_has 'cannot write'
    expect 3 report --json "$scratch/compare.json" -o /dev/full
    echo old >"$scratch/page.html"
    expect 2 report --json "$scratch/missing.json" -o "$scratch/page.html"
    expect 2 report peedles -o "$scratch/page.html"
    (
        ulimit -f 1
        trap '' XFSZ
        exec "$testbed" report --json "$scratch/compare.json" -o "$scratch/page.html"
    ) >"$scratch/out" 2>"$scratch/err" && fail "a page that is too long was written"
    echo old | cmp -s - "$scratch/page.html" || fail "the old page is gone"
    [ -z "$(find "$scratch" -name 'page.html.*')" ] || fail "an unfinished page is left"
    chmod 640 "$scratch/page.html"
    ln -sf page.html "$scratch/link.html"
    expect 0 report --json "$scratch/compare.json" -o "$scratch/link.html"
    [ -L "$scratch/link.html" ] || fail "the link is gone"
    [ "$(stat -c %a "$scratch/page.html")" = 640 ] || fail "its permissions are gone"
    page_has '<section id="scenes">'
}

run_tests
