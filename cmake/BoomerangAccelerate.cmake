# SPDX-License-Identifier: MIT
# boomerang_accelerate(<target>): the Box2D that <target> compiles gets all of Boomerang's hooks, wherever it is built for. To be
# called once for a program, after the target is there:
#
#   add_subdirectory(box2d)            # or FetchContent_MakeAvailable(box2d)
#   boomerang_accelerate(box2d)
#
# <target> is the library or program that compiles b2_world.cpp. Of its sources those that define what hooks stand in front of
# are compiled through plugin/renamed, which gives these functions other names; the sources themselves stay as they are.
# Core, the glue and the hooks are compiled besides, with flags of their own, and become part of the target. Who links it finds
# <boomerang/box2d.h>, and <boomerang/contact_recorder.h>, whose library is inside. The plugin is at work from the first
# b2World::Step on; BOOMERANG=off in the environment, or bmr::Install with other options before that, says otherwise.
get_filename_component(BOOMERANG_ACCELERATE_SOURCE "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
if(NOT EXISTS "${BOOMERANG_ACCELERATE_SOURCE}/core") # the installed package: boomerangConfig.cmake
  set(BOOMERANG_ACCELERATE_SOURCE "${boomerang_SOURCE}")
endif()
set(BOOMERANG_ACCELERATE_SOURCE "${BOOMERANG_ACCELERATE_SOURCE}" CACHE INTERNAL "Where boomerang_accelerate finds core, box2d_glue and plugin")

# What must stand in Box2D's files for this to be a Box2D that is known, beside the definitions of what is renamed: the calls that the
# renaming tells from them.
set(_boomerang_signs
  "b2_contact_manager@Destroy(b2Contact@Destroy(cNuke)"
  "b2_distance@Set(const b2Shape@b2Distance(b2DistanceOutput"
  "b2_world@DestroyJoint(je0@b2World::~b2World()"
  CACHE INTERNAL "")

# Box2D's files that define what hooks stand in front of, each with what must stand in it: "name.cpp@sign@...". (hook_list.h)
function(_boomerang_read_hooks out)
  file(READ "${BOOMERANG_ACCELERATE_SOURCE}/box2d_glue/start/hook_list.h" list)
  string(REGEX MATCHALL "define BMR_HOOKS_OF_[a-z0-9_]+|HOOK\\([A-Za-z]+,[ \\\n]*[A-Za-z0-9:]+" words "${list}")
  set(files "")
  foreach(word IN LISTS words)
    if(word MATCHES "^define BMR_HOOKS_OF_(.+)$")
      set(file ${CMAKE_MATCH_1})
      list(APPEND files ${file})
      set(signs ${_boomerang_signs})
      list(FILTER signs INCLUDE REGEX "^${file}@")
      string(REGEX REPLACE "^${file}" "" ${file}_signs "${signs}")
    elseif(word MATCHES "([A-Za-z0-9:]+)$")
      string(APPEND ${file}_signs "@${CMAKE_MATCH_1}(")
    endif()
  endforeach()
  set(renamed "")
  foreach(file IN LISTS files)
    list(APPEND renamed "${file}.cpp${${file}_signs}")
  endforeach()
  set(${out} "${renamed}" PARENT_SCOPE)
endfunction()

function(_boomerang_accelerate_refuses target why)
  message(FATAL_ERROR "boomerang_accelerate(${target}): ${why}")
endfunction()

# Of this target and those that it links, the first that compiles b2_world.cpp; nothing where none does.
function(_boomerang_find_compiling target out)
  set(left ${target})
  set(seen "")
  set(${out} "" PARENT_SCOPE)
  while(left)
    list(POP_FRONT left next)
    if(NOT TARGET "${next}" OR next IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${next})
    get_target_property(sources ${next} SOURCES)
    if(sources MATCHES "(^|[/;:])b2_world\\.cpp>*(;|$)")
      get_target_property(aliased ${next} ALIASED_TARGET)
      if(aliased)
        set(next ${aliased})
      endif()
      set(${out} ${next} PARENT_SCOPE)
      return()
    endif()
    foreach(property LINK_LIBRARIES INTERFACE_LINK_LIBRARIES)
      get_target_property(links ${next} ${property})
      if(links)
        list(APPEND left ${links})
      endif()
    endforeach()
  endwhile()
endfunction()

# The target's own source of this name, as it is listed and as a path; neither where there is none.
function(_boomerang_find_source target name listed_out path_out)
  get_target_property(sources ${target} SOURCES)
  get_target_property(directory ${target} SOURCE_DIR)
  get_target_property(binary ${target} BINARY_DIR)
  set(${listed_out} "" PARENT_SCOPE)
  set(${path_out} "" PARENT_SCOPE)
  foreach(listed IN LISTS sources)
    if(NOT listed MATCHES "(^|/|:)${name}>*$")
      continue()
    endif()
    if(listed MATCHES "^\\$<")
      _boomerang_accelerate_refuses(${target} "${name} is listed by a generator expression (${listed}); list the file itself")
    endif()
    foreach(path "${listed}" "${directory}/${listed}" "${binary}/${listed}")
      if(IS_ABSOLUTE "${path}" AND EXISTS "${path}")
        set(${listed_out} "${listed}" PARENT_SCOPE)
        set(${path_out} "${path}" PARENT_SCOPE)
        return()
      endif()
    endforeach()
    _boomerang_accelerate_refuses(${target} "its source ${listed} is not there")
  endforeach()
endfunction()

# Is this source what the renaming was made for? Blanks may be other ones.
function(_boomerang_check_source target path signs)
  file(READ "${path}" text)
  string(REGEX REPLACE "[ \t\r\n]+" " " text "${text}")
  foreach(sign IN LISTS signs)
    string(STRIP "${sign}" sign)
    string(FIND "${text}" "${sign}" place)
    if(place LESS 0)
      string(REPLACE "( " "(" tight "${text}")
      string(FIND "${tight}" "${sign}" place)
    endif()
    if(place LESS 0)
      get_filename_component(name "${path}" NAME)
      _boomerang_accelerate_refuses(${target} "this is not Box2D 2.4.1 or 2.4.2: ${name} has no \"${sign}\"")
    endif()
  endforeach()
endfunction()

# The file that compiles one of Box2D's through ours: the one of the same name.
function(_boomerang_wrap_source target renaming name_out wrapper_out)
  string(REPLACE "@" ";" signs "${renaming}")
  list(POP_FRONT signs name)
  _boomerang_find_source(${target} ${name} listed path)
  if(NOT path)
    _boomerang_accelerate_refuses(${target} "this is not Box2D 2.4.1 or 2.4.2: the target does not compile ${name}")
  endif()
  _boomerang_check_source(${target} "${path}" "${signs}")
  set(wrapper "${CMAKE_CURRENT_BINARY_DIR}/boomerang_${target}/${name}")
  set(renamed "${BOOMERANG_ACCELERATE_SOURCE}/plugin/renamed/${name}")
  string(REGEX REPLACE "\\.cpp$" "" file ${name})
  set(renames "")
  set(ends "")
  if(NOT EXISTS "${renamed}") # each function is called from other files alone
    string(REGEX MATCHALL "[A-Za-z0-9]+\\(" functions "${signs}")
    foreach(function IN LISTS functions)
      string(REGEX REPLACE "\\($" "" function ${function})
      string(REGEX REPLACE "^b2" "" name_here ${function})
      string(APPEND renames "#define ${function} BmrStock${name_here}\n")
      string(APPEND ends "#undef ${function}\n")
    endforeach()
    set(renamed "${path}")
  endif()
  file(CONFIGURE OUTPUT "${wrapper}" @ONLY CONTENT [[
#define BMR_BOX2D_SOURCE "@path@"
#include "@BOOMERANG_ACCELERATE_SOURCE@/box2d_glue/start/hook_list.h"
@renames@#include "@renamed@"
@ends@namespace bmr {
namespace stock {
BMR_HOOKS_OF_@file@(BMR_DECLARE_STOCK) BMR_HOOKS_OF_@file@(BMR_DEFINE_STOCK)
} // namespace stock
} // namespace bmr
]])
  set_source_files_properties("${wrapper}" TARGET_DIRECTORY ${target} PROPERTIES
    SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON OBJECT_DEPENDS "${path};${renamed}")
  foreach(property COMPILE_OPTIONS COMPILE_FLAGS COMPILE_DEFINITIONS INCLUDE_DIRECTORIES)
    get_property(value SOURCE "${path}" TARGET_DIRECTORY ${target} PROPERTY ${property})
    if(value)
      set_property(SOURCE "${wrapper}" TARGET_DIRECTORY ${target} PROPERTY ${property} "${value}")
    endif()
  endforeach()
  set(${name_out} ${name} PARENT_SCOPE)
  set(${wrapper_out} "${wrapper}" PARENT_SCOPE)
endfunction()

function(boomerang_accelerate)
  if(NOT ARGC EQUAL 1)
    _boomerang_accelerate_refuses("${ARGN}" "it takes one argument, the target that compiles b2_world.cpp")
  endif()
  set(target ${ARGV0})
  if(NOT TARGET ${target})
    _boomerang_accelerate_refuses(${target} "there is no such target (yet: call it after the one that makes the target)")
  endif()
  get_target_property(aliased ${target} ALIASED_TARGET)
  if(aliased)
    set(target ${aliased})
  endif()
  get_target_property(imported ${target} IMPORTED)
  get_target_property(type ${target} TYPE)
  _boomerang_find_compiling(${target} compiling)
  if(compiling AND NOT compiling STREQUAL target)
    _boomerang_accelerate_refuses(${target} "the target does not compile b2_world.cpp; name the one that does: boomerang_accelerate(${compiling})")
  endif()
  if(imported OR type STREQUAL "INTERFACE_LIBRARY")
    _boomerang_accelerate_refuses(${target} "nothing is compiled for this target; a Box2D that is built already is for boomerang::box2d, where it is a shared library")
  endif()
  get_target_property(again ${target} BOOMERANG_ACCELERATED)
  if(again)
    _boomerang_accelerate_refuses(${target} "it was called for this target before")
  endif()
  _boomerang_find_source(${target} b2_world.cpp listed path)
  get_target_property(sources ${target} SOURCES)
  if(NOT path)
    if(sources MATCHES "(^|[/;])(solver_set|constraint_graph)\\.c(;|$)") # every 3.x has one of these
      _boomerang_accelerate_refuses(${target} "this is Box2D 3, which is another program in C; Boomerang is for 2.4.1 and 2.4.2")
    endif()
    _boomerang_accelerate_refuses(${target} "the target does not compile b2_world.cpp; name the one that does")
  endif()
  if(sources MATCHES "(^|[/;])b2_rope_joint\\.cpp(;|$)")
    _boomerang_accelerate_refuses(${target} "this is Box2D 2.4.0, which has b2_rope_joint.cpp; 2.4.1 and 2.4.2 are known")
  endif()

  set(root "${BOOMERANG_ACCELERATE_SOURCE}")
  set(renamed "${root}/plugin/renamed")
  _boomerang_read_hooks(renamed_files)
  foreach(renaming IN LISTS renamed_files)
    _boomerang_wrap_source(${target} "${renaming}" listed wrapper)
    list(TRANSFORM sources REPLACE "^.+$" "${wrapper}" REGEX "^(.*/)?${listed}$")
  endforeach()
  # (Not the global list of languages: a folder further down may have C, as Debian's Box2D has, and this one not.)
  if(NOT DEFINED CMAKE_C_COMPILE_OBJECT)
    _boomerang_accelerate_refuses(${target} "the project needs the language C, too: project(... LANGUAGES C CXX), or enable_language(C) ahead of the call")
  endif()
  set_property(TARGET ${target} PROPERTY BOOMERANG_ACCELERATED TRUE)
  set_property(TARGET ${target} PROPERTY SOURCES "${sources}")

  # Box2D's bits are to be those of every other machine: its products are not fused. Neither are those of its inline functions in the
  # files that use it, because the linker keeps one copy of each. gcc's vectorizer fuses even so where the processor can: Box2D is
  # compiled without these instructions, what uses it without that pass. Set at the end of this folder: the last option counts.
  if(MSVC)
    set(as_written /fp:precise)
    set(as_written_here "")
    set(as_written_there "")
  else()
    set(as_written -fno-fast-math -ffp-contract=off)
    set(as_written_here "")
    set(as_written_there "$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-slp-vectorize>")
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i[3-6]86)$" AND NOT EMSCRIPTEN)
      set(as_written_here -mno-fma -mno-fma4)
    endif()
  endif()
  list(JOIN as_written " " words) # in one piece: CMake drops an option that was there before
  cmake_language(EVAL CODE "cmake_language(DEFER CALL target_compile_options [[${target}]]
    PUBLIC [[$<$<COMPILE_LANGUAGE:C,CXX,OBJC,OBJCXX>:SHELL:${words}>]]
    PRIVATE ${as_written_here} INTERFACE [[${as_written_there}]])")
  message(STATUS "boomerang_accelerate(${target}): ${target}, and what links it, is compiled with ${words}")

  # All of ours, once, as objects.
  set(ours ${target}_boomerang)
  file(GLOB core "${root}/core/geometry/*.c" "${root}/core/hierarchy/*.c" "${root}/core/certificate/*.c" "${root}/core/pair/*.c"
    "${root}/core/kds/*.c" "${root}/core/budget/*.c" "${root}/core/exact32/*.c" "${root}/core/convex32/*.c"
    "${root}/core/outline/*.c")
  file(GLOB glue "${root}/box2d_glue/*/*.cpp" "${root}/box2d_glue/glue/*/*.cpp"
    "${root}/box2d_glue/recorder/record/*.cpp" "${root}/plugin/hooks/*.cpp" "${renamed}/start.cpp")
  add_library(${ours} OBJECT ${core} ${glue})
  # The warnings of the project are for its own sources. (-Wa, -Wl and -Wp are no warnings.)
  get_target_property(inherited ${ours} COMPILE_OPTIONS)
  if(inherited)
    list(FILTER inherited EXCLUDE REGEX "^-(W([^alp]|.[^,]|$)|pedantic)")
    set_property(TARGET ${ours} PROPERTY COMPILE_OPTIONS "${inherited}")
  endif()
  set_target_properties(${ours} PROPERTIES C_STANDARD 11 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF CXX_STANDARD 17
    CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
    VISIBILITY_INLINES_HIDDEN ON UNITY_BUILD OFF)
  target_include_directories(${ours} PRIVATE "${root}/core" "${root}/core/include" "${root}/box2d_glue"
    "${root}/box2d_glue/include" "${root}/box2d_glue/recorder/include" "${root}/plugin" "${root}/plugin/include")
  target_include_directories(${ours} SYSTEM PRIVATE "$<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>")
  target_compile_definitions(${ours} PRIVATE BMR_RENAMED "$<TARGET_PROPERTY:${target},COMPILE_DEFINITIONS>")
  # Options that lay out Box2D's classes, or that find its b2_user_settings.h.
  target_compile_options(${ours} PRIVATE
    "$<FILTER:$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>,INCLUDE,^(SHELL:)?[-/](D|I|U|isystem|fpack-struct|fshort-enums|Zp)>")
  target_compile_options(${ours} PRIVATE ${as_written})
  if(MSVC)
    target_compile_options(${ours} PRIVATE /w)
  else()
    # Memory may be missing (hull.cpp).
    target_compile_options(${ours} PRIVATE -w
      "$<$<AND:$<COMPILE_LANGUAGE:CXX>,$<IN_LIST:-fno-rtti,$<TARGET_PROPERTY:${target},COMPILE_OPTIONS>>>:-fno-rtti>")
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$") # nor traps in a lane that is not used (BoomerangTarget.cmake)
      target_compile_options(${ours} PRIVATE
        $<$<OR:$<COMPILE_LANG_AND_ID:C,Clang>,$<COMPILE_LANG_AND_ID:CXX,Clang>>:-ffp-exception-behavior=maytrap>)
    endif()
    if(NOT EMSCRIPTEN)
      target_compile_options(${ours} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:-fexceptions>")
    endif()
  endif()
  if(type MATCHES "^(SHARED|MODULE)_LIBRARY$")
    set_target_properties(${ours} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    get_target_property(symbol ${target} DEFINE_SYMBOL)
    if(NOT symbol)
      string(MAKE_C_IDENTIFIER "${target}_EXPORTS" symbol)
    endif()
    target_compile_definitions(${ours} PRIVATE ${symbol})
    if(WIN32)
      target_compile_definitions(${ours} PRIVATE "BMR_API=__declspec(dllexport)")
    endif()
  else()
    # (As an option, for the property may be set later on, and takes no generator expression.)
    target_compile_options(${ours} PRIVATE
      "$<$<BOOL:$<TARGET_PROPERTY:${target},POSITION_INDEPENDENT_CODE>>:${CMAKE_CXX_COMPILE_OPTIONS_PIC}>")
  endif()
  if(UNIX AND NOT APPLE AND NOT EMSCRIPTEN AND NOT type STREQUAL "MODULE_LIBRARY")
    target_compile_options(${ours} PRIVATE -ftls-model=initial-exec) # it is loaded with the program
  endif()
  get_target_property(interprocedural ${target} INTERPROCEDURAL_OPTIMIZATION)
  if(interprocedural)
    set_property(TARGET ${ours} PROPERTY INTERPROCEDURAL_OPTIMIZATION ${interprocedural})
  endif()

  set_property(TARGET ${target} APPEND PROPERTY SOURCES $<TARGET_OBJECTS:${ours}>)
  if(type STREQUAL "OBJECT_LIBRARY") # objects in it are not part of it for those who link it
    set_property(TARGET ${target} APPEND PROPERTY INTERFACE_SOURCES $<BUILD_INTERFACE:$<TARGET_OBJECTS:${ours}>>)
  endif()
  foreach(headers core/include box2d_glue/include box2d_glue/recorder/include plugin/include)
    foreach(property INTERFACE_INCLUDE_DIRECTORIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES)
      set_property(TARGET ${target} APPEND PROPERTY ${property} "$<BUILD_INTERFACE:${root}/${headers}>")
    endforeach()
  endforeach()
  if(UNIX AND NOT EMSCRIPTEN)
    find_package(Threads QUIET)
    if(CMAKE_THREAD_LIBS_INIT)
      set_property(TARGET ${target} APPEND PROPERTY LINK_LIBRARIES ${CMAKE_THREAD_LIBS_INIT})
      set_property(TARGET ${target} APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${CMAKE_THREAD_LIBS_INIT})
    endif()
  endif()
endfunction()
