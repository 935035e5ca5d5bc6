(G18: a ball end mill on an arc in the plane ZX)
(T1 D=6. CR=3. - ball end mill)
(STOCK/BLOCK,50.,20.,15.,0.,0.,15.)
G21 G90 G18 G94 G54
T1 M6
S8000 M3
G0 X5. Y10. Z5.
G1 Z-2. F200.
G2 X45. Y10. Z-2. I20. K15. F500.
G0 Z20.
M5
M30
