find_package(nlohmann_json CONFIG REQUIRED)
ncsim_add_test(base
  LIBRARIES ncsim::base nlohmann_json::nlohmann_json
  SOURCES
    angles_test.cpp
    disjoint_sets_test.cpp
    mix_test.cpp
    parallel_test.cpp
    plain_text_test.cpp
    text_test.cpp
    vec2_test.cpp)

# Nobody else calls functions of the C library whose last bit is not the same everywhere.
add_test(NAME base.TheLibraryOfNoSystemReachesAnOutput
  COMMAND ${CMAKE_COMMAND} -DSOURCE=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_LIST_DIR}/libm.cmake)
