(The cradle turns about A, along X through Y0 Z-320)
G21 G90 G17 G94
S500 M3
(round below: the tool comes from the right, X is -Z of the machine)
T1 M6
G0 X0 Y0 Z600
G0 B90
G0 X240 Y140 Z600
G1 Z-200 F5000
G1 X320
G2 X320 Y-140 I0 J-140
G1 X240
G0 Z600
G0 B0
(between the arms)
T2 M6
G0 X-100 Y-200 Z0
G1 Z-375
G1 Y200
G1 X-65
G1 Y-200
G1 X-30
G1 Y200
G1 X5
G1 Y-200
G1 X40
G1 Y200
G1 X75
G1 Y-200
G1 X100
G1 Y200
G0 Z0
M30
