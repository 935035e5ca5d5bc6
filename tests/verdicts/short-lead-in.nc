%
(the first move with G41 is shorter than the radius)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
Z20.
G1 Z-2. F100.
G41 D1 X-2.
G3 X-8. Y-6. I0. J-6.
G3 X4. Y-6. I6. J0.
G3 X-2. Y0. I-6. J0.
G40 G1 X0.
G0 Z50.
M5
M30
%
