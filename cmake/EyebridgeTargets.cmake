# eyebridge_headers(tests EXECUTABLE|STATIC HEADERS … [LIBRARIES …]): headers that many targets with
# the same flags include, compiled once. That a source forgets to include one of them, tests/arrows/forgotten.py finds.
function(eyebridge_headers name kind)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES" ${ARGN})
  set(source "${CMAKE_BINARY_DIR}/headers/${name}.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "int main() {}\n")
  if(kind STREQUAL EXECUTABLE)
    add_executable(headers_${name} EXCLUDE_FROM_ALL "${source}")
  else()
    add_library(headers_${name} STATIC EXCLUDE_FROM_ALL "${source}")
  endif()
  target_link_libraries(headers_${name} PRIVATE ${arg_LIBRARIES} eyebridge_warnings)
  target_precompile_headers(headers_${name} PRIVATE ${arg_HEADERS})
  set_target_properties(headers_${name} PROPERTIES UNITY_BUILD OFF)
endfunction()
eyebridge_headers(libraries STATIC
  HEADERS <algorithm> <array> <cmath> <filesystem> <memory> <optional> <span> <string> <vector>
          <tl/expected.hpp>)

# eyebridge_library(base SOURCES … PUBLIC … PRIVATE …): the static library eyebridge_base, alias
# eyebridge::base, with its own include folder, so that a forbidden include does not compile.
function(eyebridge_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(eyebridge_${name} STATIC ${arg_SOURCES})
  add_library(eyebridge::${name} ALIAS eyebridge_${name})
  target_include_directories(eyebridge_${name} PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>"
                             PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/src")
  target_link_libraries(eyebridge_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  # Not linked: others who link an installed library of ours have no such target.
  target_compile_options(eyebridge_${name} PRIVATE
                         $<TARGET_PROPERTY:eyebridge_warnings,INTERFACE_COMPILE_OPTIONS>)
  target_precompile_headers(eyebridge_${name} REUSE_FROM headers_libraries)
endfunction()

# eyebridge_hot(world): a library where time goes; all others are optimised for the compiler's time as well.
function(eyebridge_hot name)
  target_compile_options(eyebridge_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
endfunction()

# eyebridge_simd(eyebridge_world src/fan_walls.cpp …): the target uses Highway, which compiles these sources once per instruction
# set; the CPU's best one runs.
function(eyebridge_simd target)
  find_package(hwy REQUIRED)  # libhwy-dev
  # Its headers alone, see EYEBRIDGE_BEST: its assertions end in its library.
  target_compile_definitions(${target} PRIVATE HWY_IS_DEBUG_BUILD=0)
  target_include_directories(${target} SYSTEM PRIVATE $<TARGET_PROPERTY:hwy::hwy,INTERFACE_INCLUDE_DIRECTORIES>)
  # Arrays are padded for registers of 32 bytes: no target better than AVX2 (their bits lie below, in any version of
  # Highway). SSSE3 would help few old CPUs. EMU128, for all others, needs nothing of what g++ 12.2 gets wrong in it.
  target_compile_definitions(${target} PRIVATE HWY_BROKEN_EMU128=0
    "HWY_DISABLED_TARGETS=((HWY_AVX2-1)|HWY_SSSE3|HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    target_compile_definitions(${target} PRIVATE HWY_COMPILE_ONLY_STATIC)
  endif()
  if(ARGN)
    # After a precompiled header g++ 12 takes no several numbers at once in functions with a "#pragma GCC target".
    set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# The compiler's time counts more than that of tests; UBSan, for what they test, would nearly double it.
add_library(eyebridge_test_options INTERFACE)
target_compile_options(eyebridge_test_options INTERFACE $<$<CONFIG:Release>:-O1> -fno-sanitize=undefined)

# eyebridge_test(core_base SOURCES … LIBRARIES … [LABEL slow]): one GoogleTest program. In the
# dev preset every test in it becomes a ctest named core_base.Suite.Test@dev; elsewhere the program is
# one ctest, core_base@preset (EYEBRIDGE_TEST_PROGRAMS): a process with a sanitizer starts in a tenth of
# a second, in which it can run a dozen tests. LABEL is unit unless given: unit tests together stay under
# two minutes. Those with LABEL threads or realtime are all that the thread sanitizer runs; the fuzz preset
# runs only fuzzers.
# SHARDS n, for tests that mostly wait: a single ctest, named after the program, runs them in n
# processes at once. ALONE: no other test runs beside it.
# CASES a b …, for a test with parameters of these names: one ctest for each, name.a@preset, and one for the program's other tests.
function(eyebridge_test name)
  cmake_parse_arguments(arg "ALONE" "LABEL;SHARDS" "SOURCES;LIBRARIES;CASES" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  add_executable(test_${name} ${arg_SOURCES})
  target_link_libraries(test_${name} PRIVATE ${arg_LIBRARIES} GTest::gmock GTest::gtest_main
                        eyebridge_test_options eyebridge_warnings)
  target_precompile_headers(test_${name} REUSE_FROM headers_tests)
  target_compile_definitions(test_${name} PRIVATE
                             EYEBRIDGE_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                             EYEBRIDGE_SHARED_DIR="${CMAKE_SOURCE_DIR}/../shared")
  if(EYEBRIDGE_FUZZ OR (EYEBRIDGE_SANITIZE MATCHES "thread" AND NOT arg_LABEL MATCHES "^(threads|realtime)$"))
    return()
  endif()
  cmake_path(GET CMAKE_BINARY_DIR FILENAME preset)
  set(longest 600)  # seconds
  if(CMAKE_CROSSCOMPILING)
    set(longest 3600)  # on an emulated processor
  endif()
  if(arg_SHARDS)
    add_test(NAME ${name}@${preset}
             COMMAND "${CMAKE_SOURCE_DIR}/cmake/run-shards.sh" $<TARGET_FILE:test_${name}> ${arg_SHARDS})
    # Alone on a computer of two cores: others would only make them late.
    set_tests_properties(${name}@${preset} PROPERTIES LABELS "${arg_LABEL}" TIMEOUT 300 PROCESSORS 2)
  elseif(arg_CASES AND EYEBRIDGE_TEST_PROGRAMS)
    add_test(NAME ${name}@${preset} COMMAND test_${name} --gtest_filter=-*/*)
    set_tests_properties(${name}@${preset} PROPERTIES LABELS "${arg_LABEL}" TIMEOUT ${longest})
    foreach(case IN LISTS arg_CASES)
      add_test(NAME ${name}.${case}@${preset}
               COMMAND test_${name} --gtest_filter=*/${case})
      set_tests_properties(${name}.${case}@${preset} PROPERTIES LABELS "${arg_LABEL}" TIMEOUT ${longest})
    endforeach()
  elseif(EYEBRIDGE_TEST_PROGRAMS)
    # Not briefly: of a program that is ended by its limit, the last line names the test.
    add_test(NAME ${name}@${preset} COMMAND test_${name})
    set_tests_properties(${name}@${preset} PROPERTIES LABELS "${arg_LABEL}" TIMEOUT ${longest} RUN_SERIAL ${arg_ALONE})
  else()
    gtest_discover_tests(test_${name} TEST_PREFIX ${name}. TEST_SUFFIX @${preset} NO_PRETTY_VALUES
                         DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${arg_LABEL}" TIMEOUT 300 RUN_SERIAL ${arg_ALONE})
  endif()
  if(arg_LABEL MATCHES "^(threads|realtime)$")
    add_dependencies(threaded_tests test_${name})
  endif()
  add_dependencies(every_test test_${name})
endfunction()

# eyebridge_sanitizer_preload(variable): what LD_PRELOAD needs for a Python that loads what a sanitizer is in. Python
# is built without: the run-time library has to be there before ours, and libstdc++ with it, so that it finds what throws.
function(eyebridge_sanitizer_preload variable)
  set(libraries "")
  foreach(library libasan.so libubsan.so libstdc++.so)
    execute_process(COMMAND "${CMAKE_CXX_COMPILER}" -print-file-name=${library}
                    OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
    list(APPEND libraries "${path}")
  endforeach()
  list(JOIN libraries ":" joined)
  set(${variable} "${joined}" PARENT_SCOPE)
endfunction()

add_custom_target(every_test)
add_custom_target(threaded_tests)  # What `./test all` builds with the thread sanitizer.
add_custom_target(fuzzers)

# eyebridge_fuzzer(world HEADER entry.hpp LIBRARIES …): fuzz_world, which hands its inputs to the
# function world() of the header; built with EYEBRIDGE_FUZZ, and a ctest fuzz.world that feeds it for a bounded time from corpus/world; both in tests/fuzz.
function(eyebridge_fuzzer name)
  cmake_parse_arguments(arg "" "HEADER" "LIBRARIES" ${ARGN})
  if(NOT EYEBRIDGE_FUZZ)
    return()
  endif()
  add_executable(fuzz_${name} target.cpp)
  target_compile_definitions(fuzz_${name} PRIVATE EYEBRIDGE_FUZZ_HEADER="${arg_HEADER}"
                             EYEBRIDGE_FUZZ_ENTRY=${name})
  target_link_libraries(fuzz_${name} PRIVATE ${arg_LIBRARIES} eyebridge_warnings)
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  add_dependencies(fuzzers fuzz_${name})
  add_test(NAME fuzz.${name}
           COMMAND "${CMAKE_SOURCE_DIR}/cmake/run-fuzzer.sh" $<TARGET_FILE:fuzz_${name}>
                   "${CMAKE_SOURCE_DIR}/tests/fuzz/corpus/${name}"
                   "${CMAKE_CURRENT_BINARY_DIR}/scratch/${name}")
  set_tests_properties(fuzz.${name} PROPERTIES LABELS fuzz TIMEOUT 600 COST 500)
endfunction()

# Makes `target` a robot program as eyebridge-cc links them, so that several robots can run it: position-independent, with a
# main() that others see. `launcher` is eyebridge_robots or eyebridge_robots_classic.
function(eyebridge_robot_program target launcher)
  set_target_properties(${target} PROPERTIES ENABLE_EXPORTS ON
    C_VISIBILITY_PRESET default CXX_VISIBILITY_PRESET default)
  target_compile_options(${target} PRIVATE -fPIE)
  target_link_options(${target} PRIVATE -pie "LINKER:--version-script=${CMAKE_SOURCE_DIR}/apps/wrappers/program.map")
  add_dependencies(${target} ${launcher})
endfunction()
