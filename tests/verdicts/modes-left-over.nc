%
(G52 and G40 of the program before may be in force)
(STOCK/BLOCK,100.,60.,20.,50.,30.,20.)
G21 G90 G17 G54 G49 G80 G94
T1 M6
S3000 M3
G0 X-60. Y0.
G43 H1 Z10.
Z-3.
G1 X-40. F500.
G0 Z50.
M5
M30
%
