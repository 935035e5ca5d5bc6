find_package(nlohmann_json CONFIG REQUIRED)
find_package(ZLIB REQUIRED)
ncsim_add_test(report
  LIBRARIES ncsim::report nlohmann_json::nlohmann_json ZLIB::ZLIB
  SOURCES
    baseline_test.cpp
    descriptions_test.cpp
    length_unit_test.cpp
    line_diff_test.cpp
    motion_json_test.cpp
    operations_test.cpp
    page_arrays_test.cpp
    page_index_test.cpp
    page_test.cpp
    program_diff_test.cpp
    review_page_test.cpp
    scope_test.cpp
    shard_test.cpp
    sheets_test.cpp
    text_parts_test.cpp
    tile_file_test.cpp
    verdict_formats_test.cpp)
target_include_directories(ncsim_report_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/report/src)
