# Who may see whom: a room and the rooms whose headers it may include, leaves first. An arrow that is
# not here does not exist; the picture of it, with one line a room, is in CONTRIBUTING.md.
set(layers
  "trig:"
  "gcode:    trig"
  "cda:"
  "dexel:    cda"
  "machine:  cda trig"
  "toolpath: gcode machine cda trig"
  "verify:   gcode toolpath machine cda trig"
  "brep:     gcode cda machine toolpath trig"
  "export:   cda brep trig"
  "report:   gcode toolpath machine cda verify"
  "setup:    gcode toolpath machine cda trig verify report"
  "simulation: gcode toolpath machine cda trig dexel verify brep export report setup"
  "app:      gcode toolpath machine cda verify brep export report setup simulation")

# Where the files of a room are. Headers in the first folder are public, ncsim/ROOM/….
set(folders_app apps/ncsim)
foreach(library trig gcode cda dexel machine toolpath verify brep export report setup simulation)
  set(folders_${library} lib/${library}/include/ncsim/${library} lib/${library}/src)
endforeach()

# Folders of a room's sources that stand on each other, the lowest first.
set(floors_gcode text control program)

# Arrows within a room that close a circle and are still there: ROOM/FROM>TO. One that is gone has to
# be struck off; none may come in.
set(known_circles)

# Rooms in which every source has a header of its own name, so that what a header declares is where
# its name says, and no circle hides in "declared here, defined there". Others are to follow.
set(paired dexel report setup simulation app)
set(unpaired app/main)
