%
(centres are absolute, and G90.1 is missing)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-20. Y10.
Z2.
G1 Z-2. F500.
G2 X-10. Y10. I-15. J10.
G2 X-20. Y10. I-15. J10.
G0 Z50.
M30
%
