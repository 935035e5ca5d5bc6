# The three samples through the whole pipeline, with both models. One test a sample, not one a
# case: the cases share the simulation, which the flat model takes its time for.
if(NCSIM_BUILD_APP)
  add_executable(ncsim_samples_tests samples/samples_test.cpp support/golden.cpp
    support/read_png.cpp)
  target_compile_features(ncsim_samples_tests PRIVATE cxx_std_20)
  target_include_directories(ncsim_samples_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_compile_definitions(ncsim_samples_tests PRIVATE NCSIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(ncsim_samples_tests PRIVATE ncsim_app GTest::gtest_main PNG::PNG ncsim_build_flags)
  foreach(sample simple complex wave)
    add_test(NAME samples.${sample}
      COMMAND ncsim_samples_tests --gtest_filter=*/${sample})
    set_tests_properties(samples.${sample} PROPERTIES TIMEOUT 1200)
  endforeach()
  add_test(NAME samples.faces COMMAND ncsim_samples_tests --gtest_filter=SampleFaces.*)
  # All formats, read back by programs that nobody here wrote.
  add_test(NAME samples.are_read_by_others
    COMMAND node ${CMAKE_CURRENT_SOURCE_DIR}/corpus/check_formats.mjs ${PROJECT_BINARY_DIR}
      ${CMAKE_CURRENT_BINARY_DIR}/samples ${PROJECT_SOURCE_DIR}/samples --limit 300)
  set_tests_properties(samples.are_read_by_others PROPERTIES
    FIXTURES_REQUIRED gltf_validator TIMEOUT 600)
endif()
