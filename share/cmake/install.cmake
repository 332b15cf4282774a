# Contents of an installed tree, and its Debian packages: cpack --config build/CPackConfig.cmake

install(TARGETS signorini RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS signorini_view signorini_flat LIBRARY DESTINATION lib/signorini)
if(TARGET signorini_terminal)
  install(TARGETS signorini_terminal LIBRARY DESTINATION lib/signorini)
endif()
if(TARGET signorini_mumps)
  install(TARGETS signorini_mumps LIBRARY DESTINATION lib/signorini COMPONENT mumps)
endif()
install(DIRECTORY lua DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini)
install(DIRECTORY scripts DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini FILES_MATCHING PATTERN "*.lua")
install(DIRECTORY share/ DESTINATION ${CMAKE_INSTALL_DATADIR}/signorini
  PATTERN man EXCLUDE
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
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES share/man/signorini.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES share/completion/signorini DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The maintainers of signorini <maintainers@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# dpkg-shlibdeps finds the libraries; texts in pictures need the fonts.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS fonts-liberation)
# dpkg-shlibdeps accepts the reference BLAS, which makes runs in space a quarter slower: recommend OpenBLAS. The
# recommended fonts have Chinese and Japanese characters.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libopenblas0, fonts-droid-fallback")
# MUMPS and MPI are dependencies of a package of their own, so that the program can be installed without them.
if(TARGET signorini_mumps)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME signorini)
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS signorini-mumps)
  set(CPACK_COMPONENT_MUMPS_DESCRIPTION "Parallel linear solver MUMPS for signorini")
  set(CPACK_DEBIAN_MUMPS_PACKAGE_NAME signorini-mumps)
  set(CPACK_DEBIAN_MUMPS_PACKAGE_DEPENDS "signorini (= ${PROJECT_VERSION}), openmpi-bin")
  set(CPACK_DEBIAN_MUMPS_PACKAGE_RECOMMENDS "")
endif()
include(CPack)
