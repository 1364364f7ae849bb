# SPDX-License-Identifier: MIT
# What every target of this project is compiled with.
#   boomerang_target(<target>)
#   boomerang_shared(<target> <static target> <name> [<library>...])
#   boomerang_find(<option> <what> <Debian package> <target> <package> [<arguments of find_package>...])
# Floating point must mean the same thing everywhere: no contraction, no fast-math. And what a game may trap (FE_INVALID and
# the like) must not come from a lane that nobody uses: clang divides nothing by nothing there without -ffp-exception-behavior=maytrap.
function(boomerang_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -Wshadow -ffp-contract=off
    $<$<BOOL:${BOOMERANG_WARNINGS_AS_ERRORS}>:-Werror>)
  set_target_properties(${target} PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF
    CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE folder)
  # What reads options, and tests, are other people's templates mostly.
  if(folder MATCHES "^(tools|tests)")
    target_compile_options(${target} PRIVATE $<$<AND:$<CONFIG:Release>,$<COMPILE_LANGUAGE:CXX>>:-O1>)
  endif()
  if(folder MATCHES "^(core|box2d_glue|plugin)" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    target_compile_options(${target} PRIVATE
      $<$<OR:$<COMPILE_LANG_AND_ID:C,Clang>,$<COMPILE_LANG_AND_ID:CXX,Clang>>:-ffp-exception-behavior=maytrap>)
  endif()
  if(BOOMERANG_QUICK_BUILD AND folder MATCHES "^(testbed_scenes|box2d_glue$)" OR BOOMERANG_SANITIZE AND folder MATCHES "^(box2d_glue|plugin)")
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
    target_compile_options(${target} PRIVATE -Wno-shadow) # of another file's names
  endif()
  if(BOOMERANG_SANITIZE)
    # More optimisation than -O1 takes minutes for a large test; and C++ that is mostly other people's templates takes three
    # times as long to compile with -O1 as without, for programs that start, run once and end. Core is what tests run most.
    if(folder MATCHES "^core")
      target_compile_options(${target} PRIVATE -O2)
    elseif(folder MATCHES "^(box2d_glue|plugin|tests/random)")
      target_compile_options(${target} PRIVATE -O1)
    else()
      target_compile_options(${target} PRIVATE $<IF:$<COMPILE_LANGUAGE:CXX>,-O0,-O1>)
    endif()
    target_compile_options(${target} PRIVATE -fsanitize=${BOOMERANG_SANITIZE} -fno-omit-frame-pointer
      -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${BOOMERANG_SANITIZE})
    # Each program has a runtime of the sanitizers inside, which lld links in a third of the time.
    find_program(BOOMERANG_LLD ld.lld)
    if(BOOMERANG_LLD AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
      target_link_options(${target} PRIVATE -fuse-ld=lld)
    endif()
    # In the gate undefined behaviour is looked for in what is tested: the tests' own code takes half as long again to compile with that.
    # (Two targets of the tests have hooks of the plugin's in them.)
    if(BOOMERANG_TEST_SHARE STREQUAL "sanitized" AND folder MATCHES "^tests" AND NOT target MATCHES "^(boomerang_ahead|fuzz_actor_tested)$")
      target_compile_options(${target} PRIVATE -fno-sanitize=undefined)
    endif()
  endif()
  if(BOOMERANG_COVERAGE)
    target_compile_options(${target} PRIVATE -g1) # the lines of a sanitizer's report need no more
    if(folder MATCHES "^(core|core/kinetic|box2d_glue|plugin)$")
      target_compile_options(${target} PRIVATE -fprofile-instr-generate -fcoverage-mapping)
    endif()
    target_link_options(${target} PRIVATE -fprofile-instr-generate)
  endif()
endfunction()

# boomerang_shared(<target> <static target> <name> [<library>...]): lib<name>.so of the objects of a static library, nothing compiled
# twice. It shows the names that begin with bmr_, and hides the rest.
function(boomerang_shared target static name)
  set(map ${CMAKE_CURRENT_BINARY_DIR}/${name}.map)
  file(CONFIGURE OUTPUT ${map} CONTENT "BOOMERANG_1 { global: bmr_*; local: *; };\n" @ONLY)
  add_library(${target} SHARED $<TARGET_OBJECTS:${static}>)
  target_link_libraries(${target} PRIVATE ${ARGN})
  target_link_options(${target} PRIVATE LINKER:--version-script=${map} LINKER:-Bsymbolic-functions LINKER:--no-undefined LINKER:-z,now)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE C OUTPUT_NAME ${name} LINK_DEPENDS ${map}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
endfunction()

# boomerang_find(<option> <what> <Debian package> <target> <package> [<arguments of find_package>...]): what this option builds needs a
# package. Its target is then seen everywhere, also by a project that adds this one as a subdirectory and links a target of ours. Where it
# is not found, an option that is AUTO becomes OFF.
macro(boomerang_find option what debian target package)
  if(${option} AND NOT TARGET ${target})
    find_package(${package} ${ARGN} QUIET)
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES IMPORTED_GLOBAL TRUE)
    elseif(NOT "${${option}}" STREQUAL AUTO)
      message(FATAL_ERROR "Boomerang: ${what} needs ${package} (Debian: ${debian}); -D${option}=OFF leaves it out")
    else()
      message(STATUS "Boomerang: ${what} is left out, for there is no ${package} (Debian: ${debian}); -D${option}=OFF says that this is meant")
      set(${option} OFF)
    endif()
  endif()
endmacro()
