# How others find EyeBridge: eyebridge-cc and eyebridge-c++ (gccsim, g++sim), eyebridge.pc, find_package(EyeBridge).
# Each works from the build tree and from an installation, which can be moved: apart from the
# headers of the build tree, all paths are relative to the file itself.
include(CMakePackageConfigHelpers)

# What a program must be built with to load a library of ours that has a sanitizer in it.
set(sanitizer_flags "")
if(EYEBRIDGE_SANITIZE AND NOT EYEBRIDGE_FUZZ)
  set(sanitizer_flags "-fsanitize=${EYEBRIDGE_SANITIZE}")
endif()

# What people's Makefiles call the wrappers: those of EyeSim, and of the robots' own computers.
set(wrapper_aliases "gccsim:eyebridge-cc" "gccarm:eyebridge-cc" "g++sim:eyebridge-c++" "g++arm:eyebridge-c++")

# Writes bin/eyebridge-cc, bin/eyebridge-c++, their aliases and lib/pkgconfig/eyebridge.pc under `folder`.
# `include_folder` may start with @PREFIX@, which each file replaces by the way it finds itself.
function(eyebridge_package_files folder include_folder)
  string(REPLACE "@PREFIX@" "$prefix" shell_include "${include_folder}")
  string(REPLACE "@PREFIX@" "\${prefix}" pc_include "${include_folder}")
  foreach(wrapper "eyebridge-cc:gcc" "eyebridge-c++:g++")
    string(REPLACE ":" ";" wrapper "${wrapper}")
    list(GET wrapper 0 name)
    list(GET wrapper 1 compiler)
    configure_file("${CMAKE_SOURCE_DIR}/apps/wrappers/wrapper.sh.in" "${folder}/bin/${name}" @ONLY
                   FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                    WORLD_READ WORLD_EXECUTE)
  endforeach()
  foreach(alias ${wrapper_aliases})
    string(REPLACE ":" ";" alias "${alias}")
    list(GET alias 0 name)
    list(GET alias 1 wrapper)
    file(CREATE_LINK "${wrapper}" "${folder}/bin/${name}" SYMBOLIC)
  endforeach()
  configure_file("${CMAKE_SOURCE_DIR}/apps/wrappers/program.map"
                 "${folder}/lib/eyebridge-program.map" COPYONLY)
  configure_file("${CMAKE_SOURCE_DIR}/cmake/eyebridge.pc.in" "${folder}/lib/pkgconfig/eyebridge.pc"
                 @ONLY)
endfunction()

set(for_installation "${CMAKE_BINARY_DIR}/for_installation")
eyebridge_package_files("${CMAKE_BINARY_DIR}" "${CMAKE_SOURCE_DIR}/robios/include")
eyebridge_package_files("${for_installation}" "@PREFIX@/include/eyebridge")

install(TARGETS eyebridge_robios eyebridge_classic EXPORT EyeBridgeTargets LIBRARY DESTINATION lib)
install(TARGETS eyebridge_robots eyebridge_robots_classic RUNTIME DESTINATION lib)
install(TARGETS eyebridge_command RUNTIME DESTINATION bin)
install(DIRECTORY "${for_installation}/bin/" DESTINATION bin USE_SOURCE_PERMISSIONS)
install(FILES "${for_installation}/lib/eyebridge-program.map" DESTINATION lib)
install(FILES "${for_installation}/lib/pkgconfig/eyebridge.pc" DESTINATION lib/pkgconfig)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/robios/include/" DESTINATION include/eyebridge
        FILES_MATCHING PATTERN "*.h")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/worlds" DESTINATION share/eyebridge)
install(DIRECTORY "${CMAKE_SOURCE_DIR}/apps/udev" DESTINATION share/eyebridge)
# The lab builds its kernel where it is used: only its scripts are installed.
set(lab "${CMAKE_SOURCE_DIR}/tests/lab")
install(PROGRAMS "${lab}/build" "${lab}/run" DESTINATION share/eyebridge/lab)
install(FILES "${lab}/place.sh" "${lab}/kernel.config" "${lab}/change_source.py" "${lab}/guest_init.c"
        DESTINATION share/eyebridge/lab)

# The component episode: simulations in one's own process, C++.
foreach(room base world robot mapping files episode)
  set_target_properties(eyebridge_${room} PROPERTIES EXPORT_NAME ${room})
  target_include_directories(eyebridge_${room} INTERFACE $<INSTALL_INTERFACE:include/eyebridge-core>)
  target_compile_features(eyebridge_${room} INTERFACE cxx_std_20)
  target_link_options(eyebridge_${room} INTERFACE ${sanitizer_flags})
  install(TARGETS eyebridge_${room} EXPORT EyeBridgeCoreTargets ARCHIVE DESTINATION lib)
  install(DIRECTORY "${CMAKE_SOURCE_DIR}/core/${room}/include/" DESTINATION include/eyebridge-core)
endforeach()
export(EXPORT EyeBridgeCoreTargets NAMESPACE EyeBridge::
       FILE "${CMAKE_BINARY_DIR}/EyeBridgeCoreTargets.cmake")
install(EXPORT EyeBridgeCoreTargets NAMESPACE EyeBridge:: DESTINATION lib/cmake/EyeBridge)

configure_file("${CMAKE_SOURCE_DIR}/cmake/EyeBridgeConfig.cmake.in"
               "${CMAKE_BINARY_DIR}/EyeBridgeConfig.cmake" @ONLY)
write_basic_package_version_file("${CMAKE_BINARY_DIR}/EyeBridgeConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
export(EXPORT EyeBridgeTargets NAMESPACE EyeBridge::
       FILE "${CMAKE_BINARY_DIR}/EyeBridgeTargets.cmake")
install(EXPORT EyeBridgeTargets NAMESPACE EyeBridge:: DESTINATION lib/cmake/EyeBridge)
install(FILES "${CMAKE_BINARY_DIR}/EyeBridgeConfig.cmake"
              "${CMAKE_BINARY_DIR}/EyeBridgeConfigVersion.cmake"
        DESTINATION lib/cmake/EyeBridge)
