# What takes long; ./dev nightly runs it. Here a little of it.
find_package(nlohmann_json CONFIG REQUIRED)
add_executable(nightly nightly/nightly.cpp support/random_programs.cpp support/written_mesh.cpp)
target_compile_features(nightly PRIVATE cxx_std_20)
target_include_directories(nightly PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(nightly PRIVATE ncsim::export ncsim::toolpath nlohmann_json::nlohmann_json
  ncsim_build_flags)
add_test(NAME nightly.RunsTwoHundredScenes COMMAND nightly 200)

add_executable(nightly_models nightly/models.cpp)
target_compile_definitions(nightly_models PRIVATE NCSIM_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
target_link_libraries(nightly_models PRIVATE ncsim_nef ncsim_build_flags)
add_test(NAME nightly.LooksAtThreeHundredPartsOfRays COMMAND nightly_models rays 300)
add_test(NAME nightly.LooksAtPointsOfPartsOfRays COMMAND nightly_models points 100000)

# The oracle for programs, which knows nothing of ncsim.
set(oracle
  closest_approach.cpp
  course.cpp
  judge.cpp
  nc_writer.cpp
  program_generator.cpp
  round_tool.cpp
  surface.cpp)
ncsim_add_test(nightly
  SOURCES
    ${oracle}
    closest_approach_test.cpp
    course_test.cpp
    judge_test.cpp
    nc_writer_test.cpp
    program_generator_test.cpp
    round_tool_test.cpp
    surface_test.cpp)

if(TARGET ncsim)
  list(TRANSFORM oracle PREPEND nightly/)
  add_executable(nightly_programs nightly/programs.cpp nightly/examine.cpp nightly/simulated.cpp
    ${oracle})
  target_compile_features(nightly_programs PRIVATE cxx_std_20)
  target_include_directories(nightly_programs PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(nightly_programs PRIVATE ncsim_app ncsim_build_flags)
  add_test(NAME nightly.RunsThirtyPrograms COMMAND nightly_programs 30)
  # A long slot mill with rounded corners that turns: slabs of it gained three times what was told.
  add_test(NAME nightly.RunsALongToolThatTurns COMMAND nightly_programs 1 403224)
  add_test(NAME nightly.RunsTenProgramsThatTurn COMMAND nightly_programs --turning 10)
endif()
