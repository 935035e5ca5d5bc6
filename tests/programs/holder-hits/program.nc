(a deep pocket: the holder meets the wall)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,30.,0.,0.,30.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X20. Y20. Z5.
G1 Z-20. F100.
X25. F300.
G0 Z20.
M5
M30
