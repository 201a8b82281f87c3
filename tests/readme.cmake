# Runs what the README shows: the commands of its `sh` block and its C++ program, with the program and
# the libraries of this build, and the programs at the head of public headers. Every file that the
# README links to, and every test or source that a document names, must exist.
# cmake -D source=... -D build=... -D compiler=... -D flags=... -D folder=... -P readme.cmake
cmake_minimum_required(VERSION 3.21)
file(READ ${source}/README.md text)
file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})

# Semicolons, brackets and backslashes mean something in lists of CMake: a copy without them.
string(REPLACE "](" "link:(" plain "${text}")
string(REGEX REPLACE "[][;\\]" "." plain "${plain}")
string(REGEX MATCHALL "link:\\([a-zA-Z_][a-zA-Z0-9_/.]*\\)" links "${plain}")
foreach(link IN LISTS links)
  string(REGEX REPLACE "^link:.(.*).$" "\\1" file "${link}")
  if(NOT EXISTS ${source}/${file})
    message(SEND_ERROR "README.md names ${file}, which is not there")
  endif()
endforeach()

# Every test and every source that a document names is there.
file(GLOB_RECURSE sources ${source}/lib/*.?pp ${source}/figures/*.?pp ${source}/reference/*.?pp ${source}/tests/*.?pp)
list(TRANSFORM sources REPLACE ".*/" "")
foreach(document README.md CONTRIBUTING.md lib/README.md tests/README.md figures/README.md
                 figures/error_vs_runtime/README.md figures/beyond/README.md reference/README.md)
  file(READ ${source}/${document} names)
  string(REGEX MATCHALL "`[a-z0-9_/]+(_test|\\.[ch]pp)`" names "${names}")
  foreach(name IN LISTS names)
    string(REGEX REPLACE ".*/|`" "" name ${name})
    if(NOT name IN_LIST sources AND NOT "${name}.cpp" IN_LIST sources)
      message(SEND_ERROR "${document} names ${name}, which is not there")
    endif()
  endforeach()
endforeach()

function(text_of_block language variable)  # the text of the first block in that language
  string(FIND "${text}" "```${language}\n" begin)
  if(begin EQUAL -1)
    message(FATAL_ERROR "README.md has no block in ${language}")
  endif()
  string(SUBSTRING "${text}" ${begin} -1 rest)
  string(LENGTH "```${language}\n" skip)
  string(SUBSTRING "${rest}" ${skip} -1 rest)
  string(FIND "${rest}" "```" end)
  string(SUBSTRING "${rest}" 0 ${end} rest)
  set(${variable} "${rest}" PARENT_SCOPE)
endfunction()

text_of_block(sh commands)
file(WRITE ${folder}/commands.sh "${commands}")
execute_process(COMMAND sh -ec "PATH=${build}/bin:$PATH . ./commands.sh" WORKING_DIRECTORY ${folder}
                RESULT_VARIABLE failed OUTPUT_VARIABLE printed ERROR_VARIABLE message)
if(failed)
  message(SEND_ERROR "the commands of README.md: status ${failed}\n${message}")
endif()
# The branch has one fold between its ends at grazes.
if(NOT printed MATCHES "\ngraze at omega = [0-9.]*\nfold at omega = 0.578747472[0-9]*\n(flip at omega = [0-9.]*\n)*graze at omega")
  message(SEND_ERROR "the branch of README.md: ${printed}")
endif()
file(STRINGS ${folder}/events.csv events REGEX ",stick,")
list(LENGTH events sticks)
if(sticks LESS 2)
  message(SEND_ERROR "the run of README.md has ${sticks} sticks")
endif()
# The scene of the README is that of Figure 2.
file(STRINGS ${source}/reference/tables/checked_numbers.csv row REGEX "^figure2b_chatter_end,")
string(REGEX MATCH "[0-9]+\\.[0-9][0-9][0-9][0-9][0-9][0-9]" stick "${row}")
if(NOT events MATCHES "${stick}")
  message(SEND_ERROR "the run of README.md has no stick at ${stick}: it is not that of Figure 2")
endif()
foreach(picture run figure3 portrait branch)
  if(NOT EXISTS ${folder}/${picture}.png)
    message(SEND_ERROR "the commands of README.md drew no ${picture}.png")
  endif()
endforeach()

separate_arguments(flags)
function(output_of name program variable)  # what this C++ program writes
  file(WRITE ${folder}/${name}.cpp "${program}")
  execute_process(COMMAND ${compiler} -std=c++20 ${flags} -I${source}/lib/include ${name}.cpp
                          ${build}/lib/libvibro_impact_analysis.a
                          ${build}/lib/libvibro_impact_simulation.a -o ${name}
                  WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "the program of ${name} does not compile")
  endif()
  execute_process(COMMAND ./${name} WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed
                  OUTPUT_VARIABLE output)
  if(failed)
    message(SEND_ERROR "the program of ${name}: status ${failed}")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

text_of_block(cpp program)
output_of(README.md "${program}" output)
if(NOT output MATCHES "${stick}[0-9]* mass 2 stick")
  message(SEND_ERROR "the program of README.md: ${output}")
endif()

# The lines of a header above `#pragma once` that are indented by five are a program.
set(headers simulate analysis/periodic_orbit analysis/sweep)
set(outputs "[1-9][0-9]* impacts" "\nstable" "1\n1\n")
foreach(header expected IN ZIP_LISTS headers outputs)
  file(READ ${source}/lib/include/vibro_impact/${header}.hpp program)
  string(REGEX REPLACE "\n#pragma once.*" "\n" program "${program}")
  string(REGEX REPLACE "(^|\n)///( [^ ][^\n]*)?" "\\1" program "${program}")
  string(REPLACE "/" "_" name ${header})
  output_of(${name} "${program}" output)
  if(NOT output MATCHES "${expected}")
    message(SEND_ERROR "the program of ${header}.hpp: ${output}")
  endif()
endforeach()
