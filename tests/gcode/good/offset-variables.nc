; offsets written as variables; dialect: mach3, offsets: told
G21 G90 G54 G0 X0 Y0 Z5
#5221=5
G54 X0
#5221=7
G55
G54 X0
M30
