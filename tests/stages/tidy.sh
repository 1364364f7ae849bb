# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# with --long alone: clang-tidy with its analyzer over core, the glue and the plugin

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

check_tidy() {
    local log=$BMR_BUILD_DIR/boomerang-clang-tidy.log
    # The long ones first, so that no job waits for another's last file; C++ takes longest.
    (cd "$root" && sources 'core/**.c' 'box2d_glue/**.cpp' 'plugin/*.cpp' ':!plugin/renamed/*' | xargs wc -l |
        awk '$2 != "total" { print $1 * ($2 ~ /cpp$/ ? 20 : 1), $2 }' | sort -rn | cut -d ' ' -f 2 |
        xargs -P "$jobs" -n 1 clang-tidy --quiet -p "$BMR_BUILD_DIR/tidy" 2>"$log")
}

stage_tidy() {
    bmr_need_packages clang-tidy || return 1
    in_tree clang
    # The commands are enough; nothing is built.
    bmr_configure clang && tidy_commands && check "clang-tidy" check_tidy
}
