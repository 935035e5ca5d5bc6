include(CMakePackageConfigHelpers)
set(NCSIM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ncsim)
configure_package_config_file(cmake/ncsimConfig.cmake.in ncsimConfig.cmake
  INSTALL_DESTINATION ${NCSIM_CMAKE_DIR})
# Before 1.0 a new minor version may change the headers (docs/compatibility.md).
set(ncsim_compatibility SameMajorVersion)
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(ncsim_compatibility SameMinorVersion)
endif()
write_basic_package_version_file(ncsimConfigVersion.cmake COMPATIBILITY ${ncsim_compatibility})
install(EXPORT ncsimTargets NAMESPACE ncsim:: DESTINATION ${NCSIM_CMAKE_DIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfigVersion.cmake
        DESTINATION ${NCSIM_CMAKE_DIR})

# A package of the program for Debian 12, by `./dev package`: what it links to, and what it loads when
# it draws. With it come the documents and the samples.
install(FILES LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs samples examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program)
# What reads STEP is a package of its own, where it was built: OpenCASCADE comes with it.
if(TARGET ncsim_step)
  list(APPEND CPACK_COMPONENTS_ALL step)
  set(CPACK_DEBIAN_STEP_PACKAGE_NAME ncsim-step)
  set(CPACK_DEBIAN_STEP_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_STEP_DESCRIPTION "reads STEP for ncsim
 With it ncsim takes designs, stock and fixtures as STEP.")
  set(CPACK_DEBIAN_STEP_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_STEP_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_STEP_PACKAGE_DEPENDS ncsim)
endif()
# The Python package, for the Python that it was built for.
if(TARGET ncsim_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-ncsim)
  set(CPACK_DEBIAN_PYTHON_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "simulates and verifies NC milling programs (Python 3)
 With it Python scripts have the part of a program as NumPy arrays, and its verdict as objects.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${NCSIM_PYTHON_DEPENDS}")
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The ncsim project <ncsim@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates NC milling programs and verifies them")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME ncsim)
set(CPACK_DEBIAN_PROGRAM_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
  "ncsim reads G-code, moves the cutter, takes what it sweeps away from the stock exactly, and
says what is left and whether the program is safe: pictures, meshes, solids, reports, exit codes
for CI.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libosmesa6)
include(CPack)
