find_package(tinyxml2 9 CONFIG REQUIRED)
find_package(tomlplusplus REQUIRED)
ncsim_add_test(setup
  LIBRARIES ncsim::setup zip tinyxml2::tinyxml2 tomlplusplus::tomlplusplus
  SOURCES
    budget_test.cpp
    digest_test.cpp
    freecad_machine_test.cpp
    fusion_machine_test.cpp
    inputs_test.cpp
    job_test.cpp
    linuxcnc_machine_test.cpp
    mesh_text_test.cpp
    messages_test.cpp
    project_file_test.cpp
    schema_test.cpp
    set_up_files_test.cpp
    set_ups_test.cpp
    three_points_test.cpp
    toml_text_test.cpp
    toml_writer_test.cpp
    tool_library_test.cpp
    urdf_machine_test.cpp)
# The table of messages is private to the library.
target_include_directories(ncsim_setup_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/setup/src)
