%
(G10 specifies X and Y of both systems, Z of the first alone)
(STOCK/BLOCK,100.,30.,20.,20.,15.,20.)
G21 G90 G17
G10 L2 P1 X10. Y10. Z-50.
G10 L2 P2 X60. Y10.
T1 M6
S5000 M3
G54
G0 X0. Y0.
G43 H1 Z5.
G1 Z-1. F200.
X4.
G0 Z5.
G55
G0 X0. Y0.
G1 Z-1.
X4.
G0 Z5.
M30
%
