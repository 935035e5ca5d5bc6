ncsim_add_test(toolpath
  LIBRARIES ncsim::toolpath
  SOURCES
    axis_path_test.cpp
    comment_text_test.cpp
    joint_path_test.cpp
    kinematics_test.cpp
    machine_test.cpp
    limits_test.cpp
    messages_test.cpp
    operation_name_test.cpp
    path_pieces_test.cpp
    ring_polygon_test.cpp
    sampler_test.cpp
    spline_arcs_test.cpp
    stock_test.cpp
    tool_comment_test.cpp
    tool_drawings_test.cpp
    tool_values_test.cpp
    tool_file_test.cpp
    tool_remark_test.cpp
    tool_shape_test.cpp
    tool_spec_test.cpp
    tool_words_test.cpp
    tool_polytope_test.cpp
    tool_table_test.cpp
    tool_test.cpp
    trace_test.cpp
    rotation_bounds_test.cpp
    walk_test.cpp)
# The table of messages is private to the library.
target_include_directories(ncsim_toolpath_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/toolpath/src)
