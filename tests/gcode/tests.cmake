ncsim_add_test(gcode
  LIBRARIES ncsim::gcode
  SOURCES
    corpus_test.cpp
    parser_test.cpp)
