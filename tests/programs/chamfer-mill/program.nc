(an edge is broken with a chamfer mill of 90 degrees)
(T1 D=10. A=90. - chamfer mill)
(STOCK/BLOCK,40.,30.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S6000 M3
G0 X-10. Y-2. Z5.
G0 Z-3.
G1 X50. F400.
G0 Z20.
M5
M30
