# SPDX-License-Identifier: MIT
# What `cmake --install` puts where: libraries, headers, a CMake package and pkg-config files, all relocatable.
# And a target `uninstall`, which takes away what the last installation from this build tree put there; `installable` builds what is
# installed, and no more.
#
# Its parts, each to be had alone by `cmake --install build --component NAME`:
#
#   runtime               the plugin
#   tools                 `boomerang`, which tries games
#   core, kinetic         the shared libraries of core, for programs in C and for Python
#   development           headers, static libraries, the CMake package, pkg-config files, the sources that boomerang_accelerate
#                         compiles; without what needs GSL, which is
#   development_kinetic   the same of boomerang::kinetic
#   testbed               boomerang-testbed, its workers
#   documentation         README.md, docs/, and the sources that these link to
#   python                the Python module
#
# Files that are installed without a COMPONENT belong to the runtime.
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)

# boomerang_install_library(<component of the shared library> <target>...)
function(boomerang_install_library component)
  set(export boomerangTargets)
  set(development development)
  if(component STREQUAL "kinetic")
    set(export boomerangKineticTargets)
    set(development development_kinetic)
  endif()
  install(TARGETS ${ARGN} EXPORT ${export}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${development}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component} NAMELINK_COMPONENT ${development}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${component}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

set(boomerang_components core)
boomerang_install_library(core boomerang_core)
if(TARGET boomerang_core_shared)
  boomerang_install_library(core boomerang_core_shared)
endif()
if(TARGET boomerang_kinetic)
  boomerang_install_library(kinetic boomerang_kinetic)
  list(APPEND boomerang_components kinetic)
endif()
if(TARGET boomerang_kinetic_shared)
  boomerang_install_library(kinetic boomerang_kinetic_shared)
endif()
if(TARGET boomerang_box2d)
  boomerang_install_library(runtime boomerang_box2d_glue boomerang_box2d boomerang_recorder)
  list(APPEND boomerang_components box2d recorder)
endif()
if(TARGET boomerang_repair)
  boomerang_install_library(runtime boomerang_repair)
  list(APPEND boomerang_components repair)
  install(FILES ${PROJECT_SOURCE_DIR}/box2d_glue/repair/include/boomerang/repair.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang COMPONENT development)
endif()

