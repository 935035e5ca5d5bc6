ncsim_add_test(cda
  LIBRARIES
    ncsim::cda
    gmpxx
    gmp
  SOURCES
    account_test.cpp
    block_tree_test.cpp
    check_test.cpp
    collision_test.cpp
    covering_test.cpp
    domination_test.cpp
    evaluation_test.cpp
    filtered_polygon_test.cpp
    flat_test.cpp
    half_box_test.cpp
    hull_test.cpp
    interner_test.cpp
    intersect_test.cpp
    lattice_quickhull_test.cpp
    lattice_test.cpp
    loops_test.cpp
    normal_table_test.cpp
    numbering_test.cpp
    outlines_test.cpp
    plane_store_test.cpp
    polytope_test.cpp
    predicates_test.cpp
    same_way_test.cpp
    separation_test.cpp
    shape_test.cpp
    surface_recorder_test.cpp
    tiles_test.cpp
    tree_test.cpp
    triangulate_test.cpp
    wide_test.cpp
    whole_turn_test.cpp
    workpiece_test.cpp)
target_include_directories(ncsim_cda_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/cda/src)

# Convex pairs against another library, which brings Eigen: a program of its own.
find_package(fcl CONFIG REQUIRED)
add_executable(ncsim_cda_fcl_tests cda/fcl_pairs_test.cpp)
target_compile_features(ncsim_cda_fcl_tests PRIVATE cxx_std_20)
target_include_directories(ncsim_cda_fcl_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_cda_fcl_tests PRIVATE ncsim::cda fcl GTest::gtest_main)
gtest_discover_tests(ncsim_cda_fcl_tests DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 300)
