(LinuxCNC: a cubic spline by G5)
(T1 D=4. CR=0. - flat end mill)
(STOCK/BLOCK,60.,40.,6.,0.,20.,6.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X5. Y0. Z2.
G1 Z-1. F200.
G5 I0 J20. P0 Q-20. X30. Y0. F500.
G5 P0 Q20. X55. Y0.
G0 Z20.
M5
M2
