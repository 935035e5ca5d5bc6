ncsim_add_test(gcode
  LIBRARIES ncsim::gcode ncsim::trig
  SOURCES
    area_cycles_test.cpp
    codes_test.cpp
    control_codes_test.cpp
    control_table_test.cpp
    controls_test.cpp
    corpus_test.cpp
    dialect_test.cpp
    expression_test.cpp
    file_programs_test.cpp
    head_modes_test.cpp
    klartext_plane_test.cpp
    klartext_approach_test.cpp
    klartext_cycles_test.cpp
    klartext_paths_test.cpp
    klartext_test.cpp
    sinumerik_cycles_test.cpp
    sinumerik_flow_test.cpp
    sinumerik_frames_test.cpp
    sinumerik_test.cpp
    language_changes_test.cpp
    messages_test.cpp
    mode_pairs_test.cpp
    modes_left_on_test.cpp
    parser_test.cpp
    path_cycles_test.cpp
    program_text_test.cpp
    redundant_words_test.cpp
    refused_block_test.cpp
    rs274_test.cpp
    state_test.cpp
    symmetry_test.cpp
    tilted_plane_test.cpp
    tip_control_test.cpp)
# The table of codes is private to the library.
target_include_directories(ncsim_gcode_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/gcode/src)
