# SPDX-License-Identifier: MIT
# What `cmake --install` puts where: libraries, headers, a CMake package and pkg-config files, all relocatable.
# And a target `uninstall`, which takes away what the last installation from this build tree put there.
include(CMakePackageConfigHelpers)

set(boomerang_installed_targets boomerang_core)
set(boomerang_components core)
if(TARGET boomerang_kinetic)
  list(APPEND boomerang_installed_targets boomerang_kinetic)
  list(APPEND boomerang_components kinetic)
endif()
if(TARGET boomerang_box2d)
  list(APPEND boomerang_installed_targets boomerang_box2d_glue boomerang_box2d)
  list(APPEND boomerang_components box2d)
endif()

install(TARGETS ${boomerang_installed_targets} EXPORT boomerangTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

file(GLOB core_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/core/include/boomerang/*.h)
if(NOT TARGET boomerang_kinetic)
  list(FILTER core_headers EXCLUDE REGEX "/(kinetic|motion|time_of_contact|failure|simulation|families|analysis)\\.h$")
endif()
install(FILES ${core_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang)
if(TARGET boomerang_box2d)
  file(GLOB box2d_headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/plugin/include/boomerang/*.h
    ${PROJECT_SOURCE_DIR}/box2d_glue/include/boomerang/*.h)
  install(FILES ${box2d_headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/boomerang)
endif()
# The documentation as it lies in the sources, so that its links lead somewhere.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/core/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/core)
foreach(examples core/examples plugin/examples)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${examples}/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/${examples}
    FILES_MATCHING PATTERN "*.c" PATTERN "*.cpp")
endforeach()

if(BOOMERANG_INSTALL_TESTBED AND TARGET boomerang-testbed)
  # The workers lie beside the program, which looks for them there; what they load is found from wherever that is.
  file(RELATIVE_PATH boomerang_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set(boomerang_programs boomerang-testbed boomerang-scene)
  if(TARGET boomerang-scene-plugin)
    list(APPEND boomerang_programs boomerang-scene-plugin)
    set_target_properties(boomerang-scene-plugin PROPERTIES INSTALL_RPATH "$ORIGIN/${boomerang_bin_to_lib}")
  endif()
  install(TARGETS ${boomerang_programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(TARGETS boomerang-count LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/boomerang)
  if(TARGET boomerang-manual)
    set(boomerang_manual ${PROJECT_BINARY_DIR}/manual)
    install(FILES ${boomerang_manual}/boomerang-testbed.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
    install(FILES ${boomerang_manual}/boomerang-testbed
      DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
    install(FILES ${boomerang_manual}/_boomerang-testbed DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
    install(FILES ${boomerang_manual}/boomerang-testbed.fish
      DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  endif()
endif()

# The sources that boomerang_accelerate compiles with a project's Box2D.
set(boomerang_source_dir ${CMAKE_INSTALL_DATADIR}/boomerang/source)
foreach(folder core/include core/geometry core/hierarchy core/certificate core/pair core/kds core/budget core/exact32 core/convex32 core/outline
    box2d_glue plugin/hooks plugin/include plugin/reach/renamed)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${boomerang_source_dir}/${folder}
    FILES_MATCHING PATTERN "*.c" PATTERN "*.cpp" PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/plugin/start.h DESTINATION ${boomerang_source_dir}/plugin)
install(FILES ${PROJECT_SOURCE_DIR}/plugin/reach/stock.h DESTINATION ${boomerang_source_dir}/plugin/reach)

set(boomerang_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/boomerang)
install(EXPORT boomerangTargets NAMESPACE boomerang:: DESTINATION ${boomerang_package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/boomerangConfig.cmake.in
  ${PROJECT_BINARY_DIR}/boomerangConfig.cmake INSTALL_DESTINATION ${boomerang_package_dir}
  PATH_VARS boomerang_source_dir)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/boomerangConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/boomerangConfig.cmake ${PROJECT_BINARY_DIR}/boomerangConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/BoomerangAccelerate.cmake ${CMAKE_CURRENT_LIST_DIR}/BoomerangLinks.cmake
  DESTINATION ${boomerang_package_dir})

# The pkg-config files name their prefix relative to themselves, so that `cmake --install --prefix` may choose it late.
set(boomerang_pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH boomerang_pc_to_prefix /${boomerang_pc_dir} /)
string(REGEX REPLACE "/$" "" boomerang_pc_to_prefix "${boomerang_pc_to_prefix}")
foreach(component IN LISTS boomerang_components)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/boomerang-${component}.pc.in
    ${PROJECT_BINARY_DIR}/boomerang-${component}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/boomerang-${component}.pc DESTINATION ${boomerang_pc_dir})
endforeach()

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
      -P ${CMAKE_CURRENT_LIST_DIR}/BoomerangUninstall.cmake
    COMMENT "Taking away what the last installation put there" VERBATIM)
endif()
