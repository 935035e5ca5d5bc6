%
(sideways at cutting depth from an unknown place)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54
T1 M6
S5000 M3
G43 H1 G0 Z-2.
G0 X-50. Y0.
G1 X50. F500.
G0 Z50.
M30
%