# Headers that kinetic.h has beside boomerang.h are kinetic's.
file(GLOB core_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/include/boomerang/*.h)
file(STRINGS ${PROJECT_SOURCE_DIR}/core/include/boomerang/kinetic.h kinetic_headers REGEX "^#include \"boomerang/")
list(TRANSFORM kinetic_headers REPLACE "^#include \"(boomerang/.*)\"$" "${PROJECT_SOURCE_DIR}/core/include/\\1")
list(REMOVE_ITEM kinetic_headers ${PROJECT_SOURCE_DIR}/core/include/boomerang/boomerang.h)
list(APPEND kinetic_headers ${PROJECT_SOURCE_DIR}/core/include/boomerang/kinetic.h)
list(REMOVE_ITEM core_headers ${kinetic_headers})
install(FILES ${core_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang COMPONENT development)
if(TARGET boomerang_kinetic)
  install(FILES ${kinetic_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang COMPONENT development_kinetic)
endif()
if(TARGET boomerang_box2d)
  file(GLOB box2d_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/plugin/include/boomerang/*.h
    ${PROJECT_SOURCE_DIR}/box2d_glue/include/boomerang/*.h ${PROJECT_SOURCE_DIR}/box2d_glue/recorder/include/boomerang/*.h)
  install(FILES ${box2d_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang COMPONENT development)
endif()

# The pages as they lie in the sources, with what they link to. (Their links to tests/ lead somewhere in the sources alone.)
install(DIRECTORY docs core box2d_glue plugin DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation
  FILES_MATCHING REGEX "\\.(md|h|c|cpp|py|svg|png|gif)$" PATTERN "__pycache__" EXCLUDE)
install(FILES README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
install(FILES playground/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/playground COMPONENT documentation)
install(FILES testbed_scenes/scene.h DESTINATION ${CMAKE_INSTALL_DOCDIR}/testbed_scenes COMPONENT documentation)

# Debian's Python looks there below /usr, and below /usr/local in a folder with its version.
if(NOT DEFINED BOOMERANG_PYTHON_DIR)
  set(BOOMERANG_PYTHON_DIR lib/python3/dist-packages)
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr/local")
    find_package(Python3 QUIET COMPONENTS Interpreter)
    if(Python3_FOUND)
      set(BOOMERANG_PYTHON_DIR lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/dist-packages)
    endif()
  endif()
endif()
if(TARGET boomerang_core_shared)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/python/boomerang DESTINATION ${BOOMERANG_PYTHON_DIR} COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN "__pycache__" EXCLUDE)
endif()

if(TARGET boomerang_box2d AND CMAKE_SYSTEM_NAME STREQUAL "Linux") # `boomerang try`, which finds the library from where it is itself
  file(RELATIVE_PATH boomerang_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  configure_file(plugin/boomerang.sh.in bin/boomerang @ONLY)
  install(PROGRAMS ${PROJECT_BINARY_DIR}/bin/boomerang DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()
if(BOOMERANG_INSTALL_TESTBED AND TARGET boomerang-testbed)
  # The workers lie beside the program, which looks for them there; what they load is found from wherever that is.
  file(RELATIVE_PATH boomerang_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(boomerang_programs boomerang-testbed boomerang-scene)
  if(TARGET boomerang-scene-plugin)
    list(APPEND boomerang_programs boomerang-scene-plugin)
    set_target_properties(boomerang-scene-plugin PROPERTIES INSTALL_RPATH "$ORIGIN/${boomerang_bin_to_lib}")
  endif()
  install(TARGETS ${boomerang_programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT testbed)
  install(TARGETS boomerang-count LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/boomerang COMPONENT testbed)
endif()

# The sources that boomerang_accelerate compiles with a project's Box2D.
set(boomerang_source_dir ${CMAKE_INSTALL_DATADIR}/boomerang/source)
foreach(folder core/include core/geometry core/hierarchy core/certificate core/pair core/kds core/budget core/exact32 core/convex32 core/outline
    box2d_glue plugin/hooks plugin/include plugin/renamed)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${boomerang_source_dir}/${folder} COMPONENT development
    FILES_MATCHING PATTERN "*.c" PATTERN "*.cpp" PATTERN "*.h")
endforeach()

list(JOIN boomerang_components "|" boomerang_components_alternatives)
list(JOIN boomerang_components ", " boomerang_components_listed)
set(boomerang_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/boomerang)
install(EXPORT boomerangTargets NAMESPACE boomerang:: DESTINATION ${boomerang_package_dir} COMPONENT development)
if(TARGET boomerang_kinetic)
  install(EXPORT boomerangKineticTargets NAMESPACE boomerang:: DESTINATION ${boomerang_package_dir} COMPONENT development_kinetic)
endif()
# One package for the installation, and one for the build tree, which find_package takes for a prefix, too.
set(boomerang_package_modules ${CMAKE_CURRENT_LIST_DIR}/BoomerangAccelerate.cmake ${CMAKE_CURRENT_LIST_DIR}/BoomerangLinks.cmake
  ${CMAKE_CURRENT_LIST_DIR}/Findpolyclipping.cmake)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/boomerangConfigVersion.cmake COMPATIBILITY SameMajorVersion)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/boomerangConfig.cmake.in
  ${PROJECT_BINARY_DIR}/installed/boomerangConfig.cmake INSTALL_DESTINATION ${boomerang_package_dir} PATH_VARS boomerang_source_dir)
install(FILES ${PROJECT_BINARY_DIR}/installed/boomerangConfig.cmake ${PROJECT_BINARY_DIR}/boomerangConfigVersion.cmake
  ${boomerang_package_modules} DESTINATION ${boomerang_package_dir} COMPONENT development)
set(boomerang_source_dir ${PROJECT_SOURCE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/boomerangConfig.cmake.in
  ${PROJECT_BINARY_DIR}/boomerangConfig.cmake INSTALL_DESTINATION . INSTALL_PREFIX ${PROJECT_BINARY_DIR} PATH_VARS boomerang_source_dir)
foreach(module IN LISTS boomerang_package_modules)
  get_filename_component(name ${module} NAME)
  configure_file(${module} ${PROJECT_BINARY_DIR}/${name} COPYONLY)
endforeach()
export(EXPORT boomerangTargets NAMESPACE boomerang:: FILE ${PROJECT_BINARY_DIR}/boomerangTargets.cmake)
if(TARGET boomerang_kinetic)
  export(EXPORT boomerangKineticTargets NAMESPACE boomerang:: FILE ${PROJECT_BINARY_DIR}/boomerangKineticTargets.cmake)
endif()

# The pkg-config files name their prefix relative to themselves, so that `cmake --install --prefix` may choose it late.
set(boomerang_pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH boomerang_pc_to_prefix /${boomerang_pc_dir} /)
string(REGEX REPLACE "/$" "" boomerang_pc_to_prefix "${boomerang_pc_to_prefix}")
# Of each: what it is, what else pkg-config is to name, and libraries that bring no such file.
set(boomerang_pc_core "Separation-sensitive kinetic data structures for convex polygons" "" -lm)
set(boomerang_pc_kinetic "Rigid motions and event times for Boomerang (links GSL, GPL-3)" "boomerang-core gsl" -pthread)
set(boomerang_pc_box2d "Boomerang as the polygon narrow phase of Box2D" box2d "")
set(boomerang_pc_recorder "Contact events of Box2D, to be read after the step" box2d "")
set(boomerang_pc_repair "Outlines repaired and merged for Boomerang" boomerang-core "-lpolyclipping -lstdc++")
foreach(component IN LISTS boomerang_components)
  list(GET boomerang_pc_${component} 0 boomerang_pc_description)
  list(GET boomerang_pc_${component} 1 boomerang_pc_requires)
  list(GET boomerang_pc_${component} 2 boomerang_pc_libraries)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/boomerang.pc.in ${PROJECT_BINARY_DIR}/boomerang-${component}.pc @ONLY)
  set(development development)
  if(component STREQUAL "kinetic")
    set(development development_kinetic)
  endif()
  install(FILES ${PROJECT_BINARY_DIR}/boomerang-${component}.pc DESTINATION ${boomerang_pc_dir} COMPONENT ${development})
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(installable)
  foreach(target boomerang_core boomerang_core_shared boomerang_kinetic boomerang_kinetic_shared boomerang_box2d_glue boomerang_box2d boomerang_recorder boomerang_repair boomerang
      ${boomerang_programs} boomerang-count)
    if(TARGET ${target})
      add_dependencies(installable ${target})
    endif()
  endforeach()
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
      -P ${CMAKE_CURRENT_LIST_DIR}/BoomerangUninstall.cmake
    COMMENT "Taking away what the last installation put there" VERBATIM)
  # `cpack -G DEB` in the build tree makes one package of all of it.
  set(CPACK_PACKAGE_CONTACT "The Boomerang authors <root@localhost>")
  set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
  set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
  set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
  set(CPACK_STRIP_FILES ON)
  include(CPack)
endif()
