%
(the path is that of the tool's centre, and D1 is 0)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-50. Y-24.5
Z2.
G0 Z-5.
G42 D1
G1 X-40. F300
X46.
G40
G1 X50.
G0 Z50.
M30
%
