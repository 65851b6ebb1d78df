# Manual pages, which the command writes from its own tables, and the completion of shells.
set(manual "${CMAKE_BINARY_DIR}/share/man/man1")
add_custom_command(OUTPUT "${manual}/eyebridge.1"
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${manual}"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${manual}"
  COMMAND eyebridge_command manual "${manual}" > "${CMAKE_BINARY_DIR}/manual.log"
  DEPENDS eyebridge_command
  COMMENT "Writing the manual pages"
  VERBATIM)
add_custom_target(eyebridge_manual ALL DEPENDS "${manual}/eyebridge.1")
add_dependencies(installable eyebridge_manual)
install(DIRECTORY "${manual}/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT runtime)

# Those of the compilers: one page with several names.
set(manual "${CMAKE_BINARY_DIR}/for_installation/man1")
configure_file("${CMAKE_SOURCE_DIR}/apps/manual/eyebridge-cc.1.in" "${manual}/eyebridge-cc.1" @ONLY)
foreach(name eyebridge-c++ gccsim gccarm g++sim g++arm)
  file(CREATE_LINK eyebridge-cc.1 "${manual}/${name}.1" SYMBOLIC)
endforeach()
install(DIRECTORY "${manual}/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT development)

# eyebridge_completion(FILE FOLDER NAME): a shell looks for it in share/FOLDER, by this name.
function(eyebridge_completion file folder name)
  eyebridge_link("share/${folder}/${name}" "${CMAKE_SOURCE_DIR}/apps/completion/${file}")
  install(FILES "${CMAKE_SOURCE_DIR}/apps/completion/${file}" DESTINATION "share/${folder}" RENAME "${name}" COMPONENT runtime)
endfunction()
eyebridge_completion(eyebridge.bash bash-completion/completions eyebridge)
eyebridge_completion(_eyebridge zsh/vendor-completions _eyebridge)
eyebridge_completion(eyebridge.fish fish/vendor_completions.d eyebridge.fish)
