%
(a comment specifies the start, G10 places G54)
(STOCK/BLOCK,40.,30.,20.,20.,15.,20.)
(FROM/0.,0.,50.)
G21 G90 G17
G10 L2 P1 X-100. Y-80. Z-50.
T1 M6
S5000 M3
G54
G0 X0. Y0.
G43 H1 Z5.
G1 Z-1. F200.
X4.
G0 Z50.
M2
%
