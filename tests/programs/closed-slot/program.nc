(a slot with round ends, by a ramp and a plain way)
(T1 D=8. CR=0. - flat end mill)
(STOCK/BLOCK,50.,30.,12.,0.,0.,12.)
G21 G90 G17 G94 G54
T1 M6
S6000 M3
G0 X12. Y15. Z2.
G1 Z0. F200.
X38. Z-4. F400.
X12.
X38.
G0 Z20.
M5
M30
