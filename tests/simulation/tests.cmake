ncsim_add_test(simulation
  LIBRARIES ncsim::simulation
  SOURCES
    simulation_test.cpp)
