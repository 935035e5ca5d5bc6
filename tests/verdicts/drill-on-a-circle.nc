%
(a drill widens its hole on a circle)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
Z10.
G81 X0. Y0. Z-5. R2. F100.
G80
G1 Z-3.
G2 X0. Y0. I3. J0.
G0 Z50.
M5
M30
%
