# SPDX-License-Identifier: MIT
# Writes the files of the page into a C++ header:
#
#   cmake -DOUTPUT=page_files.h -DPAGE=directory -P embed.cmake
#
# The scripts are joined in the order below: plain scripts that share one scope, as the page runs them.
set(scripts decode model view strip timeline pairs figures pick controls link main)
set(delimiter "page") # )page" occurs in none of them
set(literal_limit 60000) # characters: compilers promise 65536

function(add_literal name out)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${PAGE}/${file} content)
    string(FIND "${content}" ")${delimiter}\"" clash)
    string(LENGTH "${content}" length)
    if(NOT clash EQUAL -1 OR length GREATER literal_limit)
      message(FATAL_ERROR "${file} cannot be embedded: it is too long, or has )${delimiter}\" in it")
    endif()
    # Neighbouring literals are one: their parts must each be short enough for a compiler.
    string(APPEND text "\n    R\"${delimiter}(${content})${delimiter}\"")
  endforeach()
  set(${out} "${${out}}inline constexpr std::string_view ${name} =${text};\n\n" PARENT_SCOPE)
endfunction()

list(TRANSFORM scripts APPEND .js)
set(code "")
add_literal(kPageHtml code page.html)
add_literal(kPageStyle code page.css)
add_literal(kPageScript code ${scripts})
file(WRITE ${OUTPUT} "// Made by testbed_scenes/replay/embed.cmake: edit the files in page/ instead.
#pragma once
#include <string_view>

namespace testbed::replay {

${code}} // namespace testbed::replay
")
