# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# all programs with clang, its address and undefined-behaviour sanitizers and its counts of lines; warnings are errors

# The stages sanitized-tests, fuzz and coverage work in this tree.
build_sanitizers() { build_tree sanitizers sanitizers; }

stage_sanitizers() { check "build with clang, warnings are errors" build_sanitizers; }
