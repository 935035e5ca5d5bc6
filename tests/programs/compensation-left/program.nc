(G41 around an island, from the outside: the contour is the wall)
(T1 D=8. CR=0. - flat end mill)
(STOCK/BLOCK,60.,50.,10.,0.,0.,10.)
G21 G90 G17 G94 G40 G54
T1 M6
S6000 M3
G0 X-10. Y-10. Z5.
G0 Z-3.
G41 D1 G1 X15. Y5. F400.
Y40.
X45.
Y10.
X5.
G40 G1 X-10. Y-10.
G0 Z20.
M5
M30
