ncsim_add_test(mesh
  LIBRARIES ncsim::mesh ncsim::export
  SOURCES
    float_mesh_test.cpp
    merge_faces_test.cpp
    open_mesh_test.cpp
    simplify_test.cpp
    slivers_test.cpp
    ../support/box_part.cpp
    ../support/polytope_part.cpp
    ../support/written_mesh.cpp)
target_include_directories(ncsim_mesh_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/mesh/src)
