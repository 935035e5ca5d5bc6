include(CMakePackageConfigHelpers)
set(NCSIM_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/ncsim)
configure_package_config_file(cmake/ncsimConfig.cmake.in ncsimConfig.cmake
  INSTALL_DESTINATION ${NCSIM_CMAKE_DIR})
write_basic_package_version_file(ncsimConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT ncsimTargets NAMESPACE ncsim:: DESTINATION ${NCSIM_CMAKE_DIR})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/ncsimConfigVersion.cmake
        DESTINATION ${NCSIM_CMAKE_DIR})
