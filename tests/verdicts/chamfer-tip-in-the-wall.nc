%
(a chamfer mill whose tip runs in the wall)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S5000 M3
G0 X-50. Y-50.
G43 H1 Z10.
G0 X-50. Y-30.
G1 Z-1.5 F300.
G1 X50.
G0 Z50.
M5
M30
%
