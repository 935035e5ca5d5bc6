(one turn of a thread mill in a bore)
(T1 D=10. CR=0. - flat end mill)
(T2 D=8. - thread mill, pitch 1.5)
(STOCK/BLOCK,40.,40.,12.,20.,20.,12.)
G21 G90 G17 G94 G54
T1 M6
S5000 M3
G0 X0. Y0. Z5.
G1 Z-10. F100.
G0 Z20.
M5
T2 M6
S3000 M3
G0 X0. Y0. Z2.
G0 Z-8.
G1 X1.5 F200.
G3 X1.5 Y0. Z-6.5 I-1.5 J0.
G1 X0.
G0 Z20.
M5
M30
