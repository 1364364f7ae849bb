# SPDX-License-Identifier: MIT
# The shelf: Box2D 2.4.1 as games build it. README.md says what each variant is, and why.
#
# allocator, fma, hidden and regrouped are there with BOX2D_BUILDS_LONG alone. Those in ${BOX2D_ACCELERATED} are built a second
# time, from the same sources by the same flags, with boomerang_accelerate: box2d_VARIANT_accelerated, in
# <build>/VARIANT/accelerated/. (Where the first is of one source, this is of CMake's unity; without BOX2D_BUILDS_LONG always.)
#
# After box2d_shelf(SOURCE), for each VARIANT of ${BOX2D_SHELF}:
#
#   the target box2d_VARIANT     the library; who links it has its headers, definitions and flags
#   <build>/VARIANT/             its file: libbox2d.so.2 (Box2D's own soname) or libbox2d.a
#   BOX2D_VARIANT_GAME           the flags and definitions that a game is compiled with, as a list
#   BOX2D_VARIANT_HEADERS        the directories of its headers
#
# Where one source is as good as many, all are compiled as one: it takes a third of the time. (In a shared library a function
# that can be seen from outside is called by its name, also within one source.)
set(BOX2D_SHELF debian ndebug units10 static)
set(BOX2D_SHELF_STATIC static)
set(BOX2D_SHELF_FUSED fma regrouped)
set(BOX2D_ACCELERATED static)
if(BOX2D_BUILDS_LONG)
  list(APPEND BOX2D_SHELF allocator fma hidden regrouped)
  list(APPEND BOX2D_SHELF_STATIC hidden regrouped)
  set(BOX2D_ACCELERATED static ndebug allocator units10 fma hidden regrouped)
endif()

execute_process(COMMAND dpkg-buildflags --get CPPFLAGS OUTPUT_VARIABLE debian_preprocessor OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND dpkg-buildflags --get CXXFLAGS OUTPUT_VARIABLE debian_compiler OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND dpkg-buildflags --get LDFLAGS OUTPUT_VARIABLE debian_linker OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(debian_flags UNIX_COMMAND "${debian_preprocessor} ${debian_compiler}")
separate_arguments(debian_linker UNIX_COMMAND "${debian_linker}")
list(FILTER debian_flags EXCLUDE REGEX "^-ffile-prefix-map=") # names the directory that this is called in

# What Box2D's own CMakeLists.txt sets for a shared library.
set(shared_flags -fPIC -fvisibility=hidden -fvisibility-inlines-hidden)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
  set(fused -march=haswell)
else()
  set(fused -ffp-contract=fast) # processors that all have it, where a compiler may be told not to use it
endif()

# box2d_variant(<variant> [ARCHIVE] [FILE_BY_FILE] [FLAGS <flag>...] [LINK <flag>...] [GAME <flag>...] [SETTINGS <directory>])
#   FLAGS: of the library; GAME: of the library and the game; SETTINGS: where its b2_user_settings.h is
function(box2d_variant name)
  cmake_parse_arguments(PARSE_ARGV 1 with "ARCHIVE;FILE_BY_FILE" "SETTINGS" "FLAGS;LINK;GAME")
  set(sources ${box2d_one_source})
  if(with_FILE_BY_FILE)
    set(sources ${box2d_sources})
  endif()
  set(headers ${BOX2D_SOURCE}/include)
  set(game ${with_GAME})
  if(with_SETTINGS)
    list(APPEND game -DB2_USER_SETTINGS)
    list(APPEND headers ${with_SETTINGS})
    file(GLOB more ${with_SETTINGS}/*.cpp)
    list(APPEND sources ${more})
  endif()
  set(type STATIC)
  if(NOT with_ARCHIVE)
    set(type SHARED)
    list(APPEND game -DB2_SHARED)
  endif()
  set(targets box2d_${name})
  add_library(box2d_${name} ${type} ${sources})
  if(name IN_LIST BOX2D_ACCELERATED)
    list(APPEND targets box2d_${name}_accelerated)
    add_library(box2d_${name}_accelerated ${type} ${box2d_sources} ${more})
    if(NOT with_FILE_BY_FILE OR NOT BOX2D_BUILDS_LONG)
      set_target_properties(box2d_${name}_accelerated PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif()
  endif()
  foreach(target IN LISTS targets)
    set(place ${PROJECT_BINARY_DIR}/${name})
    if(target MATCHES "_accelerated$")
      string(APPEND place /accelerated)
    endif()
    set_target_properties(${target} PROPERTIES OUTPUT_NAME box2d SOVERSION 2 CXX_STANDARD 11 CXX_EXTENSIONS OFF
      POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL box2d_EXPORTS
      LIBRARY_OUTPUT_DIRECTORY ${place} ARCHIVE_OUTPUT_DIRECTORY ${place})
    target_include_directories(${target} SYSTEM INTERFACE ${headers} PRIVATE ${headers} ${BOX2D_SOURCE}/src)
    target_compile_options(${target} PRIVATE ${with_FLAGS} ${game} -w)
    target_link_options(${target} PRIVATE ${with_LINK})
    if(target MATCHES "_accelerated$")
      # As in a project with warnings that are errors.
      set_property(DIRECTORY PROPERTY COMPILE_OPTIONS -Werror -Wall -Wextra -Wpedantic -Wconversion -Wold-style-cast -Wdouble-promotion -Wundef)
      boomerang_accelerate(${target})
      set_property(DIRECTORY PROPERTY COMPILE_OPTIONS "")
      target_compile_options(${target}_boomerang PRIVATE ${BOX2D_BUILDS_OURS})
    endif()
  endforeach()
  set(BOX2D_${name}_GAME ${game} PARENT_SCOPE)
  set(BOX2D_${name}_HEADERS ${headers} PARENT_SCOPE)
endfunction()

macro(box2d_shelf source)
  set(BOX2D_SOURCE ${source})
  file(GLOB box2d_sources ${source}/src/*/*.cpp)
  # So that a program can put an allocator of its own in front of b2Alloc_Default (LINKER:--wrap).
  set_source_files_properties(${source}/src/common/b2_settings.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  list(TRANSFORM box2d_sources REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE includes)
  string(REPLACE ";" "\n" includes "${includes}")
  set(box2d_one_source ${PROJECT_BINARY_DIR}/one_source.cpp)
  file(CONFIGURE OUTPUT ${box2d_one_source} CONTENT "@includes@\n" @ONLY)

  box2d_variant(debian FILE_BY_FILE FLAGS ${shared_flags} ${debian_flags} LINK ${debian_linker})
  box2d_variant(ndebug FLAGS ${shared_flags} -O3 GAME -DNDEBUG)
  box2d_variant(units10 FLAGS ${shared_flags} -O2 SETTINGS ${CMAKE_CURRENT_LIST_DIR}/settings/units10)
  box2d_variant(static ARCHIVE FILE_BY_FILE FLAGS -O2)
  if(BOX2D_BUILDS_LONG)
    box2d_variant(allocator FLAGS ${shared_flags} -O2 SETTINGS ${CMAKE_CURRENT_LIST_DIR}/settings/allocator)
    box2d_variant(fma FLAGS ${shared_flags} -O3 GAME ${fused})
    box2d_variant(hidden ARCHIVE FLAGS -O2 -fvisibility=hidden -fvisibility-inlines-hidden)
    box2d_variant(regrouped ARCHIVE FILE_BY_FILE FLAGS -O3 GAME ${fused} -ffast-math)
  endif()
endmacro()
