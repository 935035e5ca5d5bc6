(two flats on a round bar that A turns by half a turn)
(T1 D=10. CR=0. - flat end mill)
G21 G90 G17 G94 G54
T1 M6
S5000 M3
G0 X-8. Y0. Z20. A0.
G0 Z8.
G1 X48. F400.
G0 Z20.
G0 A180.
G0 Z8.
G1 X-8.
G0 Z20.
M5
M30
