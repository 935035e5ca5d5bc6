ncsim_add_test(toolpath
  LIBRARIES ncsim::toolpath ncsim::trig
  SOURCES
    machine_test.cpp
    sampler_test.cpp
    stock_test.cpp
    tool_comment_test.cpp
    tool_file_test.cpp
    tool_polytope_test.cpp
    tool_table_test.cpp
    tool_test.cpp
    trace_test.cpp
    turning_test.cpp)
