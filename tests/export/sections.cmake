# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D NCSIM=… -D PYTHON=… -D CHECK=… -D PROGRAM=… -D WORK=… -P sections.cmake: sections of a program are read by
# programs that nobody here wrote, each with the outlines and the area that the report tells.
function(make)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${out}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK})
# Through floors (z=-3, z=-4), slopes, balls and rings.
foreach(plane z=-0.7 z=-2 z=-3 z=-4 z=-11 x=30 x=22.3 x=60 y=20 y=50 y=77.9 z=5)
  make(${NCSIM} run ${PROGRAM} -q --section ${plane} --dxf ${WORK}/${plane}.dxf --svg ${WORK}/${plane}.svg
    --report ${WORK}/${plane}.json)
  make(xmllint --noout ${WORK}/${plane}.svg)
  make(${PYTHON} ${CHECK} ${WORK}/${plane}.dxf ${WORK}/${plane}.json)
endforeach()
make(${NCSIM} run ${PROGRAM} -q --section z=-2 --section x=30 --section y=20 --dxf ${WORK}/all.dxf
  --svg ${WORK}/all.svg --report ${WORK}/all.json)
make(xmllint --noout ${WORK}/all.svg)
make(${PYTHON} ${CHECK} ${WORK}/all.dxf ${WORK}/all.json)
