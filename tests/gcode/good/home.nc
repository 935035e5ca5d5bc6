; G28 goes over the intermediate point; G28.1 stores the place; offsets: told
G21 G90 G0 X10 Y10 Z10
G28.1
G10 L2 P1 X100 Y0 Z0
G0 X50 Y50 Z5
G28 Z8
G91 G28 Z0
G90 G30 X1
M2
