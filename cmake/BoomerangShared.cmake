# SPDX-License-Identifier: MIT
# boomerang_shared(<target> <static target> <name> <symbols> [<library>...]): lib<name>.so of the objects of a static library, nothing
# compiled twice. It shows what the committed list of symbols names (Debian's format, docs/stability.md) and hides the rest. A new
# public function is shown once it is in the list: tests/front/abi.py add.
function(boomerang_shared target static name symbols)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${symbols})
  file(STRINGS ${symbols} lines REGEX "^ [^ ]+@[^ ]+ ")
  set(nodes "")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^ ([^ ]+)@([^ ]+) " matched "${line}")
    list(APPEND nodes ${CMAKE_MATCH_2})
    list(APPEND shown_${CMAKE_MATCH_2} ${CMAKE_MATCH_1})
  endforeach()
  list(REMOVE_DUPLICATES nodes)
  set(script "")
  set(hidden "local: *;")
  foreach(node IN LISTS nodes)
    list(JOIN shown_${node} "; " shown)
    string(APPEND script "${node} { global: ${shown}; ${hidden} };\n")
    set(hidden "")
  endforeach()
  set(map ${CMAKE_CURRENT_BINARY_DIR}/${name}.map)
  file(CONFIGURE OUTPUT ${map} CONTENT "${script}" @ONLY)
  add_library(${target} SHARED $<TARGET_OBJECTS:${static}>)
  target_link_libraries(${target} PRIVATE ${ARGN})
  target_link_options(${target} PRIVATE LINKER:--version-script=${map} LINKER:-Bsymbolic-functions LINKER:--no-undefined LINKER:-z,now)
  target_include_directories(${target} INTERFACE
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/core/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE C OUTPUT_NAME ${name} LINK_DEPENDS ${map}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
endfunction()
