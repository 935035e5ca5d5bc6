%
(neither G90 nor G91, on a control that starts with G90)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-50. Y0.
Z2.
G1 Z-2. F500.
X50.
G0 Z50.
M30
%
