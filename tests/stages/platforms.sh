# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# with --long alone: an accelerated Box2D on Windows (by wine), in WebAssembly (by node), on 32 bits, by clang as Microsoft's compiler, with its address sanitizer

stage_platforms() {
    local source
    in_tree builds
    "$root/tests/box2d_builds/get_source.sh" "$BMR_BUILD_DIR" || return 1
    source=$BMR_BUILD_DIR/source
    platform mingw "$source" g++-mingw-w64-x86-64-posix wine64 wine -- .exe "${mingw[@]}" || true
    platform mingw-dll "$source" g++-mingw-w64-x86-64-posix wine64 wine -- .exe "${mingw[@]}" -DBUILD_SHARED_LIBS=ON || true
    platform 32-bit "$source" g++-multilib -- '' '-DCMAKE_C_FLAGS=-m32 -msse2 -mfpmath=sse' \
        '-DCMAKE_CXX_FLAGS=-m32 -msse2 -mfpmath=sse' || true
    platform wasm "$source" emscripten nodejs -- .js \
        -DCMAKE_TOOLCHAIN_FILE=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake || true
    platform ms-compatibility "$source" clang -- '' -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
        '-DCMAKE_CXX_FLAGS=-fms-compatibility -fms-extensions -fms-compatibility-version=19.30 -fgnuc-version=4.2.1' || true
    # No platform of its own, but as little a Box2D that anybody ships: what is used when it is gone is seen, and what is left behind.
    platform address-sanitizer "$source" clang -- '' -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
        '-DCMAKE_C_FLAGS=-fsanitize=address -fno-omit-frame-pointer' '-DCMAKE_CXX_FLAGS=-fsanitize=address -fno-omit-frame-pointer' || true
    # Box2D 2.4.2 is in no package: where its sources are is said.
    [ -z "${BMR_BOX2D_242:-}" ] || platform box2d-2.4.2 "$BMR_BOX2D_242" -- '' || true
}

mingw=(-DCMAKE_SYSTEM_NAME=Windows -DCMAKE_C_COMPILER=x86_64-w64-mingw32-gcc-posix
    -DCMAKE_CXX_COMPILER=x86_64-w64-mingw32-g++-posix)

# platform NAME SOURCE PACKAGE… -- SUFFIX CMAKE-ARGUMENT…
platform() {
    local name=$1 source=$2 packages=() suffix runner=()
    shift 2
    while [ "$1" != -- ]; do
        packages+=("$1")
        shift
    done
    suffix=$2
    shift 2
    bmr_need_packages "${packages[@]}" || return 1
    in_tree "platform-$name"
    [ "$suffix" != .js ] || export NODE_PATH=/usr/share/nodejs # where Debian's node finds what Emscripten asks for
    check "platform $name: configured" bmr_quietly "$BMR_BUILD_DIR/configure.log" cmake -S "$root/tests/box2d_builds/platforms" -B "$BMR_BUILD_DIR" \
        -G Ninja -DCMAKE_BUILD_TYPE=Release "-DBOX2D_SOURCE=$source" "$@" || return 1
    check "platform $name: built" bmr_quietly "$BMR_BUILD_DIR/build.log" cmake --build "$BMR_BUILD_DIR" --parallel "$jobs" || return 1
    case $suffix in
    .exe) runner=(env WINEDEBUG=-all "WINEPREFIX=$build_base-wine" wine) ;;
    .js) runner=(node --no-experimental-fetch) ;;
    esac
    check "platform $name" "$root/tests/box2d_builds/platforms/play.sh" "$BMR_BUILD_DIR" "$suffix" "${runner[@]}"
}
