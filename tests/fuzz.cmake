# The fuzz target alone, in a build folder of its own: `make fuzz`.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT TARGET runner_options)
  message(FATAL_ERROR "VIBRO_IMPACT_FUZZ needs CLI11 and clang (-DCMAKE_CXX_COMPILER=clang++), "
                      "not ${CMAKE_CXX_COMPILER_ID}")
endif()
foreach(library vibro_impact runner_options)
  target_compile_options(${library} PRIVATE -g -O1 -fsanitize=fuzzer-no-link,address,undefined
                                            -fno-sanitize-recover=all)
endforeach()
add_executable(fuzz_options tests/fuzz_options.cpp)
target_include_directories(fuzz_options PRIVATE figures)
target_compile_options(fuzz_options PRIVATE -g -O1 -fsanitize=fuzzer,address,undefined
                                            -fno-sanitize-recover=all)
target_link_options(fuzz_options PRIVATE -fsanitize=fuzzer,address,undefined)
target_link_libraries(fuzz_options PRIVATE runner_options vibro_impact_options fmt::fmt)
