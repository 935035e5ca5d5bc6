ncsim_add_test(verify
  LIBRARIES
    ncsim::verify
  SOURCES
    body_test.cpp
    books_test.cpp
    contact_test.cpp
    cycle_time_test.cpp
    design_test.cpp
    evidence_test.cpp
    finding_fields_test.cpp
    fixture_test.cpp
    guesses_test.cpp
    hole_course_test.cpp
    machine_scene_test.cpp
    machine_test.cpp
    machining_time_test.cpp
    passes_test.cpp
    path_facts_test.cpp
    process_test.cpp
    rapid_test.cpp
    rigid_body_test.cpp
    rule_limits_test.cpp
    selection_test.cpp
    solids_test.cpp
    step_measurement_test.cpp
    tables_test.cpp
    tool_monitors_test.cpp
    totals_test.cpp
    travel_test.cpp
    verified.cpp)
target_include_directories(ncsim_verify_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/verify/src)

# JSON and SARIF: validated against their schemas, with what the lock file names.
if(TARGET ncsim)
  set(schema_tools ${CMAKE_CURRENT_BINARY_DIR}/verify/schemas)
  foreach(file package.json package-lock.json validate.mjs)
    configure_file(verify/schemas/${file} ${schema_tools}/${file} COPYONLY)
  endforeach()
  add_test(NAME verify.install_schema_validator
    COMMAND npm ci --no-audit --no-fund
    WORKING_DIRECTORY ${schema_tools})
  set_tests_properties(verify.install_schema_validator PROPERTIES
    FIXTURES_SETUP schema_validator TIMEOUT 300)
  add_test(NAME verify.json_and_sarif_are_valid
    COMMAND node validate.mjs $<TARGET_FILE:ncsim> ${PROJECT_SOURCE_DIR}
    WORKING_DIRECTORY ${schema_tools})
  set_tests_properties(verify.json_and_sarif_are_valid PROPERTIES
    FIXTURES_REQUIRED schema_validator)
endif()
