# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# clang-tidy over core, the glue and the plugin; with --long with its analyzer

# Each source once, as its own library compiles it: some are compiled again for the plugin, for static links, for a fuzzer.
tidy_commands() {
    mkdir -p "$BMR_BUILD_DIR/tidy" && python3 - "$BMR_BUILD_DIR" <<'PYTHON'
import json, re, sys
build = sys.argv[1]
kept = {}
for command in json.load(open(build + "/compile_commands.json")):
    output = re.search(r" -o (\S+)", command["command"]).group(1)
    if output.split("/")[0] in ("core", "box2d_glue", "plugin"):
        kept.setdefault(command["file"], command)
json.dump(list(kept.values()), open(build + "/tidy/compile_commands.json", "w"))
PYTHON
}

# tidy_one FILE: in the gate without clang's analyzer, which takes most of the time, and without the slowest of what looks for strings
# and for moved objects, of which core and the glue have hardly any.
tidy_one() {
    local less=(--checks=-clang-analyzer-*,-bugprone-use-after-move,-bugprone-stringview-nullptr,-bugprone-suspicious-string-compare)
    [ "$long" = no ] || less=()
    clang-tidy --quiet -p "$BMR_BUILD_DIR/tidy" "${less[@]}" "$1"
}

check_tidy() {
    local log=$BMR_BUILD_DIR/boomerang-clang-tidy.log
    export BMR_BUILD_DIR long
    export -f tidy_one
    # The long ones first, so that no job waits for another's last file; C++ takes longest.
    (cd "$root" && sources 'core/**.c' 'box2d_glue/**.cpp' 'plugin/*.cpp' ':!plugin/renamed/*' | xargs wc -l |
        awk '$2 != "total" { print $1 * ($2 ~ /cpp$/ ? 20 : 1), $2 }' | sort -rn | cut -d ' ' -f 2 |
        # shellcheck disable=SC2016
        xargs -P "$jobs" -I '{}' bash -c 'tidy_one "$1"' _ '{}' 2>"$log")
}

stage_tidy() {
    in_tree clang
    # The commands are enough; nothing is built.
    bmr_configure clang && tidy_commands && check "clang-tidy" check_tidy
}
