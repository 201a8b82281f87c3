# The fuzz target alone, in a build folder of its own: `make fuzz`.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT TARGET program)
  message(FATAL_ERROR "VIBRO_IMPACT_FUZZ needs CLI11 and clang (-DCMAKE_CXX_COMPILER=clang++), "
                      "not ${CMAKE_CXX_COMPILER_ID}")
endif()
foreach(library vibro_impact_simulation vibro_impact_analysis program)
  target_compile_options(${library} PRIVATE -g -O1 -fsanitize=fuzzer-no-link,address,undefined
                                            -fno-sanitize-recover=all)
endforeach()
add_executable(fuzz_options ${PROJECT_SOURCE_DIR}/tests/program/fuzz_options.cpp)
target_include_directories(fuzz_options PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_options(fuzz_options PRIVATE -g -O1 -fsanitize=fuzzer,address,undefined
                                            -fno-sanitize-recover=all)
target_link_options(fuzz_options PRIVATE -fsanitize=fuzzer,address,undefined)
target_link_libraries(fuzz_options PRIVATE program vibro_impact_options fmt::fmt)
