find_package(fmt CONFIG REQUIRED)
ncsim_add_test(brep
  LIBRARIES ncsim::simulation fmt::fmt-header-only
  SOURCES
    cam_parts.cpp
    envelope_parts_test.cpp
    envelope_test.cpp
    features_test.cpp
    flat_part_test.cpp
    geometry_test.cpp
    golden_test.cpp
    groove_parts.cpp
    made_part.cpp
    mass_test.cpp
    order_test.cpp
    parameter_curve_test.cpp
    part_check_test.cpp
    ramps_test.cpp
    random_parts.cpp
    recognise_steps_test.cpp
    recognise_test.cpp
    rounding_test.cpp
    section_test.cpp
    slot_parts.cpp
    solids.cpp
    surface_forms_test.cpp
    surface_text_test.cpp
    surfaces_test.cpp
    swept_surfaces_test.cpp
    tilted_parts.cpp
    topology_test.cpp
    vertex_distance_test.cpp)

target_include_directories(ncsim_brep_tests PRIVATE ${PROJECT_SOURCE_DIR}/lib/brep/src)

add_test(NAME brep.tolerances_are_factors_of_one_header COMMAND ${CMAKE_COMMAND}
  -DSOURCE=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_LIST_DIR}/constants.cmake)

# OpenCASCADE judges them, too (export/tests.cmake has its reader).
set(solids ${CMAKE_CURRENT_BINARY_DIR}/brep/solids)
add_executable(ncsim_brep_solids brep/write_solids.cpp brep/solids.cpp)
target_include_directories(ncsim_brep_solids PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_brep_solids PRIVATE ncsim::brep ncsim::export ncsim_build_flags)
add_test(NAME brep.write_solids COMMAND ncsim_brep_solids ${solids})
set_tests_properties(brep.write_solids PROPERTIES FIXTURES_SETUP brep_solids)
add_test(NAME brep.solids_are_read_by_opencascade COMMAND ncsim_read_step ${solids} --booleans)
set_tests_properties(brep.solids_are_read_by_opencascade PROPERTIES FIXTURES_REQUIRED brep_solids)

# Parts of random programs likewise; more of them by hand: ncsim_brep_random <folder> 1000.
#
# ncsim_judge_parts(<name> [<count> <first seed> | [--faceted] --seeds <seeds…>] [NIGHTLY <seeds…>]):
# by day half of a count, and no seeds after NIGHTLY, which take OpenCASCADE 4 s and more each.
add_executable(ncsim_brep_random brep/write_random_parts.cpp brep/cam_parts.cpp
  brep/groove_parts.cpp brep/random_parts.cpp brep/slot_parts.cpp brep/tilted_parts.cpp)
target_include_directories(ncsim_brep_random PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(ncsim_brep_random PRIVATE ncsim::simulation fmt::fmt-header-only
  ncsim_build_flags)
function(ncsim_judge_parts name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "NIGHTLY")
  set(parts ${arg_UNPARSED_ARGUMENTS})
  if(NCSIM_NIGHTLY_TESTS)
    list(APPEND parts ${arg_NIGHTLY})
  elseif(NOT "--seeds" IN_LIST parts)
    list(POP_FRONT parts count)
    math(EXPR count "${count} / 2")
    list(PREPEND parts ${count})
  endif()
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/brep/${name})
  file(REMOVE_RECURSE ${folder})
  add_test(NAME brep.write_${name} COMMAND ncsim_brep_random ${folder} ${parts})
  set_tests_properties(brep.write_${name} PROPERTIES FIXTURES_SETUP brep_${name})
  set(strictness)
  if(name MATCHES "^slots|^lenses")
    list(APPEND strictness --fine)
  endif()
  if(name MATCHES "balls|rasters|booleans")
    list(APPEND strictness --booleans)
  endif()
  add_test(NAME brep.${name}_are_read_by_opencascade COMMAND ncsim_read_step ${folder} ${strictness})
  set_tests_properties(brep.${name}_are_read_by_opencascade PROPERTIES
    FIXTURES_REQUIRED brep_${name})
