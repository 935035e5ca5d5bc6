%
(G40 alone, then a lift: another way on each control)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X50. Y-20.
Z2.
G0 Z-2.
G41 D1
G1 X30. Y-8. F300
G1 Y20.
G40
G0 Z5.
G0 X60. Y20.
G0 Z50.
M30
%
