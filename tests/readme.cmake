# Runs what the README shows: the commands of its `sh` block and its C++ program, with the program and
# the library of this build. Every file that the README links to must exist.
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
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE message)
if(failed)
  message(SEND_ERROR "the commands of README.md: status ${failed}\n${message}")
endif()
file(STRINGS ${folder}/events.csv events REGEX ",stick,")
list(LENGTH events sticks)
if(sticks LESS 2)
  message(SEND_ERROR "the run of README.md has ${sticks} sticks")
endif()
foreach(picture run figure3 states portrait section branches basins ball)
  if(NOT EXISTS ${folder}/${picture}.png)
    message(SEND_ERROR "the commands of README.md drew no ${picture}.png")
  endif()
endforeach()

text_of_block(cpp program)
file(WRITE ${folder}/program.cpp "${program}")
separate_arguments(flags)
execute_process(COMMAND ${compiler} -std=c++20 ${flags} -I${source}/lib/include program.cpp
                        ${build}/lib/libvibro_impact_simulation.a -o program
                WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "the program of README.md does not compile")
endif()
execute_process(COMMAND ./program WORKING_DIRECTORY ${folder} RESULT_VARIABLE failed
                OUTPUT_VARIABLE output)
if(failed OR NOT output MATCHES "mass 1 stick" OR NOT output MATCHES "[1-9][0-9]* impacts")
  message(SEND_ERROR "the program of README.md: status ${failed}\n${output}")
endif()
