# What is installed, by component: runtime, development, python, gui, documentation, firmware; and how others find EyeBridge:
# eyebridge-cc and eyebridge-c++ (gccsim, g++sim), eyebridge.pc, find_package(EyeBridge). The same files serve the build
# folder and an installation, which can be moved: all their paths are relative to the file itself.
include(CMakePackageConfigHelpers)

# What a program must be built with to load a library of ours that has a sanitizer in it.
set(sanitizer_flags "")
if(EYEBRIDGE_SANITIZE AND NOT EYEBRIDGE_FUZZ)
  set(sanitizer_flags "-fsanitize=${EYEBRIDGE_SANITIZE}")
endif()

set(libdir "${CMAKE_INSTALL_LIBDIR}")
set(includedir "${CMAKE_INSTALL_INCLUDEDIR}")
set(bin "${CMAKE_BINARY_DIR}/bin")

# The compilers, also by the names that people's Makefiles call them: those of EyeSim, and of the robots' own computers.
foreach(wrapper "eyebridge-cc:gcc:gccsim:gccarm" "eyebridge-c++:g++:g++sim:g++arm")
  string(REPLACE ":" ";" aliases "${wrapper}")
  list(POP_FRONT aliases name compiler)
  configure_file("${CMAKE_SOURCE_DIR}/apps/wrappers/wrapper.sh.in" "${bin}/${name}" @ONLY
                 FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                  WORLD_READ WORLD_EXECUTE)
  install(PROGRAMS "${bin}/${name}" DESTINATION bin COMPONENT development)
  foreach(alias IN LISTS aliases)
    file(CREATE_LINK "${name}" "${bin}/${alias}" SYMBOLIC)
    install(PROGRAMS "${bin}/${alias}" DESTINATION bin COMPONENT development)
  endforeach()
endforeach()
eyebridge_link("${EYEBRIDGE_PLUGIN_DIR}/eyebridge-program.map" "${CMAKE_SOURCE_DIR}/apps/wrappers/program.map")
install(FILES "${CMAKE_SOURCE_DIR}/apps/wrappers/program.map" DESTINATION "${EYEBRIDGE_PLUGIN_DIR}"
        RENAME eyebridge-program.map COMPONENT development)
file(RELATIVE_PATH from_pc_to_prefix "/prefix/${libdir}/pkgconfig" "/prefix")
configure_file("${CMAKE_SOURCE_DIR}/cmake/eyebridge.pc.in" "${CMAKE_BINARY_DIR}/${libdir}/pkgconfig/eyebridge.pc" @ONLY)
install(FILES "${CMAKE_BINARY_DIR}/${libdir}/pkgconfig/eyebridge.pc" DESTINATION "${libdir}/pkgconfig"
        COMPONENT development)

install(TARGETS eyebridge_robios eyebridge_classic EXPORT EyeBridgeTargets
        LIBRARY DESTINATION "${libdir}" COMPONENT runtime NAMELINK_COMPONENT development)
install(TARGETS eyebridge_robots eyebridge_robots_classic
        RUNTIME DESTINATION "${EYEBRIDGE_PLUGIN_DIR}" COMPONENT runtime)
install(TARGETS eyebridge_command RUNTIME DESTINATION bin COMPONENT runtime)
add_dependencies(installable eyebridge_robios eyebridge_classic eyebridge_robots eyebridge_robots_classic eyebridge_command)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/robios/include/" DESTINATION "${includedir}/eyebridge"
        COMPONENT development FILES_MATCHING PATTERN "*.h")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/worlds" "${CMAKE_SOURCE_DIR}/examples" DESTINATION share/eyebridge
        COMPONENT runtime PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES "${CMAKE_SOURCE_DIR}/apps/udev/60-eyebridge.rules" DESTINATION lib/udev/rules.d COMPONENT runtime)
# The lab builds its kernel where it is used: only its scripts are installed.
set(lab "${CMAKE_SOURCE_DIR}/tests/lab")
install(PROGRAMS "${lab}/build" "${lab}/run" DESTINATION share/eyebridge/lab COMPONENT runtime)
install(FILES "${lab}/place.sh" "${lab}/kernel.config" "${lab}/change_source.py" "${lab}/guest_init.c"
        "${lab}/register_size.c" DESTINATION share/eyebridge/lab COMPONENT runtime)

# A board's firmware, for boards of one's own. What is built of it is in firmware-stubs/mps2/firmware.cmake.
set(firmware share/eyebridge/firmware/source)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/firmware-stubs/board" "${CMAKE_SOURCE_DIR}/firmware-stubs/mps2"
        DESTINATION "${firmware}" COMPONENT firmware
        FILES_MATCHING PATTERN "*.c" PATTERN "*.h" PATTERN "*.ld" PATTERN "board/README.md"
                       PATTERN "mps2/src" EXCLUDE PATTERN "mps2/include" EXCLUDE)
install(FILES "${CMAKE_SOURCE_DIR}/bridges/protocol/opcodes.h" DESTINATION "${firmware}" COMPONENT firmware)

install(FILES "${CMAKE_SOURCE_DIR}/README.md" "${CMAKE_SOURCE_DIR}/CHANGELOG.md" "${CMAKE_SOURCE_DIR}/LICENSE"
        DESTINATION share/doc/eyebridge COMPONENT documentation)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/docs" DESTINATION share/doc/eyebridge COMPONENT documentation)

# The component episode: simulations in one's own process, C++.
foreach(room base world robot mapping files episode)
  set_target_properties(eyebridge_${room} PROPERTIES EXPORT_NAME ${room})
  target_include_directories(eyebridge_${room} INTERFACE $<INSTALL_INTERFACE:${includedir}/eyebridge-core>)
  target_compile_features(eyebridge_${room} INTERFACE cxx_std_20)
  target_link_options(eyebridge_${room} INTERFACE ${sanitizer_flags})
  install(TARGETS eyebridge_${room} EXPORT EyeBridgeCoreTargets ARCHIVE DESTINATION "${libdir}" COMPONENT development)
  install(DIRECTORY "${CMAKE_SOURCE_DIR}/core/${room}/include/" DESTINATION "${includedir}/eyebridge-core"
          COMPONENT development)
  add_dependencies(installable eyebridge_${room})
endforeach()
export(EXPORT EyeBridgeCoreTargets NAMESPACE EyeBridge::
       FILE "${CMAKE_BINARY_DIR}/EyeBridgeCoreTargets.cmake")
install(EXPORT EyeBridgeCoreTargets NAMESPACE EyeBridge:: DESTINATION "${libdir}/cmake/EyeBridge"
        COMPONENT development)

configure_file("${CMAKE_SOURCE_DIR}/cmake/EyeBridgeConfig.cmake.in"
               "${CMAKE_BINARY_DIR}/EyeBridgeConfig.cmake" @ONLY)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/EyeBridgeConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
export(EXPORT EyeBridgeTargets NAMESPACE EyeBridge::
       FILE "${CMAKE_BINARY_DIR}/EyeBridgeTargets.cmake")
install(EXPORT EyeBridgeTargets NAMESPACE EyeBridge:: DESTINATION "${libdir}/cmake/EyeBridge"
        COMPONENT development)
install(FILES "${CMAKE_BINARY_DIR}/EyeBridgeConfig.cmake"
              "${CMAKE_BINARY_DIR}/EyeBridgeConfigVersion.cmake"
        DESTINATION "${libdir}/cmake/EyeBridge" COMPONENT development)
