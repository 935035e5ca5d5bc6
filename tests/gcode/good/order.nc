; the order of execution is not that of writing
G21 G90 G0 X1 Y1 Z1
G1 X10 G91 F100
G90 G0 X2 G20
G21 Y5 M3 S500
#1=6 X#1
X#1
M2
