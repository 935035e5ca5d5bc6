# SPDX-License-Identifier: GPL-3.0-or-later
#
# cmake -D NCSIM=… -D MESH_STEP=… -D PROGRAM=… -D WORK=… -P round_trip.cmake: the solid of a program, as a mesh, is the
# design of that program, within what round tools (0.05 mm), chords (0.005 mm) and the mesh (0.01 mm) are off.
function(make)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${code}\n${out}")
  endif()
endfunction()

# Whether all else is proven is not asked here.
function(compare program words)
  execute_process(COMMAND ${NCSIM} check ${program} --design ${WORK}/part.stl --design-tol 0.065
    OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT out MATCHES "${words}")
    message(FATAL_ERROR "${program}: not '${words}'\n${out}")
  endif()
endfunction()

file(MAKE_DIRECTORY ${WORK})
make(${NCSIM} run ${PROGRAM} -q --step ${WORK}/part.step)
make(${MESH_STEP} ${WORK}/part.step ${WORK}/part.stl 0.01)
compare(${PROGRAM} "within 0.065 mm: nothing beyond")

# Of what cuts one slot a tenth deeper it is not the design.
file(READ ${PROGRAM} deeper)
string(REPLACE "G1 Z-5.\n" "G1 Z-5.1\n" deeper "${deeper}")
file(WRITE ${WORK}/deeper.nc "${deeper}")
compare(${WORK}/deeper.nc "gouged in 1 place, up to 0.1")
