# Debian's `reuse lint` on a copy of the files under version control. It asks for LICENSES/, a folder
# that the project does not have (LICENSE stands alone), and before its version 4 it does not read
# REUSE.toml: the copy gets the first, and the second as .reuse/dep5.
# cmake -D source=... -D copy=... -P reuse_lint.cmake
execute_process(COMMAND git -C ${source} ls-files OUTPUT_VARIABLE files RESULT_VARIABLE failed
                ERROR_QUIET)
if(failed)
  message("no git repository: nothing to look at")
  return()
endif()
string(REPLACE "\n" ";" files "${files}")
file(REMOVE_RECURSE ${copy})
foreach(file ${files})
  if(EXISTS ${source}/${file})
    get_filename_component(folder ${copy}/${file} DIRECTORY)
    file(COPY ${source}/${file} DESTINATION ${folder})
  endif()
endforeach()
file(STRINGS ${source}/REUSE.toml lines REGEX " = \"")
foreach(line ${lines})
  if(line MATCHES "^([A-Za-z-]+) = \"(.*)\"$")
    set(value_of_${CMAKE_MATCH_1} "${CMAKE_MATCH_2}")
  endif()
endforeach()
configure_file(${source}/LICENSE ${copy}/LICENSES/${value_of_SPDX-License-Identifier}.txt COPYONLY)
execute_process(COMMAND reuse --version OUTPUT_VARIABLE version)
string(REGEX MATCH "[0-9]+" version "${version}")
if(version LESS 4)
  string(REPLACE "**" "*" files "${value_of_path}")
  file(REMOVE ${copy}/REUSE.toml)
  file(WRITE ${copy}/.reuse/dep5
    "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\n"
    "Files: ${files}\nCopyright: ${value_of_SPDX-FileCopyrightText}\n"
    "License: ${value_of_SPDX-License-Identifier}\n")
endif()
execute_process(COMMAND reuse --root ${copy} lint OUTPUT_VARIABLE report RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${report}")
endif()
