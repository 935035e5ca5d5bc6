(G95: millimetres per turn of the spindle, then minutes again)
(T1 D=10. CR=0. - flat end mill)
(STOCK/BLOCK,50.,30.,10.,0.,0.,10.)
G21 G90 G17 G95 G54
T1 M6
S2000 M3
G0 X-8. Y15. Z5.
G0 Z-1.
G1 X58. F0.2
G94 G1 Y24. F600.
X-8.
G0 Z20.
M5
M30
