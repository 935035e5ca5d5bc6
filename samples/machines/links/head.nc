(The head goes along Z; round about the spindle in front)
G21 G90 G17 G94
S500 M3
T1 M6
G0 X135 Y200 Z400
G1 Z0 F5000
G1 Y0
G2 X-135 Y0 I-135 J0
G1 Y200
G0 Z400
M30
