include(CMakePackageConfigHelpers)
set(NCSIM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ncsim)
configure_package_config_file(cmake/ncsimConfig.cmake.in ncsimConfig.cmake
  INSTALL_DESTINATION ${NCSIM_CMAKE_DIR})
write_basic_package_version_file(ncsimConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(EXPORT ncsimTargets NAMESPACE ncsim:: DESTINATION ${NCSIM_CMAKE_DIR} COMPONENT development)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfigVersion.cmake
        DESTINATION ${NCSIM_CMAKE_DIR} COMPONENT development)

# Packages for Debian 12, by `./dev package`: the program with what it loads when it draws, documents and samples; the
# reader of STEP, because OpenCASCADE comes with it; the Python package; libraries and headers.
install(FILES README.md CHANGELOG.md SECURITY.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs samples examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_CONTACT "The ncsim project <ncsim@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulates NC milling programs and verifies them")
set(CPACK_COMPONENTS_ALL)

# ncsim_debian_package(<component> <package> <section> <depends> <description>)
function(ncsim_debian_package component package section depends description)
  string(TOUPPER ${component} upper)
  foreach(value PACKAGE_NAME=${package} FILE_NAME=DEB-DEFAULT PACKAGE_SECTION=${section} PACKAGE_SHLIBDEPS=ON)
    string(REPLACE "=" ";" value ${value})
    list(POP_FRONT value key)
    set(CPACK_DEBIAN_${upper}_${key} ${value} PARENT_SCOPE)
  endforeach()
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${description}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  # What Debian requires in each package.
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/debian/${package})
  configure_file(cmake/debian/changelog.in ${folder}/changelog @ONLY)
  execute_process(COMMAND gzip -9nfk ${folder}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${folder}/changelog.gz cmake/debian/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endfunction()

# Its first line is CPACK_PACKAGE_DESCRIPTION_SUMMARY.
ncsim_debian_package(program ncsim science libosmesa6
  "ncsim reads G-code, Klartext and SINUMERIK programs, cuts the stock exactly,
and writes the part that is left as pictures, meshes, solids and drawings.
It says whether the program is safe, with exit codes for CI.")
if(TARGET ncsim_step)
  ncsim_debian_package(step ncsim-step science ncsim "reads STEP for ncsim
 With it ncsim takes designs, stock and fixtures as STEP.")
endif()
if(TARGET ncsim_python)
  ncsim_debian_package(python python3-ncsim python "${NCSIM_PYTHON_DEPENDS}"
    "simulates and verifies NC milling programs (Python 3)
 With it Python scripts have the part of a program as NumPy arrays,
 and its verdict as objects.")
endif()
ncsim_debian_package(development libncsim-dev libdevel
  "libqhull-dev, libfmt-dev, libgif-dev, libpng-dev, zlib1g-dev, libtinygltf-dev, libtinyxml2-dev, libtomlplusplus-dev, \
libgmp-dev, libmpfr-dev, nettle-dev, libzip-dev"
  "libraries and headers of ncsim
 C++ libraries that read NC programs, simulate and verify them, and export
 the part, with a CMake package.")
include(CPack)
