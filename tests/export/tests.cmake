ncsim_add_test(export
  LIBRARIES ncsim::export
  SOURCES
    camera_test.cpp
    png_test.cpp
    stl_test.cpp
    text_test.cpp)
find_package(PNG REQUIRED)
target_include_directories(ncsim_export_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/export/src)
target_link_libraries(ncsim_export_tests PRIVATE PNG::PNG)
