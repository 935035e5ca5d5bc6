ncsim_add_test(simulation
  LIBRARIES ncsim::simulation
  SOURCES
    cut_record_test.cpp
    deviation_mesh_test.cpp
    messages_test.cpp
    models_test.cpp
    motions_test.cpp
    operations_test.cpp
    orientation_test.cpp
    shading_test.cpp
    simulation_test.cpp
    solid_test.cpp
    upright_runs_test.cpp)
# The table of messages and the runs are private to the library.
target_include_directories(ncsim_simulation_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/simulation/src)
