# SPDX-License-Identifier: MIT
# Installs the documentation: a few pages, and the files that these link to, page by page, so that a new one comes in by itself. What they link
# to in tests/ stays in the sources; such a link becomes the name of the file. Run by `cmake --install`, with these set:
#
#   boomerang_root          the sources
#   boomerang_pages         a directory of the build tree for pages as they are installed
#   boomerang_destination   where to, as DESTINATION
cmake_policy(PUSH)
cmake_policy(VERSION 3.22)
string(ASCII 1 open)
string(ASCII 2 close)
string(ASCII 3 semicolon)

function(boomerang_install_page page)
  file(READ "${boomerang_root}/${page}" text)
  # Brackets and semicolons mean something in a list of CMake's.
  string(REPLACE "[" "${open}" text "${text}")
  string(REPLACE "]" "${close}" text "${text}")
  string(REPLACE ";" "${semicolon}" text "${text}")
  string(REGEX MATCHALL "${close}\\([^()# \n]+" links "${text}")
  list(REMOVE_DUPLICATES links)
  cmake_path(GET page PARENT_PATH folder)
  foreach(link IN LISTS links)
    string(SUBSTRING "${link}" 2 -1 target)
    cmake_path(SET path NORMALIZE "${folder}/${target}")
    string(REGEX REPLACE "^/|/$" "" path "${path}")
    if(path MATCHES "^\\.\\." OR NOT EXISTS "${boomerang_root}/${path}")
      continue() # another place's, or none at all: tests/front looks for these
    elseif(path MATCHES "^tests(/|$)")
      string(REGEX REPLACE "([.+*?^$()])" "\\\\\\1" escaped "${target}")
      string(REGEX REPLACE "${open}([^${open}${close}]*)${close}\\(${escaped}(#[^()]*)?\\)" "\\1 (`${path}` in the sources)" text "${text}")
    elseif(IS_DIRECTORY "${boomerang_root}/${path}")
      file(INSTALL "${boomerang_root}/${path}/" DESTINATION "${where}/${path}" FILES_MATCHING PATTERN "*.h" PATTERN "*.c" PATTERN "*.cpp")
    elseif(path MATCHES "\\.md$")
      set_property(GLOBAL APPEND PROPERTY boomerang_pages_left "${path}")
    else()
      cmake_path(GET path PARENT_PATH beside)
      file(INSTALL "${boomerang_root}/${path}" DESTINATION "${where}/${beside}")
    endif()
  endforeach()
  string(REPLACE "${open}" "[" text "${text}")
  string(REPLACE "${close}" "]" text "${text}")
  string(REPLACE "${semicolon}" ";" text "${text}")
  file(WRITE "${boomerang_pages}/${page}" "${text}")
  file(INSTALL "${boomerang_pages}/${page}" DESTINATION "${where}/${folder}")
  set(CMAKE_INSTALL_MANIFEST_FILES "${CMAKE_INSTALL_MANIFEST_FILES}" PARENT_SCOPE) # what `uninstall` takes away
endfunction()

set(where "${boomerang_destination}")
if(NOT IS_ABSOLUTE "${where}")
  set(where "${CMAKE_INSTALL_PREFIX}/${where}")
endif()
string(MD5 boomerang_hash "$ENV{DESTDIR}${where}") # two installations may run at once
string(APPEND boomerang_pages "/${boomerang_hash}")
file(GLOB first RELATIVE "${boomerang_root}" "${boomerang_root}/*.md" "${boomerang_root}/docs/*.md" "${boomerang_root}/core/README.md")
set_property(GLOBAL PROPERTY boomerang_pages_left "${first}")
set(done "")
while(TRUE)
  get_property(left GLOBAL PROPERTY boomerang_pages_left)
  list(REMOVE_ITEM left "" ${done})
  list(POP_FRONT left page)
  if(NOT page)
    break()
  endif()
  list(APPEND done "${page}")
  boomerang_install_page("${page}")
endwhile()
file(REMOVE_RECURSE "${boomerang_pages}")
file(INSTALL "${boomerang_root}/LICENSE" "${boomerang_root}/CITATION.cff" DESTINATION "${where}")
foreach(examples core/examples core/python/examples plugin/examples)
  file(INSTALL "${boomerang_root}/${examples}/" DESTINATION "${where}/${examples}"
    FILES_MATCHING PATTERN "*.c" PATTERN "*.cpp" PATTERN "*.py")
endforeach()
cmake_policy(POP)
