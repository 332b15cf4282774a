# Read by cpack: a package depends on those that have the libraries of its binaries, as dpkg-shlibdeps finds them. CPack
# can call it, too, but to find the binaries it first starts two programs for each of 500 files.
if(CPACK_GENERATOR STREQUAL DEB)
  list(GET CPACK_BUILD_SOURCE_DIRS 1 build)
  set(scratch ${CPACK_PACKAGE_DIRECTORY}/dependencies)
  foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} key)
    list(TRANSFORM CPACK_BINARIES_${key} PREPEND ${build}/)
    file(WRITE ${scratch}/debian/control "") # dpkg-shlibdeps requires one
    execute_process(COMMAND dpkg-shlibdeps --ignore-missing-info -O ${CPACK_BINARIES_${key}} WORKING_DIRECTORY ${scratch}
      OUTPUT_VARIABLE found ERROR_VARIABLE message RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
    file(REMOVE_RECURSE ${scratch})
    if(NOT status EQUAL 0)
      message(FATAL_ERROR "dpkg-shlibdeps: ${message}")
    endif()
    string(REGEX REPLACE "^.*Depends=" "" found "${found}")
    set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${found}, ${CPACK_DEBIAN_${key}_PACKAGE_DEPENDS}")
  endforeach()
endif()
