(G68 rotates an arc and an incremental move; a second G68 replaces the first)
(T1 D=3. CR=0. - flat end mill)
(STOCK/BLOCK,60.,60.,10.,20.,30.,10.)
G21 G90 G17 G94 G54 G40 G49 G80
T1 M6
S2000 M3
G0 X0 Y0 Z5.
G1 Z-1. F100.
G68 X10. Y5. R30.
G1 X20. Y0 F300.
G3 X10. Y10. I-10.
G91 G1 X5.
G90
G68 X0 Y0 R-60.
G1 X7. Y8.
G69
X1. Y1.
G0 Z50.
M5
M30
