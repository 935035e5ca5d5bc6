%
(a T-slot cutter comes from outside)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X-60. Y0.
Z5.
G0 Z-6.
G1 X60. F100.
G0 Z50.
M5
M30
%
