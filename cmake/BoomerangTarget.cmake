# SPDX-License-Identifier: MIT
# What every target of this project is compiled with.
#   boomerang_target(<target>)
# Floating point must mean the same thing everywhere: no contraction, no fast-math.
function(boomerang_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off
    $<$<BOOL:${BOOMERANG_WARNINGS_AS_ERRORS}>:-Werror>)
  set_target_properties(${target} PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF
    CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  if(BOOMERANG_SANITIZE)
    # More optimisation than this takes gcc minutes for a large test.
    target_compile_options(${target} PRIVATE -O1)
    target_compile_options(${target} PRIVATE -fsanitize=${BOOMERANG_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${BOOMERANG_SANITIZE})
  endif()
endfunction()

# boomerang_find(<target> <package> [<arguments of find_package>...]): a package whose target is seen everywhere, also by
# a project that adds this one as a subdirectory and links a target of ours.
macro(boomerang_find target)
  if(NOT TARGET ${target})
    find_package(${ARGN} REQUIRED)
    set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
  endif()
endmacro()
