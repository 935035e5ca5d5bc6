%
(the centre of an arc is 6 km away, on the wrong side)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-30. Y0.
Z2.
G1 Z-2. F500.
G3 X-30.7 Y-0.36 I-6544123.551 J1.204
G1 X30.
G0 Z50.
M30
%
