%
(a cycle without G98 and G99 whose R is above everything)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80
T1 M6
S5000 M3
G0 X-20. Y0.
Z10.
G81 X-20. Y0. Z-4. R2. F100.
X20.
G80
G0 Z50.
M30
%
