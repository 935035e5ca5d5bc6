# cmake -D WRITER=<program> -D FOLDER=<folder> -P check_threads.cmake: the samples have the same bytes
# whether llvmpipe draws with none, one or several threads.
foreach(threads 0 1 4)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env LP_NUM_THREADS=${threads} ${WRITER} ${FOLDER}/${threads}
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "the samples cannot be written with ${threads} threads")
  endif()
endforeach()

file(GLOB files RELATIVE ${FOLDER}/0 ${FOLDER}/0/*)
if(NOT files)
  message(FATAL_ERROR "no files in ${FOLDER}/0")
endif()
foreach(file ${files})
  file(SHA256 ${FOLDER}/0/${file} expected)
  foreach(threads 1 4)
    file(SHA256 ${FOLDER}/${threads}/${file} found)
    if(NOT found STREQUAL expected)
      message(FATAL_ERROR "${file} differs with ${threads} threads")
    endif()
  endforeach()
endforeach()