endfunction()
ncsim_judge_parts(random_parts 24)
ncsim_judge_parts(parts_with_helices 8 1000000)
# Finishing by a ball.
ncsim_judge_parts(rasters 24 2000000)
# Slopes and helices by balls and bull noses.
ncsim_judge_parts(parts_with_slopes 12 4000000)
# Balls that turn.
ncsim_judge_parts(parts_of_turning_balls 12 5000000)
# End mills that turn and cut with their sides.
ncsim_judge_parts(parts_of_turning_sides 12 6000000)
# As CAM systems write them.
ncsim_judge_parts(cam_parts 24 7000000)
# The same askew, rounded again.
ncsim_judge_parts(turned_cam_parts 24 8000000)
# Slots at any angle with numbers of three to six decimals, in inches, too, by tools from 0.1 mm. All
# of these seeds were once invalid, because arcs that are tangent but for rounding crossed beside
# their corner, or had a plane of which nothing was drawn at one deflection or another.
ncsim_judge_parts(slots 12 9000000)
# Vertical lead-in arcs, grooves and rings around bars, helices, grooves that cross.
ncsim_judge_parts(grooves --seeds 10000201 10000202 10000203 10000205 10000207 10000208 10000210
  10000211 10000214 10000215 NIGHTLY 10000200 10000204 10000206 10000209 10000212 10000213)
ncsim_judge_parts(slots_that_were_faulty
  --seeds 9000019 9000020 9000025 9000049 9000050 9000052 9000106 9000113 9000121 9000140 9000155
  9000338)
# Arcs that miss their corners by rounding. Most of these had complaints before Booleans; 9611053,
# 9611126 and 9611164 were cut in two empty parts where edges were off their walls along their length.
ncsim_judge_parts(slots_for_booleans --seeds 9611001 9611003 9611008 9611013 9611053 9611126 9611164)
# Edges whose largest distance from a surface is between the places that OpenCASCADE measures: of
# walls that programs round, of envelopes, and of ramps whose floor is half of a circle in the file.
ncsim_judge_parts(edges_for_booleans --seeds 1913002 1913016 4913016 4913017)
# Facets beside a few true surfaces that were nearly as far off these as they are wide. Without the
# surfaces, readers find all edges, and there are hardly more faces.
ncsim_judge_parts(facets_for_booleans --seeds 2925000 6925010 6925012)
# A face of a cone between an arc and a spline, 0.0085 mm wide, of which nothing was drawn.
ncsim_judge_parts(lenses --seeds 7712002)
# Tools and parts that lean on machines of all kinds, where many facets stay; the same as facets
# alone. 3001006: a plane with a corner 2 µm inside of an arc of its own, of which nothing was drawn;
# 3100001: a needle in a plane that it does not lie in, narrower than its corners are off the planes around it;
# 3100023: a hole as narrow, which became a shell of two faces.
ncsim_judge_parts(tilted_parts --seeds 3000010 3000012 3000019 3001006
  NIGHTLY 3000014 3001002 3100001)
ncsim_judge_parts(tilted_facets --faceted --seeds 3000009 3000010 3000132
  NIGHTLY 3000078 3000082 3001004 3100001 3100023)
