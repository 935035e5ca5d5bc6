# cmake -DSOURCE=… -DBUILD=… -DWORK=… -DGENERATOR=… -P run.cmake: installs the build and builds a stranger's project against it.
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
if(NOT output MATCHES "14800")
  message(FATAL_ERROR "the example of the README printed '${output}'")
endif()
run("${WORK}/prefix/bin/ncsim" --version)
