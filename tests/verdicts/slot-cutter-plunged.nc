%
(a T-slot cutter goes straight down)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
Z5.
G1 Z-6. F100.
X20.
G0 Z50.
M5
M30
%
