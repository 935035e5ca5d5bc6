%
(G10 L2 P0 lowers all zeros, and nothing restores them)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-50. Y0.
Z2.
G1 Z-2. F500.
X50.
G0 Z50.
G10 L2 P0 Z-12.
G0 Z5.
X-50.
G0 Z50.
M30
%
