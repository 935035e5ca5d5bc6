%
(in G55 all moves are increments from a place of G54)
(STOCK/BLOCK,100.,30.,20.,20.,15.,20.)
G21 G90 G17
T1 M6
S5000 M3
G54
G0 X0. Y0.
G43 H1 Z5.
G1 Z-1. F200.
X4.
G0 Z30.
G55 G91
G0 X46.
G0 Z-25.
G1 Z-6.
X4.
G0 Z31.
G90
M30
%
