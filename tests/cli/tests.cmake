# The program as its users meet it: command, exit code, both streams.
if(TARGET ncsim)
  find_package(nlohmann_json CONFIG REQUIRED)
  ncsim_add_test(cli
    LIBRARIES ncsim_app nlohmann_json::nlohmann_json
    SOURCES
      bad_input_test.cpp
      check_test.cpp
      diff_test.cpp
      options_test.cpp
      output_test.cpp
      parse_test.cpp
      run_program.cpp
      run_test.cpp
      samples_test.cpp
      tools_test.cpp)
  target_compile_definitions(ncsim_cli_tests PRIVATE NCSIM_PROGRAM="$<TARGET_FILE:ncsim>")
  add_dependencies(ncsim_cli_tests ncsim)
endif()
