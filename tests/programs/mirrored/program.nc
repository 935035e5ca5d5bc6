(G51 with a negative factor mirrors a contour in X)
(T1 D=4. CR=0. - flat end mill)
(STOCK/BLOCK,60.,30.,8.,30.,0.,8.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G51 X0 Y0 Z0 I-1. J1. K1.
G0 X5. Y5. Z2.
G1 Z-1. F200.
X20. F400.
G3 X20. Y20. J7.5
G50
G0 Z20.
M5
M30
