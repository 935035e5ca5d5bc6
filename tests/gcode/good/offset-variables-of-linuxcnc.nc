; offsets written as variables, which G54 alone does not take up; dialect: rs274, offsets: told
(LinuxCNC)
G21 G90 G54 G0 X0 Y0 Z5
#5221=5
G54 X1
G55
G54 X0
#<x>=#5221
G0 X#<x>
M2
