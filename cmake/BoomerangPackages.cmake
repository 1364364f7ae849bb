# SPDX-License-Identifier: MIT
# Debian packages: `cpack --config build/CPackConfig.cmake`, in a tree that was configured with BOOMERANG_PACKAGE_MAINTAINER. One for
# each component of BoomerangInstall.cmake.
#
#   libboomerang-box2d1       runtime               MIT. The plugin; no dependency of it is under the GPL
#   libboomerang-core1        core                  MIT
#   libboomerang-kinetic1     kinetic               links GSL: with it, under the GPL-3 or later
#   libboomerang-dev          development           MIT
#   libboomerang-kinetic-dev  development_kinetic   what is linked with libboomerang_kinetic.a is, as above
#   boomerang-tools           tools                 MIT
#   boomerang-testbed         testbed               links GSL: with it, under the GPL-3 or later
#   boomerang-doc             documentation         MIT
#   python3-boomerang         python                MIT; boomerang.kinetic loads libboomerang-kinetic1
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME boomerang)
set(CPACK_PACKAGE_CONTACT "${BOOMERANG_PACKAGE_MAINTAINER}") # BoomerangDependencies.cmake refuses to go on without
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
# Which of Debian's libraries the programs need is found when packages are made, in one look at each (BoomerangDependencies.cmake).
# (CPack's own way of it looks at every file of every package, and adds scripts that call ldconfig.)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/BoomerangPackageFiles.cmake)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/BoomerangDependencies.cmake)
set(CPACK_BOOMERANG_LIBRARY_DIRECTORY ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_BOOMERANG_WORK ${PROJECT_BINARY_DIR}/control)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_COMPONENTS_ALL "")
unset(CPACK_PACKAGE_DESCRIPTION_SUMMARY)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(boomerang_exact "(= ${PROJECT_VERSION})")
set(boomerang_gpl "It contains or loads the GNU Scientific Library, which is under the GNU General Public License, version 3 or later.
 Whoever distributes it with that library does so under that license: /usr/share/common-licenses/GPL-3.")

# boomerang_package(<component> <package> <summary> [DESCRIPTION <text>] [ARCHITECTURE all] [SECTION <section>] [COMMENT <on licenses>]
#   [CONTROL <file>...] [BINARIES <target>...] [DEPENDS <relation>...] [RECOMMENDS <relation>...])
function(boomerang_package component package summary)
  cmake_parse_arguments(arg "" "ARCHITECTURE;SECTION;COMMENT;DESCRIPTION" "CONTROL;BINARIES;DEPENDS;RECOMMENDS" ${ARGN})
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DISPLAY_NAME "${summary}" PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${arg_DESCRIPTION}" PARENT_SCOPE)
  set(binaries "")
  foreach(target IN LISTS arg_BINARIES)
    list(APPEND binaries $<TARGET_FILE:${target}>)
  endforeach()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/control/${component}.binaries CONTENT "${binaries}")
  foreach(relation DEPENDS RECOMMENDS)
    list(JOIN arg_${relation} ", " ${relation})
    set(CPACK_DEBIAN_${upper}_PACKAGE_${relation} "${${relation}}" PARENT_SCOPE)
  endforeach()
  if(NOT arg_SECTION)
    set(arg_SECTION libs)
  endif()
  if(arg_SECTION MATCHES "^lib") # (cpack has no variable for this field; what stands behind a section is its next lines.)
    string(APPEND arg_SECTION "\nMulti-Arch: same")
  endif()
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
  if(arg_ARCHITECTURE)
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE ${arg_ARCHITECTURE} PARENT_SCOPE)
  endif()
  set(CPACK_DEBIAN_${upper}_PACKAGE_CONTROL_EXTRA "${arg_CONTROL}" PARENT_SCOPE)
  # Debian's own file of licenses. Only packages have it: who installs a tree has LICENSE.
  set(comment "${arg_COMMENT}")
  configure_file(${PROJECT_SOURCE_DIR}/tools/packages/copyright.in ${PROJECT_BINARY_DIR}/copyright/${package}/copyright @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/copyright/${package}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

# The lists of symbols and of libraries that dpkg-shlibdeps reads, and ldconfig's trigger. The first line of the symbols has the names.
function(boomerang_library_control out symbols)
  get_filename_component(name ${symbols} NAME_WE)
  set(folder ${PROJECT_BINARY_DIR}/control/${name})
  file(READ ${symbols} text)
  string(REPLACE "#VERSION#" "${PROJECT_VERSION}" text "${text}")
  file(WRITE ${folder}/symbols "${text}")
  file(WRITE ${folder}/triggers "activate-noawait ldconfig\n")
  string(REGEX REPLACE "^([^ ]+)\\.so\\.([0-9]+) ([^ ]+) .*" "\\1 \\2 \\3 (>= ${PROJECT_VERSION})\n" shlibs "${text}")
  file(WRITE ${folder}/shlibs "${shlibs}")
  set(${out} ${folder}/symbols ${folder}/shlibs ${folder}/triggers PARENT_SCOPE)
endfunction()

set(boomerang_libraries "")
if(TARGET boomerang_core_shared)
  boomerang_library_control(control ${PROJECT_SOURCE_DIR}/core/abi/libboomerang-core.symbols)
  boomerang_package(core libboomerang-core1 "kinetic data structures for convex polygons" CONTROL ${control} BINARIES boomerang_core_shared DESCRIPTION
    "Separation certificates for moving convex polygons, after Erickson, Guibas,\nStolfi and Zhang (SODA 1999). C, no dependency but libm.")
  list(APPEND boomerang_libraries "libboomerang-core1 ${boomerang_exact}")
  boomerang_package(python python3-boomerang "kinetic data structures for convex polygons, from Python" ARCHITECTURE all SECTION python
    DEPENDS "python3 (>= 3.8)" "libboomerang-core1 (>= ${PROJECT_VERSION})" RECOMMENDS "libboomerang-kinetic1 (>= ${PROJECT_VERSION})"
    DESCRIPTION "Polygons, distances, pairs that keep a proof, and with libboomerang-kinetic1\nmotions, events and what the paper's table is measured with.")
endif()
if(TARGET boomerang_box2d)
  boomerang_library_control(control ${PROJECT_SOURCE_DIR}/plugin/abi/libboomerang-box2d.symbols)
  boomerang_package(runtime libboomerang-box2d1 "Boomerang as the polygon narrow phase of Box2D" CONTROL ${control} BINARIES boomerang_box2d
    RECOMMENDS "libbox2d2 (>= 2.4.1)"
    DESCRIPTION "A library that a game links, or that is preloaded into one with a shared\nBox2D 2.4: the same bits, with far fewer separation tests.")
  list(APPEND boomerang_libraries "libboomerang-box2d1 ${boomerang_exact}")
endif()
boomerang_package(development libboomerang-dev "headers, static libraries and CMake package of Boomerang" SECTION libdevel
  DEPENDS ${boomerang_libraries} RECOMMENDS "libbox2d-dev (>= 2.4.1)" "libpolyclipping-dev"
  DESCRIPTION "For programs that use core or the plugin, and for projects that compile\nBox2D themselves (boomerang_accelerate).")
if(TARGET boomerang_kinetic_shared)
  boomerang_library_control(control ${PROJECT_SOURCE_DIR}/core/abi/libboomerang-kinetic.symbols)
  boomerang_package(kinetic libboomerang-kinetic1 "motions and event times for Boomerang (GPL-3 through GSL)" CONTROL ${control} BINARIES boomerang_kinetic_shared
    DEPENDS "libboomerang-core1 ${boomerang_exact}" COMMENT "${boomerang_gpl}"
    DESCRIPTION "Algebraic and screw motions, failure times of certificates, simulations and\nworlds of many polygons. Links the GNU Scientific Library.")
endif()
if(TARGET boomerang_kinetic)
  set(boomerang_libraries "")
  if(TARGET boomerang_kinetic_shared)
    set(boomerang_libraries "libboomerang-kinetic1 ${boomerang_exact}")
  endif()
  boomerang_package(development_kinetic libboomerang-kinetic-dev "headers and static library of Boomerang's motions (GPL-3 through GSL)" SECTION libdevel
    DEPENDS "libboomerang-dev ${boomerang_exact}" ${boomerang_libraries} "libgsl-dev"
    COMMENT "A program that links libboomerang_kinetic.a links the GNU Scientific Library, which is under the GNU General Public
 License, version 3 or later: /usr/share/common-licenses/GPL-3."
    DESCRIPTION "For programs that simulate moving polygons with boomerang::kinetic, which\nlinks the GNU Scientific Library.")
endif()
if(TARGET boomerang) # the program that tries games
  boomerang_package(tools boomerang-tools "tells how much faster Boomerang makes a Box2D game" SECTION devel BINARIES boomerang
    DEPENDS "libboomerang-box2d1 ${boomerang_exact}"
    DESCRIPTION "Plays a game that has a shared Box2D as it is and with Boomerang preloaded,\ncompares every answer, and says what to do next.")
endif()
boomerang_package(documentation boomerang-doc "documentation and examples of Boomerang" ARCHITECTURE all SECTION doc
  DESCRIPTION "Pages, figures and the sources that they speak of.")
if(BOOMERANG_INSTALL_TESTBED AND TARGET boomerang-testbed)
  boomerang_package(testbed boomerang-testbed "measures Boomerang beside Box2D, and draws it (GPL-3 through GSL)" SECTION science
    BINARIES ${boomerang_programs} boomerang-count DEPENDS "libboomerang-box2d1 ${boomerang_exact}" COMMENT "${boomerang_gpl}"
    DESCRIPTION "Scenes on stock Box2D and with the plugin, compared bit by bit, and the paper's\ntable of events, measured, with figures, replays and reports.")
endif()
include(CPack)
