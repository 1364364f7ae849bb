# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# clang-tidy over core, the glue and the plugin

# Where each was found in the commands of a build: as they stand, but a source of the glue once, which is compiled for
# the glue and again, with weak references, for the plugin.
tidy_commands() {
    mkdir -p "$BMR_BUILD_DIR/tidy" && python3 - "$root" "$BMR_BUILD_DIR" <<'PYTHON'
import json, sys
root, build = sys.argv[1:]
commands = json.load(open(build + "/compile_commands.json"))
kept = [c for c in commands if not (c["file"].startswith(root + "/box2d_glue/") and "weak_box2d.h" in c["command"])]
json.dump(kept, open(build + "/tidy/compile_commands.json", "w"))
PYTHON
}

check_tidy() {
    local log=$BMR_BUILD_DIR/boomerang-clang-tidy.log
    # The long ones first, so that no job waits for another's last file; C++ takes longest.
    (cd "$root" && sources 'core/**.c' 'box2d_glue/**.cpp' 'plugin/*.cpp' | xargs wc -l |
        awk '$2 != "total" { print $1 * ($2 ~ /cpp$/ ? 20 : 1), $2 }' | sort -rn | cut -d ' ' -f 2 |
        xargs -n 1 -P "$jobs" clang-tidy --quiet -p "$BMR_BUILD_DIR/tidy" 2>"$log")
}

stage_tidy() {
    in_tree clang
    # The commands are enough; nothing is built.
    bmr_configure clang -DBOOMERANG_BUILD_BENCHMARKS=OFF && tidy_commands && check "clang-tidy" check_tidy
}
