# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs with clang, its address and undefined-behaviour sanitizers and its counts of lines; warnings are errors

# The stages sanitized-tests, fuzz, coverage and (of a whole run) determinism work in this tree. A brief run makes there what
# its sanitized tests are, and no more.
build_sanitizers() {
    local rest=ON rooms='differential;hooks;consumer;controls;examples;plugin;browser;bad_input;fuzz;threads;stale;mutation'
    local targets=(core/all box2d_glue/all plugin/all tests/all)
    if [ "$brief" = no ]; then
        targets+=(boomerang-scene boomerang-scene-plugin)
    else
        rest=OFF rooms='bad_input;fuzz;stale'
    fi
    build_tree sanitizers sanitizers "-DBOOMERANG_BUILD_TESTBED=$rest" "-DBOOMERANG_BUILD_BENCHMARKS=$rest" \
        "-DBOOMERANG_TEST_ROOMS=$rooms" -- "${targets[@]}"
}

# The testbed's programs and pages, which no test runs under a sanitizer: looked at by the compiler, not made.
check_rest_with_clang() {
    python3 - "$BMR_BUILD_DIR/compile_commands.json" <<'PYTHON' |
import json, re, shlex, sys
for command in json.load(open(sys.argv[1])):
    if re.search(r" -o testbed_scenes/(driver|manual|report)/", command["command"]):
        line = re.sub(r" -o \S+ -c ", " -fsyntax-only ", command["command"])
        print("cd", shlex.quote(command["directory"]), "&&", line)
PYTHON
        sort -u | xargs -d '\n' -n 1 -P "$jobs" bash -c
}

stage_sanitizers() {
    check "build with clang, warnings are errors" build_sanitizers || return 1
    [ "$brief" = yes ] || check "the testbed's programs with clang, warnings are errors" check_rest_with_clang
}
