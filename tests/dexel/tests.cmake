ncsim_add_test(dexel
  LIBRARIES ncsim::dexel
  SOURCES
    along_z_test.cpp
    cell_components_test.cpp
    cutter_test.cpp
    dexel_test.cpp
    open_cutter_test.cpp
    rays_test.cpp
    round_sweep_test.cpp
    stretches_test.cpp
    thin_places_test.cpp)
target_include_directories(ncsim_dexel_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/dexel/src)
