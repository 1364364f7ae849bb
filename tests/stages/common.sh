# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# What the stages share. Sourced by tests/run, which sets root, jobs, long, seed, build_base and work, a directory for this run.
#
# A stage NAME is the function stage_NAME (with _ for -) in NAME.sh. It calls `check` and `run_tests`, which write down in
# $work/verdicts what passed and what failed: stages may run in processes of their own.

heading() { printf '\n== %s\n' "$*"; }

# verdict PASSED FAILED [FAILURE]
verdict() { printf '%d %d %s\n' "$@" >>"$work/verdicts"; }

# check NAME COMMAND…: one check, counted.
check() {
    local name=$1
    shift
    if "$@"; then
        verdict 1 0 "$name"
        printf '%s: ok\n' "$name"
    else
        verdict 0 1 "$name"
        printf '%s: FAILED\n' "$name"
        return 1
    fi
}

# in_tree NAME: BMR_BUILD_DIR is from here on the tree of this name; `release` is the first.
in_tree() {
    BMR_BUILD_DIR=$build_base
    [ "$1" = release ] || BMR_BUILD_DIR=$build_base-$1
    mkdir -p "$BMR_BUILD_DIR" && BMR_BUILD_DIR=$(cd "$BMR_BUILD_DIR" && pwd)
}

# build_tree NAME PRESET [CMAKE-ARGUMENT…] [-- TARGET…]: once a run, and counted if it fails.
build_tree() {
    local name=$1 preset=$2 options=()
    shift 2
    in_tree "$name"
    [ ! -e "$work/built.$name" ] || return 0
    [ ! -e "$work/broken.$name" ] || return 1
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        options+=("$1")
        shift
    done
    [ $# -eq 0 ] || shift
    if bmr_configure "$preset" "${options[@]}" && BMR_JOBS=$jobs bmr_build "$@"; then
        touch "$work/built.$name"
    else
        touch "$work/broken.$name"
        verdict 0 1 "build ($name)"
        return 1
    fi
}

# run_tests NAME [CTEST-ARGUMENT…]: the tests of BMR_BUILD_DIR, each counted.
run_tests() {
    local name=$1 log=$BMR_BUILD_DIR/boomerang-ctest.log of bad
    shift
    # The pipe must not hide ctest's answer, and what ctest says is counted below: a run without tests is no success.
    # (One more than there are jobs: some tests wait, for a browser or for each other.)
    ctest --test-dir "$BMR_BUILD_DIR" --output-on-failure --no-tests=error --parallel $((jobs + 1)) "$@" 2>&1 |
        tee "$log" | grep --line-buffered -v -e '^ *Start ' -e '^Internal ctest' -e '^Test project' || true
    bad=$(sed -nE 's/^[0-9]+% tests passed, ([0-9]+) tests? failed out of [0-9]+.*/\1/p' "$log")
    of=$(sed -nE 's/^[0-9]+% tests passed, [0-9]+ tests? failed out of ([0-9]+).*/\1/p' "$log")
    if [ -z "$of" ]; then
        verdict 0 1 "$name: no tests ran"
        return 1
    fi
    verdict $((of - bad)) 0 "$name"
    [ "$bad" -eq 0 ] || verdict 0 "$bad" "$name: $bad tests"
}

# The project's own files among those that git knows, by pattern.
sources() { (cd "$root" && git ls-files -- "$@"); }

failures() { awk '$2 > 0 { n++ } END { print n + 0 }' "$work/verdicts"; }

# processor_seconds: sets REPLY to the seconds that this process and what it has waited for had of the processors.
processor_seconds() {
    local file=$work/processor.$BASHPID
    times >"$file"
    REPLY=$(tr 'ms' '  ' <"$file" | awk '{ sum += 60 * ($1 + $3) + $2 + $4 } END { printf "%d", sum }')
}

# run_stage NAME. A stage that ends badly without a word is a failure, too.
run_stage() {
    local started=$SECONDS before used
    touch "$work/verdicts"
    before=$(failures)
    processor_seconds
    used=$REPLY
    heading "$1: $(sed -n '3s/^# //p' "$root/tests/stages/$1.sh")"
    "stage_${1//-/_}" || [ "$(failures)" -gt "$before" ] || verdict 0 1 "stage $1"
    processor_seconds
    printf '%-16s %5d s, %5d s of the processors\n' "$1:" $((SECONDS - started)) $((REPLY - used)) | tee -a "$work/times"
    [ "$(failures)" -eq "$before" ]
}

# take_stages STAGE…: runs those of them that nobody else has begun, in this order.
take_stages() {
    local stage
    for stage; do
        if mkdir "$work/begun.$stage" 2>/dev/null; then run_stage "$stage" || true; fi
    done
}

# run_together STAGE…: two at a time, each with its half of the jobs: whoever ends one begins the next. What runs here is
# seen as it runs, the others afterwards. With one job, one after the other.
run_together() {
    local half=$((jobs / 2)) other
    if [ "$half" -eq 0 ]; then
        take_stages "$@"
        return
    fi
    (
        jobs=$half
        take_stages "${@:2}"
    ) >"$work/others" 2>&1 &
    other=$!
    (
        jobs=$half
        take_stages "$@"
    ) || verdict 0 1 "$1: ended before its time"
    wait "$other" || verdict 0 1 "what ran beside $1: ended before its time"
    cat "$work/others"
}

# What all stages wrote down, and the exit code.
report() {
    local passed failed
    heading "result"
    cat "$work/times"
    awk '$2 > 0 { sub(/^[0-9]+ [0-9]+ /, "failed: "); print }' "$work/verdicts"
    read -r passed failed < <(awk '{ p += $1; f += $2 } END { print p + 0, f + 0 }' "$work/verdicts")
    processor_seconds
    printf '%-16s %5d s, %5d s of the processors\n' all: "$SECONDS" "$REPLY"
    printf '%d passed, %d failed\n' "$passed" "$failed"
    [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
}
