# cmake -D SAMPLES=<folder> -P check_stl.cmake: admesh finds nothing to repair in any .stl, and the
# volume that the .expect file beside it names. An empty part is left out: admesh does not read a
# file without triangles.
find_program(ADMESH admesh)
if(NOT ADMESH)
  message(FATAL_ERROR "admesh is needed to check STL files")
endif()

file(GLOB files ${SAMPLES}/*.stl)
list(FILTER files EXCLUDE REGEX "/vanished.stl$")
if(NOT files)
  message(FATAL_ERROR "no .stl files in ${SAMPLES}")
endif()

foreach(file ${files})
  execute_process(COMMAND ${ADMESH} ${file} OUTPUT_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "admesh cannot read ${file}:\n${output}")
  endif()
  foreach(nothing "Total disconnected facets" "Degenerate facets" "Edges fixed" "Facets removed"
                  "Facets added" "Facets reversed" "Backwards edges" "Normals fixed")
    if(NOT output MATCHES "${nothing} *: *0[^0-9.]")
      # The two columns of disconnected facets: the second number counts.
      if(NOT output MATCHES "${nothing} *: *0 +0")
        message(FATAL_ERROR "${file}: ${nothing}:\n${output}")
      endif()
    endif()
  endforeach()
  string(REGEX MATCH "Volume *: *([0-9.]+)" found "${output}")
  set(volume ${CMAKE_MATCH_1})
  string(REGEX REPLACE ".stl$" ".expect" expect_file ${file})
  file(STRINGS ${expect_file} expected REGEX "^volume")
  string(REGEX REPLACE "volume ([0-9]+).*" "\\1" expected "${expected}")
  string(REGEX REPLACE "([0-9]+).*" "\\1" volume "${volume}")
  # In whole mm³ (CMake has no other numbers), to a part in ten thousand and one for the cut-off digits.
  math(EXPR difference "(${volume} - ${expected}) * 10000")
  string(REPLACE "-" "" difference "${difference}")
  math(EXPR allowed "${expected} + 10000")
  if(difference GREATER allowed)
    message(FATAL_ERROR "${file}: volume ${volume}, not ${expected}")
  endif()
  message(STATUS "${file}: closed, ${volume} mm³")
endforeach()
