; G10 L2 with R under G92: LinuxCNC has a wrong position after it
G21 G90 F100
G0 X0 Y0 Z5
G92 X5
G10 L2 P1 R90
G1 X1 Y1
M2
