# The program as its users meet it: command, exit code, both streams.
if(TARGET ncsim)
  find_package(OpenCASCADE CONFIG REQUIRED)
  add_executable(ncsim_write_step_cases setup/write_step_cases.cpp)
  target_compile_features(ncsim_write_step_cases PRIVATE cxx_std_20)
  target_include_directories(ncsim_write_step_cases SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
  target_link_libraries(ncsim_write_step_cases PRIVATE TKernel TKMath TKBRep TKTopAlgo TKPrim TKXSBase
    TKSTEP)
  find_package(fmt CONFIG REQUIRED)
  find_package(nlohmann_json CONFIG REQUIRED)
  find_package(PNG REQUIRED)
  find_package(TinyGLTF 2.7 CONFIG REQUIRED)
  ncsim_add_test(cli
    LIBRARIES ncsim_app PNG::PNG nlohmann_json::nlohmann_json fmt::fmt TinyGLTF::TinyGLTF
    SOURCES
      bad_input_test.cpp
      baseline_test.cpp
      check_test.cpp
      check_tiles_test.cpp
      colour_test.cpp
      diff_test.cpp
      doubts_test.cpp
      draft_test.cpp
      explain_test.cpp
      file_programs_test.cpp
      files_test.cpp
      folders_test.cpp
      full_disk_test.cpp
      hostile_text_test.cpp
      in_order_test.cpp
      init_test.cpp
      language_bytes_test.cpp
      isolate_test.cpp
      job_test.cpp
      large_pages_test.cpp
      machine_command_test.cpp
      machine_mesh_test.cpp
      machine_test.cpp
      measure_test.cpp
      moving_machine_test.cpp
      mpi_test.cpp
      options_test.cpp
      output_test.cpp
      parse_test.cpp
      picture_test.cpp
      project_test.cpp
      provenance_test.cpp
      quiet_test.cpp
      rays_test.cpp
      report_units_test.cpp
      review_test.cpp
      rotary_test.cpp
      rule_examples_test.cpp
      run_program.cpp
      run_test.cpp
      samples_test.cpp
      set_ups_test.cpp
      shading_test.cpp
      shards_test.cpp
      solid_test.cpp
      step_input_test.cpp
      stock_history_test.cpp
      tile_meshes_test.cpp
      tiles_test.cpp
      tools_test.cpp
      triples_test.cpp
      verdicts_test.cpp
      watch_test.cpp
      ../support/read_png.cpp
      ../support/random_programs.cpp
      ../support/set_up_blocks.cpp
      ../support/set_up_draft.cpp
      ../support/set_up_features.cpp
      ../support/set_up_layout.cpp
      ../support/set_up_tools.cpp
      ../support/set_ups.cpp
      ../support/written_mesh.cpp)
  target_compile_definitions(ncsim_cli_tests PRIVATE NCSIM_PROGRAM="$<TARGET_FILE:ncsim>")
  add_dependencies(ncsim_cli_tests ncsim ncsim_step ncsim_write_step_cases)
  if(TARGET ncsim_mpi)
    target_compile_definitions(ncsim_cli_tests PRIVATE
      NCSIM_MPI_PROGRAM="$<TARGET_FILE:ncsim_mpi>")
    add_dependencies(ncsim_cli_tests ncsim_mpi)
  endif()
  target_compile_definitions(ncsim_cli_tests PRIVATE
    NCSIM_WRITE_STEP_CASES="$<TARGET_FILE:ncsim_write_step_cases>")
endif()

# Pages, used in a browser as their readers do, and read without a browser.
if(TARGET ncsim)
  find_program(NCSIM_CHROMIUM chromium)
  set(page_tools ${CMAKE_CURRENT_BINARY_DIR}/cli/page)
  foreach(file package.json package-lock.json reader.mjs page.mjs arrays.mjs index.mjs
      review.mjs shots.mjs bars.mjs)
    configure_file(cli/page/${file} ${page_tools}/${file} COPYONLY)
  endforeach()
  add_test(NAME cli.install_browser_driver
    COMMAND npm ci --no-audit --no-fund
    WORKING_DIRECTORY ${page_tools})
  set_tests_properties(cli.install_browser_driver PROPERTIES
    FIXTURES_SETUP browser_driver TIMEOUT 300)
  add_test(NAME cli.a_click_on_a_face_selects_its_line
    COMMAND node page.mjs $<TARGET_FILE:ncsim> ${NCSIM_CHROMIUM} ${PROJECT_SOURCE_DIR}/samples
    WORKING_DIRECTORY ${page_tools})
  set_tests_properties(cli.a_click_on_a_face_selects_its_line PROPERTIES
    FIXTURES_REQUIRED browser_driver TIMEOUT 300)
  add_test(NAME cli.an_index_of_pages_is_sorted_and_searched
    COMMAND node index.mjs $<TARGET_FILE:ncsim> ${NCSIM_CHROMIUM}
    WORKING_DIRECTORY ${page_tools})
  set_tests_properties(cli.an_index_of_pages_is_sorted_and_searched PROPERTIES
    FIXTURES_REQUIRED browser_driver TIMEOUT 300)
  add_test(NAME cli.a_review_shows_what_differs
    COMMAND node review.mjs $<TARGET_FILE:ncsim> ${NCSIM_CHROMIUM}
    WORKING_DIRECTORY ${page_tools})
  set_tests_properties(cli.a_review_shows_what_differs PROPERTIES
    FIXTURES_REQUIRED browser_driver TIMEOUT 300)
  # The browser draws with both processors of a small machine; with one, it misses its time limits.
  set_tests_properties(cli.a_click_on_a_face_selects_its_line
    cli.an_index_of_pages_is_sorted_and_searched cli.a_review_shows_what_differs
    PROPERTIES PROCESSORS 2)
  # Pictures of the documentation take half a minute; cost of large pages takes minutes.
  if(NCSIM_NIGHTLY_TESTS)
    add_test(NAME cli.commands_of_docs_make_their_pictures_of_pages
      COMMAND node shots.mjs $<TARGET_FILE:ncsim> ${NCSIM_CHROMIUM} ${PROJECT_SOURCE_DIR}
        ${page_tools}/shots
      WORKING_DIRECTORY ${page_tools})
    set_tests_properties(cli.commands_of_docs_make_their_pictures_of_pages PROPERTIES
      FIXTURES_REQUIRED browser_driver TIMEOUT 300)
    add_test(NAME cli.pages_cost_no_more_than_documented
      COMMAND node bars.mjs $<TARGET_FILE:ncsim> ${NCSIM_CHROMIUM} ${PROJECT_SOURCE_DIR}/samples
      WORKING_DIRECTORY ${page_tools})
    set_tests_properties(cli.pages_cost_no_more_than_documented PROPERTIES
      FIXTURES_REQUIRED browser_driver RUN_SERIAL ON TIMEOUT 1200)
  endif()
  add_test(NAME cli.states_of_a_page_have_the_volume_of_the_part
    COMMAND node arrays.mjs $<TARGET_FILE:ncsim> ${PROJECT_SOURCE_DIR}/samples
    WORKING_DIRECTORY ${page_tools})
endif()
