# SPDX-License-Identifier: MIT
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
