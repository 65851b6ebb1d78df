# Where files lie below a prefix. The build folder is laid out like an installation, so that one rule finds our own files in
# both (core/base: own_place.hpp), and an installation can be moved.
include(GNUInstallDirs)
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}" OR IS_ABSOLUTE "${CMAKE_INSTALL_INCLUDEDIR}")
  message(FATAL_ERROR "CMAKE_INSTALL_LIBDIR is ${CMAKE_INSTALL_LIBDIR}, CMAKE_INSTALL_INCLUDEDIR is ${CMAKE_INSTALL_INCLUDEDIR}: "
          "expected paths relative to CMAKE_INSTALL_PREFIX, since an installation can be moved")
endif()
# What is loaded or started by EyeBridge alone: plug-ins, launchers, links to its Python packages.
set(EYEBRIDGE_PLUGIN_DIR "${CMAKE_INSTALL_LIBDIR}/eyebridge")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")

# `name` below the build folder is `target`, a file or folder of the source or of the build.
function(eyebridge_link name target)
  set(link "${CMAKE_BINARY_DIR}/${name}")
  cmake_path(GET link PARENT_PATH folder)
  file(MAKE_DIRECTORY "${folder}")
  file(CREATE_LINK "${target}" "${link}" SYMBOLIC)
endfunction()
eyebridge_link(share/eyebridge/worlds "${CMAKE_SOURCE_DIR}/worlds")
eyebridge_link(share/eyebridge/examples "${CMAKE_SOURCE_DIR}/examples")
eyebridge_link(share/eyebridge/lab "${CMAKE_SOURCE_DIR}/tests/lab")
eyebridge_link(share/eyebridge/firmware "${CMAKE_BINARY_DIR}/firmware")
eyebridge_link("${CMAKE_INSTALL_INCLUDEDIR}/eyebridge" "${CMAKE_SOURCE_DIR}/robios/include")
eyebridge_link(lib/udev/rules.d/60-eyebridge.rules "${CMAKE_SOURCE_DIR}/apps/udev/60-eyebridge.rules")
eyebridge_link("${EYEBRIDGE_PLUGIN_DIR}/python" "${CMAKE_BINARY_DIR}/python")

# Everything that `cmake --install` copies: it fails where something of it was not built.
add_custom_target(installable)

# eyebridge_plugin(eyebridge_gui gui): a library that is loaded when it is needed, of the component `gui`.
function(eyebridge_plugin target component)
  set_target_properties(${target} PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${EYEBRIDGE_PLUGIN_DIR}")
  install(TARGETS ${target} LIBRARY DESTINATION "${EYEBRIDGE_PLUGIN_DIR}" COMPONENT ${component})
  add_dependencies(installable ${target})
endfunction()
