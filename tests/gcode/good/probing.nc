; contact is assumed at the target
G21 G90 G0 X0 Y0 Z5 F50
G38.2 Z-10
G0 Z[#5063 + 2]
G31 Z-5 F20
M2
