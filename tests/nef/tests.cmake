# Boundary evaluation with exact numbers, an oracle. It sees CGAL, and is compiled apart as lib/cda does.
find_package(CGAL 5.5 CONFIG REQUIRED)
add_library(ncsim_nef STATIC nef/nef_part.cpp nef/agreement.cpp)
target_compile_features(ncsim_nef PUBLIC cxx_std_20)
target_include_directories(ncsim_nef PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_nef PUBLIC ncsim::simulation PRIVATE CGAL::CGAL ncsim_build_flags
  ncsim_cgal_flags)
set_source_files_properties(nef/nef_part.cpp PROPERTIES COMPILE_OPTIONS "-O1")
ncsim_add_test(nef LIBRARIES ncsim_nef SOURCES nef_test.cpp)
