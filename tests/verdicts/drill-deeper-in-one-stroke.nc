%
(22 mm in one stroke with flutes of 20 mm)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
Z10.
G1 Z-22. F100.
G0 Z50.
M5
M30
%
