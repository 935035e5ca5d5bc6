(a spiral of a flat end mill, 2 mm off the axis of the bar)
(T1 D=8. CR=0. - flat end mill)
G90 G94 G17 G21 G54
T1 M6
S9000 M3
G0 X-6 Y2 A0
Z24
G1 Z15 F500
X30 A2520 F3000
G0 Z40
M30
