(rings and parts of rings around a bar: a ball, a bull nose, a flat end mill)
(T1 D=6. CR=0. - flat end mill)
(T2 D=6. CR=3. - ball end mill)
(T3 D=6. CR=1. - bull nose end mill)
G90 G94 G17 G21 G54
T2 M6
S9000 M3
G0 X6 Y0 Z24 A0
G1 Z18 F500
A360 F3000
G0 Z24
T3 M6
S9000 M3
G0 X17 Y0 A0
G1 Z18.5 F500
A-140 F3000
G0 Z24
X17 A90
G1 Z18 F500
A150 F3000
G0 Z24
T1 M6
S9000 M3
G0 X29 Y0 A30
G1 Z18 F500
A250 F3000
G0 Z40
M30
