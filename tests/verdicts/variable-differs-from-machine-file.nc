%
(a variable places G54 2 mm above its place in the machine file)
(STOCK/BLOCK,40.,30.,20.,20.,15.,20.)
G21 G90 G17
#5223=-48.
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
