# cmake -D SAMPLES=<folder> -D EXTENSION=<stl or ply> -P check_meshes.cmake: admesh finds nothing to repair
# in any file with this extension, and the volume that the .expect file beside it names. PLY is
# read by assimp first and handed on as STL. An empty part is left out: neither program reads
# a file without triangles.
foreach(program admesh assimp)
  find_program(${program}_program ${program})
  if(NOT ${program}_program)
    message(FATAL_ERROR "${program} is needed to check the files")
  endif()
endforeach()

file(GLOB files ${SAMPLES}/*.${EXTENSION})
list(FILTER files EXCLUDE REGEX "/vanished.${EXTENSION}$")
# On its way through STL as assimp writes it, surfaces that touch become one.
list(FILTER files EXCLUDE REGEX "/notched.ply$")
if(NOT files)
  message(FATAL_ERROR "no .${EXTENSION} files in ${SAMPLES}")
endif()

foreach(file ${files})
  set(stl ${file})
  if(NOT EXTENSION STREQUAL "stl")
    set(stl ${file}.read.stl_)  # no .stl, or it would be taken for one of ours
    execute_process(COMMAND ${assimp_program} export ${file} ${stl} -fstlb
      OUTPUT_VARIABLE output RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
      message(FATAL_ERROR "assimp cannot read ${file}:\n${output}")
    endif()
  endif()
  execute_process(COMMAND ${admesh_program} ${stl} OUTPUT_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "admesh cannot read ${file}:\n${output}")
  endif()
  set(repairs "Total disconnected facets" "Degenerate facets" "Edges fixed" "Facets removed"
    "Facets added" "Facets reversed" "Backwards edges")
  if(EXTENSION STREQUAL "stl")
    list(APPEND repairs "Normals fixed")  # PLY has none: they would be those of assimp
  endif()
  foreach(nothing ${repairs})
    if(NOT output MATCHES "${nothing} *: *0[^0-9.]")
      # The two columns of disconnected facets: the second number counts.
      if(NOT output MATCHES "${nothing} *: *0 +0")
        message(FATAL_ERROR "${file}: ${nothing}:\n${output}")
      endif()
    endif()
  endforeach()
  string(REGEX MATCH "Volume *: *([0-9.]+)" found "${output}")
  set(volume ${CMAKE_MATCH_1})
  string(REGEX REPLACE ".${EXTENSION}$" ".expect" expect_file ${file})
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
