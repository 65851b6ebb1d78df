# Whether the windows (gui/) are built, EYEBRIDGE_HAS_GUI: where Qt 6 and XCB are installed. Here, because robios/ ends windows
# before Qt does, and comes before gui/.
option(EYEBRIDGE_WITH_GUI "Build the windows, where Qt 6 is installed" ON)
set(EYEBRIDGE_HAS_GUI OFF)
if(NOT EYEBRIDGE_WITH_GUI OR EYEBRIDGE_FUZZ OR EYEBRIDGE_SANITIZE MATCHES "thread")
  return()  # Qt is not built for the thread sanitizer
endif()
find_package(Qt6 QUIET COMPONENTS Widgets)  # qt6-base-dev
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(XCB QUIET IMPORTED_TARGET xcb)  # libxcb1-dev
endif()
if(Qt6_FOUND AND XCB_FOUND)
  set(EYEBRIDGE_HAS_GUI ON)
endif()
