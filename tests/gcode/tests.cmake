ncsim_add_test(gcode
  LIBRARIES ncsim::gcode
  SOURCES
    parser_test.cpp)
