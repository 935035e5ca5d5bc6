%
(slot so deep that only a long tool can do it, and nobody says how long it is)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
G91 G28 Z0.
G90
T1 M6
S5000 M3
G0 X-50. Y0.
G43 H1 Z50.
G0 Z-20.
G1 X50. F300.
G0 Z50.
M5
G91 G28 Z0.
G90
M30
%
