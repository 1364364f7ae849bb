# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# cppcheck over core, the glue and the plugin

check_cppcheck() {
    (cd "$root" && cppcheck --quiet --error-exitcode=1 --inline-suppr -j "$jobs" \
        --enable=warning,performance,portability --suppress=missingIncludeSystem '--suppress=unknownMacro:plugin/renamed/*' --std=c11 --std=c++17 \
        '-DElfW(type)=Elf64_##type' \
        -I core -I core/include -I box2d_glue -I box2d_glue/include -I plugin -I plugin/include core box2d_glue plugin)
}

stage_cppcheck() { check "cppcheck" check_cppcheck; }
