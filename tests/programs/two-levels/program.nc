(a step is milled in two levels, each with two passes)
(T1 D=12. CR=0. - flat end mill)
(STOCK/BLOCK,60.,40.,15.,0.,0.,15.)
G21 G90 G17 G94 G54
T1 M6
S4000 M3
G0 X-10. Y2. Z5.
G0 Z-3.
G1 X70. F600.
Y12.
X-10.
G0 Z5.
G0 Y2.
G0 Z-6.
G1 X70.
Y12.
X-10.
G0 Z20.
M5
M30
