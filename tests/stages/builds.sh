# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# games on Box2D built as games build it, in four ways, with --long in twice as many: with the plugin they do what they do without

# With --long six are accelerated, and not one; five hundred worlds of the actor on each; and all scenes of the testbed on an accelerated Box2D, with their instructions.
stage_builds() {
    local plugin seeds=8 source ours=-O0
    [ "${long:-no}" = no ] || ours=-O2 # the bits are the same by any of them, and -O0 is built in half the time
    build_release || return 1
    plugin=$BMR_BUILD_DIR/lib/libboomerang_box2d.so
    in_tree builds
    # shellcheck source=tests/box2d_builds/processor.sh
    source "$root/tests/box2d_builds/processor.sh"
    [ "${long:-no}" = no ] || ! lacks_fma || bmr_need_packages qemu-user || return 1
    bmr_say "configuring $BMR_BUILD_DIR, with Box2D's source"
    bmr_quietly "$BMR_BUILD_DIR/boomerang-configure.log" cmake -S "$root/tests/box2d_builds" -B "$BMR_BUILD_DIR" -G Ninja \
        "-DBOX2D_BUILDS_PLUGIN=$plugin" -DBOOMERANG_WARNINGS_AS_ERRORS=ON "-DBOX2D_BUILDS_OURS=$ours" \
        "-DBOX2D_BUILDS_LONG=$([ "${long:-no}" = yes ] && echo ON || echo OFF)" || return 1
    BMR_JOBS=$jobs bmr_build || return 1
    if [ "${long:-no}" = yes ]; then
        seeds=500
    fi
    BOX2D_BUILDS_SEEDS=$seeds run_tests "games on each Box2D"
    [ "${long:-no}" = yes ] || return 0
    source=$BMR_BUILD_DIR/source
    check "an installed package accelerates a game's own Box2D" bmr_quietly "$BMR_BUILD_DIR/installed.log" installed_accelerates "$source" || true
    scenes_accelerated "$source"
}

# An installed package is all that a project needs to accelerate a Box2D of its own.
installed_accelerates() {
    local step
    in_tree release
    for step in install accelerated; do
        env SOURCE="$root" BUILD="$BMR_BUILD_DIR" WORK="$BMR_BUILD_DIR-installed" WITH_BOX2D=ON WITH_KINETIC=ON CC=gcc CXX=g++ \
            BOX2D_SOURCE="$1" bash "$root/tests/front/consumer/consume.sh" "$step" || return 1
    done
}

scenes_accelerated() {
    local programs
    build_tree accelerated release "-DBOOMERANG_BOX2D_SOURCE=$1" -- boomerang-scene boomerang-scene-plugin boomerang-scene-vendored \
        boomerang-scene-accelerated || return 1
    programs=$BMR_BUILD_DIR/accelerated/bin
    mkdir -p "$programs"
    ln -sf "$BMR_BUILD_DIR/bin/boomerang-scene-vendored" "$programs/boomerang-scene"
    ln -sf "$BMR_BUILD_DIR/bin/boomerang-scene-accelerated" "$programs/boomerang-scene-plugin"
    check "scenes on an accelerated Box2D" bmr_quietly "$BMR_BUILD_DIR/compare.log" "$root/tests/stages/determinism/run" --steps 300 \
        --programs "accelerated=${programs%/bin}" "$BMR_BUILD_DIR" || true
    check "what it costs" "$root/tests/box2d_builds/check_instructions.sh" "$BMR_BUILD_DIR" || true
}