# Those in which OpenCASCADE once found a fault that the first ones do not have:
# 60438 a ramp leaves the block in a flat ellipse, of which nothing was drawn, 70744 a wall in a spline;
# 60794, 60158 facets with a corner on an edge of theirs; 40087 with a fold narrower than readers see;
# 60607 a cone beside whose apex facets pass; 20146 a sickle of a ball, between edges that miss their ends;
# 70560 a ring whose inner end is thinner than tools are known; 70629 whose volume was measured wrongly;
# 80079, 80669, 80946 a circle beside a pole of a sphere, which was read 0.02 mm and more from where it is;
# 70967, 80857 a plane that a hole touches from inside along an arc, of which nothing was drawn;
# 90603 a nearly level ramp that ends beside its wall, of which nothing was drawn;
# 100387 a floor between two arcs that end beyond the point in which they touch, likewise;
# 8000028 a wall that a nearly parallel pipe cuts in an ellipse of some metres, likewise;
# 1000019 a helix that stops, whose floor went on in the half of its circle that it does not leave, likewise;
# 1100031 a wall where a helix stops that became part of its floor: its volume was told wrongly;
# 1100082 a facet beside a floor as narrow as readers see, of which nothing was drawn once;
# 101075 a cone whose edges went past its axis beside facets, which was cut in two there;
# 8000175 a wall's upright edges one above the other, but for rounding, which was not closed;
# 3002005 a line and an ellipse that touch in a corner of two loops, of which nothing was drawn;
# 10001010 two crossing rings, whose pieces were one face that hung together in two points;
# 10003058 a wall of a helix, which was cut off at a corner as a face without an end.
ncsim_judge_parts(parts_that_were_faulty
  --seeds 60438 60794 60158 60607 20146 70560 70629 70744 70967 80079 80669 80857 80946
  100387 1000019 1100031 8000028 101075 8000175 3002005 10001010 10003058
  NIGHTLY 40087 90603 1100082)

# All grooves of a sample are of a ball that turns and cuts with its side; its volume, within what
# edges miss.
set(five_axis ${CMAKE_CURRENT_BINARY_DIR}/brep/five_axis)
file(WRITE ${five_axis}/five-axis.expect "solids 1\nvolume 117073.728\nmoved 1e-5\n")
add_test(NAME brep.write_five_axis COMMAND ncsim run ${PROJECT_SOURCE_DIR}/samples/five-axis.nc
  --machine ${PROJECT_SOURCE_DIR}/samples/machines/trt.toml --step ${five_axis}/five-axis.step
  --step-strict)
set_tests_properties(brep.write_five_axis PROPERTIES FIXTURES_SETUP brep_five_axis)
add_test(NAME brep.five_axis_is_read_by_opencascade COMMAND ncsim_read_step ${five_axis})
set_tests_properties(brep.five_axis_is_read_by_opencascade PROPERTIES
  FIXTURES_REQUIRED brep_five_axis)

# Programs whose solids OpenCASCADE once found a fault in, or would if they were written another way;
# each with its volume, by how much edges miss, and options: loops that come twice to a point of a wall,
# exact and rounded at several angles (from a groove or into it), where coils miss their corner; floors that
# touch in a point; arcs that start beside their wall and end in a corner; short moves of a V-cutter.
# No other cut helps.
set(judged ${CMAKE_CURRENT_BINARY_DIR}/brep/judged)
foreach(expected IN ITEMS "helices 98659.142038 1e-5"
    "helix-rounded 98729.809257 4e-4" "helix-10 98729.852563 4e-4" "helix-99 98729.810078 1e-4"
    "helix-156 98729.832264 6e-4" "helix-174 98729.801579 2e-4"
    "helix-into-171 98672.657675 7e-5" "helix-into-329 98672.691410 2e-4"
    "helices-47 98659.170838 1.5e-3" "ball-helix 95154.599003 1e-5"
    "ramps 46569.203553 1e-9" "corner 429.924251 1e-6"
    "engraved 119705.512126 1e-5 --tool-tolerance 0.0125"
    "engraved-again 119916.525664 1e-8 --tool-tolerance 0.0125")
  separate_arguments(expected)
  list(POP_FRONT expected name volume miss)
  file(WRITE ${judged}/${name}.expect "solids 1\nvolume ${volume}\nmoved ${miss}\n")
  add_test(NAME brep.write_${name} COMMAND ncsim run
    ${CMAKE_CURRENT_SOURCE_DIR}/brep/judged/${name}.nc -q --step ${judged}/${name}.step --step-strict
    --step-refine 0 ${expected})
  set_tests_properties(brep.write_${name} PROPERTIES FIXTURES_SETUP brep_judged)
