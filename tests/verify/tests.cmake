ncsim_add_test(verify LIBRARIES ncsim::verify SOURCES rules_test.cpp verified.cpp)
