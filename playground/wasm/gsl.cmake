# SPDX-License-Identifier: MIT
# GSL::gsl out of GSL_SOURCE, Debian's source of GSL: the few files that boomerang::kinetic calls, and no configure. What is
# missing from the list, the linker names.
if(NOT EXISTS ${GSL_SOURCE}/poly/zsolve.c)
  message(FATAL_ERROR "GSL_SOURCE is '${GSL_SOURCE}', where no source of GSL is: tools/debian_source.sh fetches it")
endif()
set(gsl_folder ${PROJECT_BINARY_DIR}/gsl)
# GSL's files say <gsl/name.h>, and lie in the folders of their trades.
file(GLOB gsl_headers ${GSL_SOURCE}/gsl_*.h ${GSL_SOURCE}/*/gsl_*.h)
file(COPY ${gsl_headers} DESTINATION ${gsl_folder}/gsl)
# All that `configure` would have found out and these files ask for.
file(WRITE ${gsl_folder}/config.h.new "#define HAVE_IEEE_COMPARISONS 1\n#define HAVE_IEEE_DENORMALS 1\n#define RETURN_IF_NULL(x) if (!x) { return ; }\n")
configure_file(${gsl_folder}/config.h.new ${gsl_folder}/config.h COPYONLY)
add_library(gsl STATIC
  ${GSL_SOURCE}/err/error.c ${GSL_SOURCE}/err/stream.c ${GSL_SOURCE}/err/strerror.c
  ${GSL_SOURCE}/roots/brent.c ${GSL_SOURCE}/roots/fsolver.c ${GSL_SOURCE}/roots/newton.c ${GSL_SOURCE}/roots/fdfsolver.c
  ${GSL_SOURCE}/rng/rng.c ${GSL_SOURCE}/rng/inline.c ${GSL_SOURCE}/rng/mt.c
  ${GSL_SOURCE}/randist/flat.c ${GSL_SOURCE}/randist/gauss.c
  ${GSL_SOURCE}/sys/coerce.c ${GSL_SOURCE}/sys/fdiv.c ${GSL_SOURCE}/sys/infnan.c)
target_include_directories(gsl SYSTEM PUBLIC ${gsl_folder} PRIVATE ${GSL_SOURCE})
target_compile_options(gsl PRIVATE -w -ffp-contract=off)
add_library(GSL::gsl ALIAS gsl)
