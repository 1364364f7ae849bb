# SPDX-License-Identifier: MIT
# Read by cpack before it makes packages: adds to each package's dependencies those that its programs and libraries have on Debian's.
#   CPACK_BOOMERANG_WORK                a directory with NAME.binaries, the list of files of the component NAME
#   CPACK_BOOMERANG_LIBRARY_DIRECTORY   the build tree's own libraries, whose packages are named already
if(NOT CPACK_PACKAGE_CONTACT MATCHES "^[^<>]+ <[^<>@ ]+@[^<>@ ]+>$")
  message(FATAL_ERROR "A Debian package names who made it: configure the build tree with "
    "-DBOOMERANG_PACKAGE_MAINTAINER='Jane Doe <jane@example.org>', build, and call cpack again")
endif()
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(NOT DPKG_SHLIBDEPS)
  message(FATAL_ERROR "Debian packages need dpkg-shlibdeps, of Debian's package dpkg-dev")
endif()
# It wants to be called where a source package lies.
file(WRITE ${CPACK_BOOMERANG_WORK}/debian/control "Source: boomerang\n\nPackage: boomerang\nArchitecture: any\n")
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  file(READ ${CPACK_BOOMERANG_WORK}/${component}.binaries binaries)
  if(NOT binaries)
    continue()
  endif()
  execute_process(COMMAND ${DPKG_SHLIBDEPS} -O -l${CPACK_BOOMERANG_LIBRARY_DIRECTORY} --ignore-missing-info ${binaries}
    WORKING_DIRECTORY ${CPACK_BOOMERANG_WORK} OUTPUT_VARIABLE answer ERROR_VARIABLE said RESULT_VARIABLE status)
  if(NOT status EQUAL 0 OR NOT answer MATCHES "shlibs:Depends=([^\n]+)")
    message(FATAL_ERROR "dpkg-shlibdeps does not tell what ${component} needs: ${said}")
  endif()
  string(TOUPPER ${component} upper)
  set(depends "${CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS}")
  if(depends)
    string(APPEND depends ", ")
  endif()
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}${CMAKE_MATCH_1}")
endforeach()
