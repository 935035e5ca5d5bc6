%
(a drill moves sideways in the air alone)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X-10. Y0.
Z10.
G81 X-10. Y0. Z-5. R2. F100.
X0.
X10.
G80
G0 Z50.
M5
M30
%
