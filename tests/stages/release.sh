# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs and tests with gcc -O3; all tests

# The testbed is compiled the quick way here; that each file includes what it needs shows in the tree of the sanitizers of a
# long run.
# In the gate tests/contracts and the corpora of tests/random, the actor's among them, are played under the sanitizers alone.
build_release() {
    local rooms=''
    [ "$long" = yes ] || rooms='gate;as_stock;front;plugin;plugin/hooks;plugin/threads;claims/steps'
    build_tree release release "-DBOOMERANG_TEST_ROOMS=$rooms" -DBOOMERANG_BUILD_TESTS=ON -DBOOMERANG_QUICK_BUILD=ON \
        -DBOOMERANG_WARNINGS_AS_ERRORS=ON
}

# Many worlds, from the seed of this run on; the test as_stock_actor has some.
check_random_worlds() {
    python3 "$root/tests/as_stock/actor/play.py" "$BMR_BUILD_DIR/bin" "$BMR_BUILD_DIR/lib/libboomerang_box2d.so" --first "$seed" --seeds 5000
}

stage_release() {
    local scale=1 throws=10000000
    if [ "$long" = no ]; then
        scale=0.1 throws=30000
    fi
    build_release || return 1
    BMR_TEST_SCALE=${BMR_TEST_SCALE:-$scale} \
        BMR_OUTLINE_THROWS=${BMR_OUTLINE_THROWS:-$throws} run_tests "tests (release)"
    [ "$long" = no ] || check "5,000 worlds of the actor from seed $seed on" check_random_worlds
}
