%
(a thread mill leaves the wall by less than its thread is deep, then goes up at feed)
(STOCK/BLOCK,80.,60.,30.,40.,30.,30.)
G21 G90 G17 G54 G40 G49 G80 G94
T1 M6
S800 M3
G0 X0. Y0.
G43 H1 Z10.
G83 X0. Y0. Z-20. R2. Q4. F100.
G80
G0 Z50.
M5
T2 M6
S2000 M3
G0 X0. Y0.
G43 H2 Z10.
G0 Z-12.
G1 X3. F200.
G3 X3. Y0. Z-9.5 I-3. J0.
G1 X2.5
G1 Z5.
G0 Z50.
M5
M30
%
