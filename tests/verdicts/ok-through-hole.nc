%
(a hole through the part, and free space below it)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
G91 G28 Z0.
G90
T1 M6
S5000 M3
G0 X-50. Y0.
G43 H1 Z50.
G0 X0. Z5.
G1 Z-36. F200.
G0 Z50.
M5
G91 G28 Z0.
G90
M30
%
