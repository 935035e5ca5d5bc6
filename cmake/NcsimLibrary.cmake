# ncsim_add_library(<name> HEADERS <public headers...> SOURCES <sources...>)
#
# Creates ncsim_<name> with the alias ncsim::<name>. Public headers are listed
# one by one: the list is the API, and each header must compile on its own.
function(ncsim_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES")
  list(TRANSFORM arg_HEADERS PREPEND include/ncsim/${name}/)
  list(TRANSFORM arg_SOURCES PREPEND src/)

  add_library(ncsim_${name} STATIC ${arg_SOURCES})
  add_library(ncsim::${name} ALIAS ncsim_${name})
  target_sources(ncsim_${name} PUBLIC
    FILE_SET HEADERS BASE_DIRS include FILES ${arg_HEADERS})
  target_include_directories(ncsim_${name} PRIVATE src)
  target_compile_features(ncsim_${name} PUBLIC cxx_std_20)
  target_link_libraries(ncsim_${name} PRIVATE $<BUILD_INTERFACE:ncsim_build_flags>)
  set_target_properties(ncsim_${name} PROPERTIES
    EXPORT_NAME ${name}
    CXX_EXTENSIONS OFF
    POSITION_INDEPENDENT_CODE ON
    VERIFY_INTERFACE_HEADER_SETS ON)
  ncsim_join_sources(ncsim_${name})
  install(TARGETS ncsim_${name} EXPORT ncsimTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
endfunction()

# Has sources compiled several at a time, if NCSIM_UNITY says so: half of the time goes into headers
# that they have in common. What is private to a source then needs a name that its neighbours do
# not have.
function(ncsim_join_sources target)
  if(NCSIM_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 24)
  endif()
endfunction()

# Has a library compiled without the optimizations that cost most: for code that runs once a command
# (options, reports), where a quarter of the compile time buys nothing that can be measured.
function(ncsim_optimize_lightly target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
