%
(a back-boring bar goes back after M5: its edge stands anywhere)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
G43 H1 Z10.
G83 X0. Y0. Z-35. R2. Q8. F100.
G80
G0 Z50.
M5
T2 M6
G0 X0. Y0.
G43 H2 Z10.
M19
G0 X-3.
Z-34.
X0.
S500 M3
G1 Z-25. F50.
G1 Z-33.
M5
G0 Z50.
M5
M30
%
