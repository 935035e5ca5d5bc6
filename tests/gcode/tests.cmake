ncsim_add_test(gcode
  LIBRARIES ncsim::gcode
  SOURCES
    corpus_test.cpp
    dialect_test.cpp
    expression_test.cpp
    parser_test.cpp)
