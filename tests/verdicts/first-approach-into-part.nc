%
(the first move with G43 ends in the part, from wherever it comes)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54
T1 M6
S5000 M3
G0 X0. Y0.
G43 H1 Z-5.
G1 X20. F500.
G0 Z50.
M30
%
