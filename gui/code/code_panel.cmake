# The code panel, where QScintilla is installed. EYEBRIDGE_HAVE_CODE_PANEL says to others that it is there.
set(EYEBRIDGE_HAVE_CODE_PANEL OFF CACHE INTERNAL "Whether there is a code panel: for its tests")
get_target_property(qt_folders Qt6::Core INTERFACE_INCLUDE_DIRECTORIES)
find_path(QSCINTILLA_INCLUDE Qsci/qsciscintilla.h HINTS ${qt_folders})
find_library(QSCINTILLA_LIBRARY qscintilla2_qt6)
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT QSCINTILLA_INCLUDE OR NOT QSCINTILLA_LIBRARY OR NOT Python3_FOUND)
  return()
endif()

# What is offered while typing is what the headers and the stub declare.
set(completions "${CMAKE_CURRENT_BINARY_DIR}/completions_data.cpp")
file(GLOB declarations CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/robios/include/*.h" "${PROJECT_SOURCE_DIR}/robios/include/*/*.h"
     "${PROJECT_SOURCE_DIR}/robios/include/classic/*/*.h" "${PROJECT_SOURCE_DIR}/python/eye/*.py*")
add_custom_command(
  OUTPUT "${completions}"
  COMMAND Python3::Interpreter -B "${CMAKE_CURRENT_SOURCE_DIR}/code/generate_completions.py" "${PROJECT_SOURCE_DIR}" "${completions}"
  DEPENDS code/generate_completions.py ${declarations}
  VERBATIM)

target_sources(eyebridge_windows PRIVATE
  "${completions}" code/code_files.cpp code/code_menus.cpp code/code_run.cpp code/code_settings.cpp code/code_window.cpp
  code/completions.cpp code/editor.cpp code/examples.cpp code/find_bar.cpp code/language.cpp
  code/output_view.cpp code/page.cpp code/recovery.cpp code/robios_apis.cpp code/run_bar.cpp code/run_plan.cpp
  code/runner.cpp code/templates.cpp code/terminal.cpp code/text_file.cpp)
target_include_directories(eyebridge_windows SYSTEM PUBLIC "${QSCINTILLA_INCLUDE}")
target_link_libraries(eyebridge_windows PUBLIC eyebridge::gui_messages eyebridge::files "${QSCINTILLA_LIBRARY}")
set(EYEBRIDGE_HAVE_CODE_PANEL ON CACHE INTERNAL "Whether there is a code panel: for its tests")
target_compile_definitions(eyebridge_windows PUBLIC EYEBRIDGE_HAVE_CODE_PANEL)
