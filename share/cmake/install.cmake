# Contents of an installed tree.

# Definitions for editors, man page and completion follow from tables of the program.
set(generated ${PROJECT_BINARY_DIR}/generated)
file(GLOB_RECURSE tables CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lua/*.lua)
add_custom_command(OUTPUT ${generated}/man/signorini.1.gz
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${generated}
  COMMAND ${CMAKE_COMMAND} -E env SIGNORINI_HOME=${PROJECT_SOURCE_DIR} ${CMAKE_CROSSCOMPILING_EMULATOR}
    $<TARGET_FILE:signorini> ${PROJECT_SOURCE_DIR}/share/cmake/generated.lua ${generated}
  COMMAND gzip -9n ${generated}/man/signorini.1 # as Debian requires
  DEPENDS signorini ${tables} share/cmake/generated.lua share/man/signorini.1 share/completion/signorini VERBATIM)
if(NOT SIGNORINI_SANITIZE) # such a program is not installed, and slow
  add_custom_target(generated ALL DEPENDS ${generated}/man/signorini.1.gz)
endif()
install(DIRECTORY ${generated}/library DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(FILES ${generated}/man/signorini.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${generated}/completion/signorini DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

# In a folder of their own: libraries directly below lib or a folder of it would make packages call ldconfig.
set(modules lib/signorini/modules)

install(TARGETS signorini RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS signorini_view signorini_flat LIBRARY DESTINATION ${modules})
if(TARGET signorini_terminal)
  install(TARGETS signorini_terminal LIBRARY DESTINATION ${modules})
endif()
if(TARGET signorini_sandbox)
  install(TARGETS signorini_sandbox LIBRARY DESTINATION ${modules})
endif()
if(TARGET signorini_mumps)
  install(TARGETS signorini_mumps LIBRARY DESTINATION ${modules} COMPONENT mumps)
endif()
if(TARGET signorini_kernel)
  install(TARGETS signorini_kernel LIBRARY DESTINATION ${modules} COMPONENT jupyter)
  install(DIRECTORY share/jupyter/ DESTINATION ${CMAKE_INSTALL_DATADIR}/jupyter/kernels/signorini COMPONENT jupyter)
endif()
if(TARGET signorini_hdf5)
  install(TARGETS signorini_hdf5 LIBRARY DESTINATION ${modules} COMPONENT hdf5)
endif()
install(DIRECTORY lua DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(DIRECTORY scripts DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini FILES_MATCHING PATTERN "*.lua")
install(DIRECTORY share/ DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini
  PATTERN man EXCLUDE
  PATTERN mkdocs.yml EXCLUDE
  PATTERN completion EXCLUDE
  PATTERN cmake EXCLUDE)
install(FILES README.md CONTRIBUTING.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
# Adapts links between pages, and the path of the program, to the installed tree.
install(CODE "set(tree \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/signorini\")")
install(CODE [[
  file(GLOB_RECURSE pages ${tree}/*.md)
  foreach(page ${pages})
    file(READ ${page} text)
    string(REPLACE "build/signorini" "signorini" text "${text}")
    if(page STREQUAL "${tree}/README.md" OR page STREQUAL "${tree}/CONTRIBUTING.md")
      string(REPLACE "share/" "" text "${text}")
    endif()
    file(WRITE ${page} "${text}")
  endforeach()
]])
