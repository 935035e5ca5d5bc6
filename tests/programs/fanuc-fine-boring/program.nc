(G76 steps aside at the bottom, and returns with the spindle held)
(T1 D=12. - boring bar)
(STOCK/BLOCK,60.,30.,20.,0.,0.,20.)
G21 G90 G17 G94 G54 G40 G49 G80
T1 M6
S2000 M3
G0 X0 Y0 Z50.
F100.
G76 X10. Y10. Z-5. R2. Q0.5
X20.
G80
M3
G0 Z50.
M5
M30