endforeach()
add_test(NAME brep.judged_programs_are_read_by_opencascade COMMAND ncsim_read_step ${judged})
set_tests_properties(brep.judged_programs_are_read_by_opencascade PROPERTIES
  FIXTURES_REQUIRED brep_judged)

# Programs whose solids are to have so many faces, all of them true surfaces: a plunge that ends an arc
# and misses its wall by 1e-8 mm; vertical arcs that begin below the top, one and two of them; a V-cutter
# on a circle narrower than itself, and on two such circles in inches; a ball at the rim of the stock, and
# grooves of a ball that cross. Booleans of OpenCASCADE take them, too; so they do a helical groove of three
# turns, whose walls are 41 faces in the file; a ball on a circle narrower than itself, with a tip inside its
# face; a ring and a line of a ball at one depth, and an engraving of rings, lines and arcs.
set(for_booleans ${CMAKE_CURRENT_BINARY_DIR}/brep/for_booleans)
foreach(expected IN ITEMS "arc-plunge 12 15619.062654" "lead-below-top 13 42011.719050"
    "leads 19 42126.030935" "lead-passes 19 93967.734115" "narrow-circle 12 15956.842678"
    "narrow-circles-inch 18 95923.808859" "ball-at-rim 7 23971.725666"
    "crossing-balls 21 22497.026646" "ball-circle 8 31545.757550" "crossed-ring 14 94402.412591"
    "engraved-rings 30 8540.532239" "long-helix 41 28165.075984 --tool T2=slot:D12:L1")
  separate_arguments(expected)
  list(POP_FRONT expected name faces volume)
  file(WRITE ${for_booleans}/${name}.expect
    "solids 1\nfaces ${faces}\nvolume ${volume}\nmoved 1e-6\n")
  add_test(NAME brep.write_${name} COMMAND ncsim run
    ${CMAKE_CURRENT_SOURCE_DIR}/brep/judged/${name}.nc -q --step ${for_booleans}/${name}.step
    --step-strict --step-refine 0 ${expected})
  set_tests_properties(brep.write_${name} PROPERTIES FIXTURES_SETUP brep_for_booleans)
endforeach()
add_test(NAME brep.booleans_of_programs_are_read_by_opencascade
  COMMAND ncsim_read_step ${for_booleans} --booleans)
set_tests_properties(brep.booleans_of_programs_are_read_by_opencascade PROPERTIES
  FIXTURES_REQUIRED brep_for_booleans)

# Of a solid as a mesh its own program is within what all of them are off.
find_package(OpenCASCADE CONFIG REQUIRED)
add_executable(ncsim_mesh_step brep/mesh_step.cpp)
target_compile_features(ncsim_mesh_step PRIVATE cxx_std_20)
target_include_directories(ncsim_mesh_step SYSTEM PRIVATE ${OpenCASCADE_INCLUDE_DIR})
target_link_libraries(ncsim_mesh_step PRIVATE TKernel TKMath TKBRep TKTopAlgo TKMesh TKSTL TKXSBase
  TKSTEP)
add_test(NAME brep.solids_are_designs_of_their_programs COMMAND ${CMAKE_COMMAND}
  -D NCSIM=$<TARGET_FILE:ncsim> -D MESH_STEP=$<TARGET_FILE:ncsim_mesh_step>
  -D PROGRAM=${CMAKE_CURRENT_SOURCE_DIR}/brep/round_trip/plate.nc
  -D WORK=${CMAKE_CURRENT_BINARY_DIR}/brep/round_trip
  -P ${CMAKE_CURRENT_SOURCE_DIR}/brep/round_trip.cmake)
