# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# what is tested, with clang, its address and undefined-behaviour sanitizers and its counts of lines; warnings are errors

# The stages sanitized-tests, fuzz, coverage and (of a long run) determinism work in this tree. In the gate it holds what its
# sanitized tests are made of, and no more: hooks are in the fuzzer of the actor, and the library as it is preloaded, which they are
# compiled for once more, is not made.
sanitizers_preset() { if [ "$long" = yes ]; then echo sanitizers; else echo sanitizers-gate; fi; }

build_sanitizers() {
    local targets=(core/all box2d_glue/all tests/all)
    [ "$long" = no ] || targets+=(plugin/all boomerang-scene boomerang-scene-plugin)
    build_tree sanitizers "$(sanitizers_preset)" -- "${targets[@]}"
}

# The testbed's programs and pages, which no test runs under a sanitizer: looked at by the compiler, not made.
check_rest_with_clang() {
    python3 - "$BMR_BUILD_DIR/compile_commands.json" <<'PYTHON' |
import json, re, shlex, sys
for command in json.load(open(sys.argv[1])):
    if re.search(r" -o testbed_scenes/CMakeFiles/boomerang-testbed", command["command"]):
        line = re.sub(r" -o \S+ -c ", " -fsyntax-only ", command["command"])
        print("cd", shlex.quote(command["directory"]), "&&", line)
PYTHON
        sort -u | xargs -d '\n' -n 1 -P "$jobs" bash -c
}

stage_sanitizers() {
    check "build with clang, warnings are errors" build_sanitizers || return 1
    [ "$long" = no ] || check "the testbed's programs with clang, warnings are errors" check_rest_with_clang
}
