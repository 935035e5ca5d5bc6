ncsim_add_test(verify
  LIBRARIES
    ncsim::verify
  SOURCES
    cycle_time_test.cpp
    rules_test.cpp
    verified.cpp)
