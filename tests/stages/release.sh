# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs and tests with gcc -O3; all tests

# The testbed and the static glue are compiled the quick way here; that each file includes what it needs shows in the plugin and, of
# the testbed, in the tree of the sanitizers of a long run.
# In the gate most tests of core and of the glue run under the sanitizers alone (tests/CMakeLists.txt says which run here).
build_release() {
    local share=''
    [ "$long" = yes ] || share=plain
    build_tree release release "-DBOOMERANG_TEST_SHARE=$share" -DBOOMERANG_BUILD_TESTS=ON -DBOOMERANG_QUICK_BUILD=ON \
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
