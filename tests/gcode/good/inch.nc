; lengths and feeds in inches
G20 G90 G0 X1 Y.5 Z.1
G1 Z-.1 F10
G1 A90 F360
G93 G1 X2 A0 F4
G94 F20 G2 X3 R.5
M2
