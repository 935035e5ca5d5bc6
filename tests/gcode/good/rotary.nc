; rotary axes are not wrapped
G21 G90 G0 X0 Y0 Z10 A0
G1 Z0 A720 F500
A-30 B10 C5
M2
