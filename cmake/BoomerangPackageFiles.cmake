# SPDX-License-Identifier: MIT
# Called by cpack when the files of all packages lie ready: adds what Debian wants beside what is installed, a changelog for each
# package, and a manual page for each program, compressed.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  set(date_of "@$ENV{SOURCE_DATE_EPOCH}")
else()
  set(date_of now)
endif()
execute_process(COMMAND date -R --utc -d ${date_of} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(GLOB folders "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*")
foreach(folder IN LISTS folders)
  if(EXISTS "${folder}/copyright")
    file(WRITE "${folder}/changelog" "boomerang (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
      "  * Made from the sources of version ${CPACK_PACKAGE_VERSION}.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  endif()
endforeach()
# help2man makes the testbed's page of its --help; the page speaks of its workers, too.
find_program(help2man help2man)
file(GLOB testbeds "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/bin/boomerang-testbed")
foreach(testbed IN LISTS testbeds)
  if(NOT help2man)
    message(FATAL_ERROR "The package of the testbed needs help2man, for its manual page (Debian: help2man)")
  endif()
  cmake_path(GET testbed PARENT_PATH folder)
  file(MAKE_DIRECTORY "${folder}/../share/man/man1")
  execute_process(COMMAND ${help2man} --no-info "--name=compare Box2D with and without the Boomerang plugin"
    --output=${folder}/../share/man/man1/boomerang-testbed.1 ${testbed} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB workers "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/bin/boomerang-scene*")
foreach(worker IN LISTS workers)
  cmake_path(GET worker FILENAME name)
  string(REGEX REPLACE "/bin/[^/]*$" "" folder "${worker}")
  file(WRITE "${folder}/share/man/man1/${name}.1" ".so man1/boomerang-testbed.1\n")
endforeach()
file(GLOB files "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/man/man*/*.[1-9]"
  "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/usr/share/doc/*/changelog")
execute_process(COMMAND gzip -9nf ${files} COMMAND_ERROR_IS_FATAL ANY)
