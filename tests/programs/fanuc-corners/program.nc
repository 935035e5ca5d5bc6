(,R and ,C at corners of lines and of an arc)
(T1 D=3. CR=0. - flat end mill)
(STOCK/BLOCK,60.,60.,10.,10.,10.,10.)
G21 G90 G17 G94 G54 G40 G49 G80
T1 M6
S2000 M3
G0 X0 Y0 Z5.
G1 Z-1. F100.
X20. ,R5. F300.
Y20. ,C3.
X0 Y40.
G2 X10. Y30. R10.
G1 X40.
G0 Z50.
M5
M30
