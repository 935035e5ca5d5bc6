ncsim_add_test(setup
  LIBRARIES ncsim::setup
  SOURCES
    budget_test.cpp
    digest_test.cpp
    job_test.cpp)
