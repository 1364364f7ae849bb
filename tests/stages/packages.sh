# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: MIT
# what is missing is installed, or the line to type is printed

stage_packages() { bmr_need_packages "${BMR_BUILD_PACKAGES[@]}" "${BMR_TEST_PACKAGES[@]}"; }
