; a square from outside, a slot with a round end, tool 1 has a diameter of 10
T1 M6
G21 G90 G17 F100 G0 X-20 Y-20 Z5
G1 Z-1
G41 D1 G1 X0 Y0
Y50
X50
Y0
X0
G40 G1 X-20 Y-20
G0 X100 Y100
G42 D1 G1 X100 Y120
G1 X150
G2 X150 Y90 R15
G1 X110
G40
G0 Z5
M2
