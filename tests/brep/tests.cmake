ncsim_add_test(brep
  LIBRARIES ncsim::simulation
  SOURCES
    check_test.cpp
    golden_test.cpp
    solids.cpp)

# OpenCASCADE judges them, too (export/tests.cmake has its reader).
set(solids ${CMAKE_CURRENT_BINARY_DIR}/brep/solids)
add_executable(ncsim_brep_solids brep/write_solids.cpp brep/solids.cpp)
target_include_directories(ncsim_brep_solids PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_brep_solids PRIVATE ncsim::brep ncsim::export ncsim_build_flags)
add_test(NAME brep.write_solids COMMAND ncsim_brep_solids ${solids})
set_tests_properties(brep.write_solids PROPERTIES FIXTURES_SETUP brep_solids)
add_test(NAME brep.solids_are_read_by_opencascade COMMAND ncsim_read_step ${solids})
set_tests_properties(brep.solids_are_read_by_opencascade PROPERTIES FIXTURES_REQUIRED brep_solids)

# Parts of random programs likewise; more of them by hand: ncsim_brep_random <folder> 1000.
find_package(fmt CONFIG REQUIRED)
set(random ${CMAKE_CURRENT_BINARY_DIR}/brep/random)
add_executable(ncsim_brep_random brep/write_random_parts.cpp brep/random_parts.cpp)
target_include_directories(ncsim_brep_random PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_brep_random PRIVATE ncsim::simulation fmt::fmt-header-only
  ncsim_build_flags)
add_test(NAME brep.write_random_parts COMMAND ncsim_brep_random ${random} 24)
set_tests_properties(brep.write_random_parts PROPERTIES FIXTURES_SETUP brep_random)
add_test(NAME brep.random_parts_are_read_by_opencascade COMMAND ncsim_read_step ${random})
set_tests_properties(brep.random_parts_are_read_by_opencascade PROPERTIES
  FIXTURES_REQUIRED brep_random)
