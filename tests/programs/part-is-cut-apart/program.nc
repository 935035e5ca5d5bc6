(a slot through the part leaves two pieces)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,30.,8.,0.,0.,8.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X20. Y-6. Z5.
G0 Z-8.5
G1 Y36. F300.
G0 Z20.
M5
M30
