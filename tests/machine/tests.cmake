ncsim_add_test(machine
  LIBRARIES ncsim::machine
  SOURCES
    chain_test.cpp
    inverse_test.cpp
    orient_test.cpp
    relative_test.cpp)
