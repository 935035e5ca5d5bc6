(G68: a slot turned by 30 degrees about the middle)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G68 X20. Y20. R30.
G0 X10. Y20. Z2.
G1 Z-2. F200.
X30. F400.
G69
G0 Z20.
M5
M30
