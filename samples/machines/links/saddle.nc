(The slide of Y: a fork that holds the cradle)
G21 G90 G17 G94
S500 M3
(room for the cradle)
T2 M6
G0 X-155 Y-200 Z0
G1 Z-445 F5000
G1 Y200
G1 X-115
G1 Y-200
G1 X-75
G1 Y200
G1 X-35
G1 Y-200
G1 X5
G1 Y200
G1 X45
G1 Y-200
G1 X85
G1 Y200
G1 X125
G1 Y-200
G1 X155
G1 Y200
G0 Z300
(both arms round about the axis of A: the tool comes from the right, X is -Z of the machine)
T1 M6
G0 X0 Y0 Z600
G0 B90
G0 X411 Y300 Z600
G1 Z-260
(up aslant, then around the axis at Y0 Z-320 with R50)
G1 Y199.8
G1 X256.6 Y113.5
G3 X256.6 Y-113.5 I63.4 J-113.5
G1 X411 Y-199.8
G1 Y-300
G0 Z600
G0 B0
M30
