# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D NCSIM=… -D READER=… -D EXAMPLE=… -D WORK=… -P vrml_with_fixtures.cmake: Coin finds the volumes of the part and
# of its fixture, a jaw of 120 x 15 x 30 mm.
function(make)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${out}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/with ${WORK}/without)
make(${NCSIM} run ${EXAMPLE} -q --vrml ${WORK}/without/part.wrl --report ${WORK}/part.json)
make(${NCSIM} run ${EXAMPLE} -q --show-fixtures --vrml ${WORK}/with/part.wrl)
file(READ ${WORK}/part.json report)
string(JSON part GET ${report} volume_mm3 part)
string(REGEX REPLACE "\\.0$" "" part ${part})
math(EXPR both "${part} + 120 * 15 * 30")
file(WRITE ${WORK}/without/part.expect "volume ${part}\nlines 0 7\n")
file(WRITE ${WORK}/with/part.expect "volume ${both}\nlines 0 7\n")
make(${READER} ${WORK}/without)
make(${READER} ${WORK}/with)
