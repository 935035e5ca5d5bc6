ncsim_add_test(cda
  LIBRARIES
    ncsim::cda
    gmpxx
    gmp
  SOURCES
    collision_test.cpp
    flat_test.cpp
    hull_test.cpp
    intersect_test.cpp
    lattice_test.cpp
    loops_test.cpp
    polytope_test.cpp
    predicates_test.cpp
    shape_test.cpp
    tree_test.cpp
    workpiece_test.cpp)
target_include_directories(ncsim_cda_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/cda/src)
