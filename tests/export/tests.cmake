find_package(nlohmann_json CONFIG REQUIRED)
ncsim_add_test(export
  LIBRARIES ncsim::export ncsim::toolpath nlohmann_json::nlohmann_json
  SOURCES
    apng_test.cpp
    camera_test.cpp
    cut_view_test.cpp
    drawing_test.cpp
    gif_test.cpp
    gltf_test.cpp
    golden_test.cpp
    marks_test.cpp
    palette_test.cpp
    ply_test.cpp
    png_test.cpp
    random_programs_test.cpp
    render_test.cpp
    sheet_test.cpp
    shrink_test.cpp
    step_test.cpp
    stl_test.cpp
    text_test.cpp
    threemf_test.cpp
    vrml_test.cpp
    ../support/box_part.cpp
    ../support/golden.cpp
    ../support/polytope_part.cpp
    ../support/random_programs.cpp
    ../support/read_png.cpp
    ../support/written_mesh.cpp)
find_package(GIF 5 REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
target_include_directories(ncsim_export_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/export/src)
target_link_libraries(ncsim_export_tests PRIVATE GIF::GIF PNG::PNG ZLIB::ZLIB)

# The rasteriser against OpenGL, from EGL without a surface.
find_package(OpenGL REQUIRED COMPONENTS OpenGL EGL)
add_executable(ncsim_opengl_tests
  export/opengl_test.cpp export/opengl/offscreen_egl.cpp)
target_compile_features(ncsim_opengl_tests PRIVATE cxx_std_20)
target_include_directories(ncsim_opengl_tests PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/export
  ${PROJECT_SOURCE_DIR}/lib/export/src)
target_link_libraries(ncsim_opengl_tests PRIVATE ncsim::export GTest::gtest_main ${CMAKE_DL_LIBS}
  ncsim_build_flags)
add_test(NAME export.opengl_sees_the_same COMMAND ncsim_opengl_tests)

# Pictures need no graphics library: the loader lists what comes with the program.
add_test(NAME export.needs_no_opengl
  COMMAND ${CMAKE_COMMAND} -E env LD_TRACE_LOADED_OBJECTS=1 $<TARGET_FILE:ncsim>)
set_tests_properties(export.needs_no_opengl PROPERTIES
  FAIL_REGULAR_EXPRESSION "OSMesa;LLVM;libGL;OpenGL;EGL")

# What ncsim writes is read by programs that nobody here wrote. `write_samples` writes a folder of
# files in all formats, each reader checks the ones it knows. A reader that is not there is a failure.
set(samples ${CMAKE_CURRENT_BINARY_DIR}/export/samples)
add_executable(ncsim_export_samples
  export/write_samples.cpp support/box_part.cpp support/polytope_part.cpp)
target_include_directories(ncsim_export_samples PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_export_samples PRIVATE ncsim::export ncsim_build_flags)
add_test(NAME export.write_samples COMMAND ncsim_export_samples ${samples})
set_tests_properties(export.write_samples PROPERTIES FIXTURES_SETUP export_samples)

# glTF: the validator of the Khronos Group, installed beside the samples as its lock file says.
set(gltf_tools ${CMAKE_CURRENT_BINARY_DIR}/export/gltf)
foreach(file package.json package-lock.json validate.mjs)
  configure_file(export/gltf/${file} ${gltf_tools}/${file} COPYONLY)
endforeach()
add_test(NAME export.install_gltf_validator
  COMMAND npm ci --no-audit --no-fund
  WORKING_DIRECTORY ${gltf_tools})
set_tests_properties(export.install_gltf_validator PROPERTIES
  FIXTURES_SETUP gltf_validator TIMEOUT 300)
add_test(NAME export.gltf_is_valid
  COMMAND node validate.mjs ${samples}
  WORKING_DIRECTORY ${gltf_tools})
set_tests_properties(export.gltf_is_valid PROPERTIES
  FIXTURES_REQUIRED "export_samples;gltf_validator")

# STL and PLY: admesh must find nothing to repair.
foreach(extension stl ply)
  add_test(NAME export.${extension}_needs_no_repair
    COMMAND ${CMAKE_COMMAND} -D SAMPLES=${samples} -D EXTENSION=${extension}
      -P ${CMAKE_CURRENT_SOURCE_DIR}/export/check_meshes.cmake)
  set_tests_properties(export.${extension}_needs_no_repair PROPERTIES
    FIXTURES_REQUIRED export_samples)
endforeach()

# VRML: Coin, the successor of Open Inventor, out of which VRML was made.
find_package(Coin CONFIG REQUIRED)
add_executable(ncsim_read_vrml export/read_vrml.cpp)
target_compile_features(ncsim_read_vrml PRIVATE cxx_std_20)
target_link_libraries(ncsim_read_vrml PRIVATE Coin::Coin)
add_test(NAME export.vrml_is_read_by_coin COMMAND ncsim_read_vrml ${samples})
set_tests_properties(export.vrml_is_read_by_coin PROPERTIES FIXTURES_REQUIRED export_samples)
add_test(NAME export.vrml_with_fixtures_is_read_by_coin
  COMMAND ${CMAKE_COMMAND} -D NCSIM=$<TARGET_FILE:ncsim> -D READER=$<TARGET_FILE:ncsim_read_vrml>
    -D EXAMPLE=${PROJECT_SOURCE_DIR}/examples/rules/fixture-contact/passes.nc
    -D WORK=${CMAKE_CURRENT_BINARY_DIR}/export/vrml_with_fixtures
    -P ${CMAKE_CURRENT_SOURCE_DIR}/export/vrml_with_fixtures.cmake)

# STEP: OpenCASCADE finds valid closed solids. Its package config names no version that can be asked for.
find_package(OpenCASCADE CONFIG REQUIRED)
add_executable(ncsim_read_step export/read_step.cpp)
target_compile_features(ncsim_read_step PRIVATE cxx_std_20)
target_include_directories(ncsim_read_step SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(ncsim_read_step PRIVATE TKernel TKMath TKBRep TKTopAlgo TKPrim TKBO TKMesh
  TKXSBase TKSTEP)
add_test(NAME export.step_is_read_by_opencascade COMMAND ncsim_read_step ${samples})
set_tests_properties(export.step_is_read_by_opencascade PROPERTIES FIXTURES_REQUIRED export_samples)

# 3MF: the library of the 3MF Consortium reads it without warnings, as one closed mesh.
# (Its pkg-config file asks for the static library's libraries too.)
find_library(LIB3MF_LIBRARY 3MF REQUIRED)
find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf REQUIRED)
add_executable(ncsim_read_3mf export/read_3mf.cpp)
target_compile_features(ncsim_read_3mf PRIVATE cxx_std_20)
target_include_directories(ncsim_read_3mf SYSTEM PRIVATE ${LIB3MF_INCLUDE_DIR})
target_link_libraries(ncsim_read_3mf PRIVATE ${LIB3MF_LIBRARY})
add_test(NAME export.3mf_is_read_by_lib3mf COMMAND ncsim_read_3mf ${samples})
set_tests_properties(export.3mf_is_read_by_lib3mf PROPERTIES FIXTURES_REQUIRED export_samples)

# Sections: ezdxf reads DXF, xmllint SVG. Debian's Python, which has its packages.
if(TARGET ncsim)
  find_program(NCSIM_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  add_test(NAME export.sections_are_read_by_ezdxf_and_xmllint
    COMMAND ${CMAKE_COMMAND} -D NCSIM=$<TARGET_FILE:ncsim> -D PYTHON=${NCSIM_PYTHON}
      -D CHECK=${CMAKE_CURRENT_SOURCE_DIR}/export/read_dxf.py
      -D PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/brep/round_trip/plate.nc
      -D WORK=${CMAKE_CURRENT_BINARY_DIR}/export/sections
      -P ${CMAKE_CURRENT_SOURCE_DIR}/export/sections.cmake)
endif()

# What a STEP file says of its solids is what OpenCASCADE finds; names and colours are in its document.
add_executable(ncsim_read_step_properties export/read_step_properties.cpp)
target_compile_features(ncsim_read_step_properties PRIVATE cxx_std_20)
target_include_directories(ncsim_read_step_properties SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(ncsim_read_step_properties PRIVATE TKernel TKMath TKBRep TKTopAlgo TKXSBase TKSTEP
  TKXDESTEP TKXCAF TKLCAF)
if(TARGET ncsim)
  foreach(schema ap242 ap214)
    string(REPLACE "ap214" "AUTOMOTIVE_DESIGN" name ${schema})
    string(REPLACE "ap242" "AP242" name ${name})
    # The bore, a drilled hole, what nobody cut; a block that a slot divides, and its bore.
    foreach(part plate:brep/round_trip/plate.nc:1:LINE_26_27:LINE_31:STOCK pieces:readers/pieces.nc:2:LINE_6:LINE_9:STOCK)
      string(REPLACE ":" ";" part "${part}")
      list(POP_FRONT part of program)
      set(solid ${CMAKE_CURRENT_BINARY_DIR}/export/properties_${of}_${schema}.step)
      add_test(NAME export.write_step_properties_of_${of}_${schema}
        COMMAND ncsim run ${CMAKE_CURRENT_SOURCE_DIR}/${program} -q --step ${solid}
          --step-schema ${schema} --step-attributes)
      set_tests_properties(export.write_step_properties_of_${of}_${schema} PROPERTIES
        FIXTURES_SETUP step_properties_of_${of}_${schema})
      add_test(NAME export.step_properties_of_${of}_are_read_by_opencascade_${schema}
        COMMAND ncsim_read_step_properties ${solid} ${name} ${part})
      set_tests_properties(export.step_properties_of_${of}_are_read_by_opencascade_${schema} PROPERTIES
        FIXTURES_REQUIRED step_properties_of_${of}_${schema})
    endforeach()
  endforeach()
endif()
