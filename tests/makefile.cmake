# The targets of the Makefile and their requests, in a copy of it with a cmake and packages that do nothing:
# `make figures` fails when a key number is wrong, and `make reference` writes every computed table.
# cmake -D source=... -D build=... -D folder=... -P makefile.cmake
cmake_minimum_required(VERSION 3.21)
find_program(make make REQUIRED)
file(REMOVE_RECURSE ${folder})
file(COPY ${source}/Makefile DESTINATION ${folder})

function(script path text)  # a script of the shell
  file(WRITE ${folder}/${path} "#!/bin/sh\n${text}\n")
  file(CHMOD ${folder}/${path} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
endfunction()
function(make_target target result)
  # The make that runs the tests hands its own variables on, `preset` among them.
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=MAKEFLAGS
                          "PATH=${folder}/nothing:$ENV{PATH}" ${make} -C ${folder} ${target}
                  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  set(${result} ${status} PARENT_SCOPE)
  set(said "${said}" PARENT_SCOPE)
endfunction()
script(nothing/cmake "exit 0")
script(.ci/packages "exit 0")

file(COPY ${source}/reference/tables DESTINATION ${folder})
script(build/bin/check "exec '${build}/bin/check' --reference '${folder}/tables'")
file(READ ${folder}/tables/checked_numbers.csv right)
string(REPLACE ",0.256006329" ",0.256006328" wrong "${right}")  # a frequency of Figure 4
file(WRITE ${folder}/tables/checked_numbers.csv "${wrong}")
make_target(figures status)
if(status EQUAL 0 OR wrong STREQUAL right OR NOT said MATCHES "missed: [a-z].*FAILED: ")
  message(SEND_ERROR "make figures with a wrong key number: status ${status}\n${said}")
endif()
script(build/bin/check "echo all passed")
make_target(figures status)
if(NOT status EQUAL 0 OR NOT said MATCHES "all passed")
  message(SEND_ERROR "make figures: status ${status}\n${said}")
endif()

# The axes, the claims, the quotations and the list of extreme cases are not computed.
file(GLOB tables RELATIVE ${folder}/tables ${folder}/tables/*.csv)
list(REMOVE_ITEM tables panels.csv claims.csv quotations.csv extreme_cases.csv)
file(REMOVE_RECURSE ${folder}/tables)
file(MAKE_DIRECTORY ${folder}/reference/tables)
script(build/bin/reference-generate "echo \"$1\" >\"$2\"")
make_target(reference status)
file(GLOB written RELATIVE ${folder}/reference/tables ${folder}/reference/tables/*.csv)
if(NOT status EQUAL 0 OR NOT written STREQUAL tables)
  message(SEND_ERROR "make reference: status ${status}, writes\n${written}\ninstead of\n${tables}\n${said}")
endif()
