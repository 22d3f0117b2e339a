# Two packages for Debian: `cpack --preset debian` after a build.
set(CPACK_GENERATOR DEB)
set(CPACK_COMPONENTS_ALL program)
if(TARGET overbend_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_PACKAGE_NAME overbend)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Overbend developers <overbend@example.org>" CACHE STRING "Maintainer of the Debian packages")
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_SET_DESTDIR ON)  # so that the prefix is /usr for what asks for it
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_SOURCE_DIR}/debian/folders.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME overbend)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "python3-overbend (= ${PROJECT_VERSION})")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "analysis of offshore pipelay
Static and dynamic analysis of S-lay and J-lay: tension, stresses, roller
reactions, code checks, moorings, operations on the line, studies and limits
of operation. Command line, reports in HTML, interface in the browser.
This package has the program, its documents and examples.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-overbend)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-xarray, python3-matplotlib")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "overbend (= ${PROJECT_VERSION}), python3-pandas, python3-h5py")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/postinst
                                              ${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "analysis of offshore pipelay (Python package)
Static and dynamic analysis of S-lay and J-lay in Python: models, results as
labelled arrays, simulations step by step, goal seek and studies.
This package has the engine in it; the program, documents and examples are in
the package overbend.")
if(TARGET overbend_python)
  # A module is of one Python: 3.11 takes what was built for 3.11.
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}~), python3 (<< 3.${next}), python3-numpy")
endif()

# Debian's own form of a changelog, of this version alone; ours is beside it.
string(TIMESTAMP today "%a, %d %b %Y 00:00:00 +0000" UTC)
set(CHANGELOG ${CMAKE_CURRENT_BINARY_DIR}/changelog)
file(CONFIGURE OUTPUT ${CHANGELOG} CONTENT "overbend (@PROJECT_VERSION@) unstable; urgency=medium

  * Packages of version @PROJECT_VERSION@; CHANGELOG.md says what is new.

 -- @CPACK_PACKAGE_CONTACT@  @today@
")
add_custom_command(OUTPUT ${CHANGELOG}.gz COMMAND ${OVERBEND_GZIP} -9nc ${CHANGELOG} > ${CHANGELOG}.gz
                   DEPENDS ${CHANGELOG} VERBATIM)
add_custom_target(overbend_changelog ALL DEPENDS ${CHANGELOG}.gz)
add_dependencies(overbend_installed overbend_changelog)
install(FILES ${CHANGELOG}.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/overbend COMPONENT program)
if(TARGET overbend_python)
  install(FILES ${CHANGELOG}.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-overbend COMPONENT python)
endif()

include(CPack)
