(G91: a staircase of four equal steps)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,50.,30.,12.,0.,0.,12.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X-5. Y15. Z2.
G0 Z-1.
G91 G1 X15. F400.
Z-1.
X12.
Z-1.
X12.
Z-1.
X18.
G90 G0 Z20.
M5
M30
