%
(T1 without M6 and without G43: the operator loads it)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1
S5000 M3
G0 X-50. Y0.
Z50.
G0 Z-2.
G1 X50. F500.
G0 Z50.
M30
%
