%
(a cycle below the top, without G98 and G99, on both sides of a wall)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-50. Y0.
Z2.
G1 Z-8. F500.
X-12.
G0 Z10.
G0 X50. Y0.
Z2.
G1 Z-8.
X12.
G0 Z10.
G0 X-20. Y0.
G81 X-20. Y0. Z-12. R-6. F100.
X20.
G80
G0 Z50.
M30
%
