# cmake -D SOURCE=folder -D OUTPUT=commit.cpp [-D COMMIT=name] -P EyebridgeCommit.cmake: the commit that is built, as C++.
# It is COMMIT, else what git says of SOURCE, else what `git archive` or pip wrote into
# cmake/commit.txt, else unknown.
# OUTPUT is only written when it changes: else every build would link again.
cmake_minimum_required(VERSION 3.25)

# Without asking who owns the folder: what is built there is trusted anyway.
set(git git -c safe.directory=* -c core.fsmonitor=false -C "${SOURCE}")
set(text "unknown commit")
if(COMMIT)
  if(NOT COMMIT MATCHES "^[0-9A-Za-z._+~-]+$")
    message(FATAL_ERROR "EYEBRIDGE_COMMIT is '${COMMIT}': expected letters, digits and . _ + ~ - only")
  endif()
  set(text "commit ${COMMIT}")
elseif(EXISTS "${SOURCE}/.git")
  execute_process(COMMAND ${git} rev-parse --verify HEAD
                  OUTPUT_VARIABLE hash RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT failed)
    execute_process(COMMAND ${git} --no-optional-locks status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
elseif(EXISTS "${SOURCE}/cmake/commit.txt")
  file(STRINGS "${SOURCE}/cmake/commit.txt" hash LIMIT_COUNT 1)
endif()
if(hash MATCHES "^([0-9a-f]+)(-modified)?$")
  set(hash "${CMAKE_MATCH_1}")
  set(changes "${changes}${CMAKE_MATCH_2}")
  string(SUBSTRING "${hash}" 0 12 hash)
  set(text "commit ${hash}")
  if(changes)
    string(APPEND text "-modified")
  endif()
endif()

set(code "// Made by cmake/EyebridgeCommit.cmake.
#include \"commit.hpp\"

namespace eyebridge::apps {

std::string_view commit() { return \"${text}\"; }

}  // namespace eyebridge::apps
")
if(EXISTS "${OUTPUT}")
  file(READ "${OUTPUT}" present)
endif()
if(NOT present STREQUAL code)
  file(WRITE "${OUTPUT}" "${code}")
endif()
