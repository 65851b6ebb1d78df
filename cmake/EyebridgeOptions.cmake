# What can be switched, and the flags that every target of ours gets.

option(EYEBRIDGE_WITH_TESTS "Build the tests" ON)
option(EYEBRIDGE_WITH_BENCH "Build the benchmarks" OFF)
option(EYEBRIDGE_WITH_PYTHON "Build and install the Python packages" ON)
option(EYEBRIDGE_WITH_OPENCV "Build videos as cameras, fiducials and calibration, where OpenCV is installed" ON)
option(EYEBRIDGE_WITH_MPI "Build sweeps over several computers, where MPI is installed" ON)
option(EYEBRIDGE_WITH_CORTEX "Build the firmware for an emulated Cortex-M3, where its compiler is installed" ON)
option(EYEBRIDGE_WERROR "Warnings are errors, as the presets have it" OFF)
option(EYEBRIDGE_WITH_OSMESA "Render cameras with OSMesa, where Mesa has it; otherwise only with EGL" ON)
option(EYEBRIDGE_TEST_PROGRAMS "Run all tests of a program in one process" OFF)
option(EYEBRIDGE_FUZZ "Build the fuzz targets (clang only)" OFF)
set(EYEBRIDGE_SANITIZE "" CACHE STRING "Comma-separated sanitizers: address,undefined or thread")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# Programs link against libeyebridge: only the C API may be visible, user programs own all other names.
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

find_program(EYEBRIDGE_CCACHE ccache)
if(EYEBRIDGE_CCACHE)
  # Without these it keeps nothing that is compiled with a precompiled header.
  set(ccache_settings CCACHE_SLOPPINESS=pch_defines,time_macros)
  # A clone in another folder, a wheel too, finds what this one compiled. Not with debug information: it names the folder.
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    list(APPEND ccache_settings "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1)
  endif()
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env ${ccache_settings} "${EYEBRIDGE_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${CMAKE_CXX_COMPILER_LAUNCHER}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
  endif()
endif()

# The same bits in debug and release: no fused multiply-add behind our back.
add_compile_options(-ffp-contract=off)

if(EYEBRIDGE_SANITIZE)
  add_compile_options(-fsanitize=${EYEBRIDGE_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND EYEBRIDGE_SANITIZE MATCHES undefined)
    # For each access g++ writes a record with pointers (61 MB in libeyebridge.so), and the dynamic linker corrects all of
    # them when a process starts. ASan ends an access through null, too; the fuzzers, which clang builds, check both.
    add_compile_options(-fno-sanitize=null,alignment)
  endif()
  add_link_options(-fsanitize=${EYEBRIDGE_SANITIZE})
  # Half the time of GNU ld, for dozens of programs.
  find_program(EYEBRIDGE_LLD ld.lld)
  if(EYEBRIDGE_LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

add_library(eyebridge_warnings INTERFACE)
target_compile_options(eyebridge_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       $<$<BOOL:${EYEBRIDGE_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 at -O2 and above reports std::string members of temporaries as uninitialised (its bug
  # 105562) and operator+ of strings as overlapping or endless copies (its bug 105651). The dev build, without
  # optimisation, keeps these warnings in what they are good at; ASan finds the rest.
  target_compile_options(eyebridge_warnings INTERFACE -Wno-maybe-uninitialized
    $<$<NOT:$<CONFIG:Debug>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
  if(CMAKE_UNITY_BUILD)
    # What a source keeps to itself looks like a header's when sources are compiled together.
    target_compile_options(eyebridge_warnings INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
  endif()
endif()
