# Tests of the Python package in ${PROJECT_BINARY_DIR}/python, by the Python it was built for.
set(python_environment
  PYTHONPATH=${PROJECT_BINARY_DIR}/python NCSIM=$<TARGET_FILE:ncsim> PYTHONDONTWRITEBYTECODE=1)
# ncsim_add_python_test(<name> <script> <arguments…>): exit code 77 skips the test.
function(ncsim_add_python_test name)
  add_test(NAME python.${name} COMMAND ${NCSIM_PYTHON_EXECUTABLE} ${ARGN})
  set_tests_properties(python.${name} PROPERTIES ENVIRONMENT "${python_environment}"
    SKIP_RETURN_CODE 77 TIMEOUT 300)
endfunction()

foreach(suite Part Arrays SolidAndMeasures Verdicts Errors Threads Jobs Interface)
  ncsim_add_python_test(${suite} ${CMAKE_CURRENT_SOURCE_DIR}/python/ncsim_test.py ${suite})
endforeach()

# The types of the examples only at night: mypy takes as long for them as for the package.
set(typed_examples "")
if(NCSIM_NIGHTLY_TESTS)
  set(typed_examples ${PROJECT_SOURCE_DIR}/examples/python)
endif()
ncsim_add_python_test(types ${CMAKE_CURRENT_SOURCE_DIR}/python/types_test.py
  ${PROJECT_BINARY_DIR}/python ${CMAKE_CURRENT_BINARY_DIR}/python ${typed_examples})
ncsim_add_python_test(docs ${CMAKE_CURRENT_SOURCE_DIR}/python/docs_test.py)
ncsim_add_python_test(examples ${CMAKE_CURRENT_SOURCE_DIR}/python/examples_test.py)
