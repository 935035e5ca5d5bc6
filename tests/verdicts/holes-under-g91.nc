%
(G91 behind the depth of a cycle: steps of depth or the same depth)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X-20. Y0.
Z20.
G98 G81 X-20. Y0. Z-5. R2. F100.
G91 X20. L2
G90
G80
G0 Z50.
M5
M30
%
