# firmware/eyebridge-mps2.elf in the build folder: the board's own C files, and those in target/, for a Cortex-M3. Only
# where there is a compiler for it; nothing else of the build needs it.
find_program(EYEBRIDGE_ARM_GCC arm-none-eabi-gcc)  # gcc-arm-none-eabi
mark_as_advanced(EYEBRIDGE_ARM_GCC)
set(specs "")
if(EYEBRIDGE_ARM_GCC)
  # A file that the compiler does not find it names without a folder.
  execute_process(COMMAND "${EYEBRIDGE_ARM_GCC}" -mcpu=cortex-m3 -mthumb -print-file-name=nano.specs
                  OUTPUT_VARIABLE specs OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT specs MATCHES "/")
  return()
endif()

set(target "${CMAKE_CURRENT_SOURCE_DIR}/target")
get_target_property(board_folder eyebridge_firmware_board SOURCE_DIR)
get_target_property(board_sources eyebridge_firmware_board SOURCES)
list(TRANSFORM board_sources PREPEND "${board_folder}/")
get_target_property(opcodes eyebridge::opcodes INTERFACE_INCLUDE_DIRECTORIES)
set(sources ${board_sources} "${target}/board_app.c" "${target}/cortex_m3.c" "${target}/main.c"
            "${target}/plant_link.c" "${target}/startup.c" "${target}/uart.c")
set(flags -mcpu=cortex-m3 -mthumb -std=c99 -O2 -g -ffp-contract=off -ffunction-sections -fdata-sections
          ${EYEBRIDGE_FIRMWARE_WARNINGS} "-I${board_folder}/include" "-I${target}"
          # It is installed: its debugging information names files from the root of the source on.
          "-ffile-prefix-map=${CMAKE_BINARY_DIR}=build" "-ffile-prefix-map=${CMAKE_SOURCE_DIR}=.")
foreach(folder IN LISTS opcodes)
  list(APPEND flags "-I${folder}")
endforeach()

set(objects "")
foreach(source IN LISTS sources)
  cmake_path(GET source STEM name)
  set(object "${CMAKE_CURRENT_BINARY_DIR}/target/${name}.o")
  add_custom_command(
    OUTPUT "${object}"
    COMMAND "${EYEBRIDGE_ARM_GCC}" ${flags} -MD -MF "${object}.d" -c "${source}" -o "${object}"
    DEPENDS "${source}"
    DEPFILE "${object}.d"
    COMMENT "Building ${name}.o for the Cortex-M3"
    VERBATIM)
  list(APPEND objects "${object}")
endforeach()
file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/target" "${CMAKE_BINARY_DIR}/firmware")

set(elf "${CMAKE_BINARY_DIR}/firmware/eyebridge-mps2.elf")
add_custom_command(
  OUTPUT "${elf}"
  COMMAND "${EYEBRIDGE_ARM_GCC}" -mcpu=cortex-m3 -mthumb --specs=nano.specs -nostartfiles -Wl,--gc-sections
          -Wl,--fatal-warnings -T "${target}/mps2.ld" ${objects} -o "${elf}"
  DEPENDS ${objects} "${target}/mps2.ld"
  COMMENT "Linking eyebridge-mps2.elf"
  VERBATIM)
add_custom_target(eyebridge_mps2_elf ALL DEPENDS "${elf}")
install(FILES "${elf}" DESTINATION share/eyebridge/firmware COMPONENT firmware)
add_dependencies(installable eyebridge_mps2_elf)
