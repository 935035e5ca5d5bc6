# Who may see whom: a room and the rooms whose headers it may include, leaves first; "a/b" permits the
# headers of floor b of room a alone. An arrow that is not here does not exist; the picture of it, with one line a room, is in CONTRIBUTING.md.
set(layers
  "base:"
  "gcode:    base/text base/numbers"
  "cda:      base"
  "mesh:     base cda"
  "dexel:    base cda"
  "machine:  base cda"
  "toolpath: base gcode machine cda"
  "verify:   base gcode toolpath machine cda"
  "brep:     base gcode cda machine toolpath"
  "export:   base cda mesh brep"
  "setup:    base gcode toolpath machine cda verify"
  "simulation: base gcode toolpath machine cda mesh dexel verify brep export setup"
  "report:   base gcode toolpath machine cda verify setup simulation"
  "app:      base gcode toolpath machine cda mesh verify brep export report setup simulation"
  "python:   base gcode toolpath cda mesh verify brep export report setup simulation")

# Where the files of a room are. Headers in the first folder are public, ncsim/ROOM/….
set(folders_app apps/ncsim)
set(folders_python python/src)
foreach(library base gcode cda mesh dexel machine toolpath verify brep export report setup simulation)
  set(folders_${library} lib/${library}/include/ncsim/${library} lib/${library}/src)
endforeach()

# Folders of a library's sources, the lowest first: a file may include files of its own folder and of
# those before it. A name "a/b" is the folder b in a; files directly in a may include, and be included by, the
# folders in it.
set(floors_base text numbers geometry)
set(floors_gcode text control/paths control/frames control/cycles language klartext sinumerik program)
set(floors_cda exact polytope surface tree flat)
set(floors_toolpath tools polytope motion)
set(floors_brep geometry sources topology query heal recognise)
set(floors_export render formats)
set(floors_setup files meshes machines job)
set(floors_app system options run commands check merge)

# A public header is on the floor of the source of its name. FOLDER:HEADER for headers without a source.
set(headers_base text:ascii text:number_text text:version numbers:int128 numbers:mix numbers:vec2 geometry:vec3 geometry:triangle_mesh)
set(headers_cda exact:tile_number exact:origin polytope:sweep flat:cell_model)
set(headers_toolpath polytope:tool_pose polytope:side)
set(headers_brep geometry:facets)
set(headers_export render:image render:overlay render:render_options formats:drawing formats:moving_scene)
set(headers_setup machines:specified_kinematics machines:machine_file job:job_options job:option_setting)
# Values that all floors hand on: every floor may include the public headers of these libraries.
set(open_headers gcode)

# Arrows within a room that close a circle and are still there: ROOM/FROM>TO. One that is gone has to
# be struck off; none may come in.
set(known_circles)

# Rooms in which every source has a header of its own name, so that what a header declares is where
# its name says, and no circle hides in "declared here, defined there". Others are to follow.
set(paired dexel report setup simulation app python)
set(unpaired app/main python/module)
