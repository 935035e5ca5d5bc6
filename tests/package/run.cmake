# cmake -DSOURCE=… -DBUILD=… -DWORK=… -DGENERATOR=… -P run.cmake: installs the build, and builds against it a
# project that knows the README alone, and the examples.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${WORK}")
run(${CMAKE_COMMAND} --install "${BUILD}" --prefix "${WORK}/prefix")
run(${CMAKE_COMMAND} -S "${SOURCE}/tests/package" -B "${WORK}/build" -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DNCSIM_README=${SOURCE}/README.md")
run(${CMAKE_COMMAND} --build "${WORK}/build")
run("${WORK}/build/stranger")
if(NOT output MATCHES "^14800 mm3 are left\n.*slot.nc: [a-z ]*: 0 errors")
  message(FATAL_ERROR "the example of the README printed '${output}'")
endif()

# The examples, as a project of their own. expect(<exit code> <pattern> <name> <arguments…>) runs one.
set(examples "${WORK}/examples")
run(${CMAKE_COMMAND} -S "${SOURCE}/examples/cpp" -B "${examples}" -G "${GENERATOR}" -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" -DCMAKE_CXX_FLAGS=-Wall\ -Wextra\ -Werror)
run(${CMAKE_COMMAND} --build "${examples}" --parallel 2)
function(expect code pattern name)
  execute_process(COMMAND "${examples}/${name}" ${ARGN} WORKING_DIRECTORY "${examples}"
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL code OR NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "${name} ${ARGN}: exit code ${result}, not ${code}, or no '${pattern}' in\n${text}")
  endif()
endfunction()
set(simple "${SOURCE}/samples/simple.nc")
expect(0 "^T1: [0-9.]+ mm at feed, [0-9.]+ mm at rapid\n$" read_program ${simple})
expect(2 "cannot be read" read_program none.nc)
expect(0 "^14800 mm3 are left\n$" hulls)
expect(0 "^14800 mm3 are left, with 10 faces\n$" own_model)
expect(0 "cylinder, bore D[0-9.]+, line [0-9]+, T1\n.*plane, stock\n" solid_faces ${simple})
file(WRITE "${examples}/passes.nc" "(T1 D=10. CR=0. - flat end mill)\n(STOCK/BLOCK,40.,30.,10.,20.,15.,10.)\n"
  "G21 G90 G17 (FROM/0.,0.,100.) T1 M6 S1000 M3\nG0 X-30. Y0. Z1.\nG0 X-31.\nG0 Z-2.\nG1 X30. F500.\nG0 Z5.\nM30\n")
expect(1 "passes.nc: clean.*passes.nc:5:1: error: rapid move aside at Z1 .shop-clearance" own_rule passes.nc)
expect(0 "^v [-0-9.]+ [-0-9.]+ [-0-9.]+\n.*\ng line_0\nf [0-9]+ [0-9]+ [0-9]+\n" own_writer ${simple})
run("${WORK}/prefix/bin/ncsim" --version)
