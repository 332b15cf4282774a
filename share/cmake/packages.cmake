# Debian packages: cpack --config build/CPackConfig.cmake, with -D CPACK_PACKAGE_CONTACT='Name <address>' for a
# maintainer's name; and the source as an archive: cpack --config build/CPackSourceConfig.cmake.

# ── Files that Debian requires of each package ───────────────────────────────────────────────────────────────────────

set(debian ${PROJECT_BINARY_DIR}/debian)
file(MAKE_DIRECTORY ${debian})
set(CPACK_PACKAGE_CONTACT "The maintainers of signorini <maintainers@localhost>")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC) # SOURCE_DATE_EPOCH sets it for reproducible packages

# Adds one package: component, name, binaries in the build folder.
function(debian_package component package)
  file(WRITE ${debian}/${package}.changelog "${package} (${PROJECT_VERSION}) unstable; urgency=medium

  * The changes are described in CHANGELOG.md of the package signorini.

 -- ${CPACK_PACKAGE_CONTACT}  ${now}
")
  # Compressed as Debian requires, without name and time of the file.
  execute_process(COMMAND gzip -9nf ${debian}/${package}.changelog COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${debian}/${package}.overrides "# Packages made by users have no address of a maintainer.
${package}: bogus-mail-host Maintainer maintainers@localhost
${package}: bogus-mail-host-in-debian-changelog maintainers@localhost *
")
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${PROJECT_SOURCE_DIR}/share/cmake/debian/copyright DESTINATION ${documents} COMPONENT ${component})
  install(FILES ${debian}/${package}.changelog.gz DESTINATION ${documents} COMPONENT ${component} RENAME changelog.gz)
  install(FILES ${debian}/${package}.overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
          COMPONENT ${component} RENAME ${package})
  string(TOUPPER ${component} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_BINARIES_${key} ${ARGN} PARENT_SCOPE)
endfunction()

# ── Packages ─────────────────────────────────────────────────────────────────────────────────────────────────────────

set(CPACK_GENERATOR DEB)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "isogeometric contact mechanics from Lua")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/share/cmake/dependencies.cmake)
# dpkg-shlibdeps accepts the reference BLAS, which makes runs in space a quarter slower: recommend OpenBLAS. The
# recommended fonts have Chinese and Japanese characters.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libopenblas0, fonts-droid-fallback")
# Modules whose libraries the program does not need are packages of their own.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(binaries signorini)
foreach(module IN ITEMS view flat terminal sandbox)
  if(TARGET signorini_${module})
    list(APPEND binaries ${modules}/signorini_${module}.so)
  endif()
endforeach()
debian_package(Unspecified signorini ${binaries})
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_DEPENDS fonts-liberation) # for texts in pictures
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "Solves contact problems in 2D and 3D with NURBS bodies that have layers of
varying order on their contact faces: finite deformation, friction, adhesion,
rigid tools. Scenes, solver controls and studies are written in Lua, at a
prompt or in scripts; states and charts are drawn off-screen.")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_SUGGESTS "signorini-mumps, signorini-jupyter, signorini-hdf5, ffmpeg")
if(TARGET signorini_mumps)
  debian_package(mumps signorini-mumps ${modules}/signorini_mumps.so)
  set(CPACK_COMPONENT_MUMPS_DESCRIPTION "The parallel linear solver MUMPS, and runs on several processes with MPI.")
  set(CPACK_DEBIAN_MUMPS_PACKAGE_DEPENDS "signorini (= ${PROJECT_VERSION}), openmpi-bin")
  set(CPACK_DEBIAN_MUMPS_PACKAGE_RECOMMENDS "")
endif()
if(TARGET signorini_kernel)
  debian_package(jupyter signorini-jupyter ${modules}/signorini_kernel.so)
  set(CPACK_COMPONENT_JUPYTER_DESCRIPTION "The kernel for notebooks of Jupyter.")
  set(CPACK_DEBIAN_JUPYTER_PACKAGE_DEPENDS "signorini (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_JUPYTER_PACKAGE_RECOMMENDS jupyter-notebook)
endif()
if(TARGET signorini_hdf5)
  debian_package(hdf5 signorini-hdf5 ${modules}/signorini_hdf5.so)
  set(CPACK_COMPONENT_HDF5_DESCRIPTION "Runs written as files of HDF5 for Python, Julia, MATLAB and others.")
  set(CPACK_DEBIAN_HDF5_PACKAGE_DEPENDS "signorini (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_HDF5_PACKAGE_RECOMMENDS "")
endif()

# ── Source ───────────────────────────────────────────────────────────────────────────────────────────────────────────

set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME signorini-${PROJECT_VERSION})
# What .gitignore excludes.
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/(build[^/]*|out|\\\\.git)/")
include(CPack)
