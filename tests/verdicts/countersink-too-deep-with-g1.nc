%
(a countersink goes deeper than its cone, by G1 in two steps)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
G43 H1 Z10.
G83 X0. Y0. Z-25. R2. Q4. F100.
G80
G0 Z50.
M5
T2 M6
S500 M3
G0 X0. Y0.
G43 H2 Z10.
G1 Z-4. F80.
G1 Z-6.1
G0 Z50.
M5
M30
%
