(G16: distances and angles, absolute and incremental)
(T1 D=3. CR=0. - flat end mill)
(STOCK/BLOCK,60.,60.,10.,30.,30.,10.)
G21 G90 G17 G94 G54 G40 G49 G80
T1 M6
S2000 M3
G0 X0 Y0 Z5.
G16 G0 X20. Y30.
G1 Z-1. F100.
Y75. F300.
Y120.
G91 Y20.
X4.
Y20.
G90 G15
G1 X0 Y0
G0 Z50.
M5
M30
