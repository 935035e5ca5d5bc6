# The three samples through the whole pipeline, with both models.
if(NCSIM_BUILD_APP)
  ncsim_add_test(samples
    LIBRARIES
      ncsim_app
    SOURCES
      samples_test.cpp)
endif()
