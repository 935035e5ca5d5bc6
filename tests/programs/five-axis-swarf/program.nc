(the tool leans by B while it moves along X)
(T1 D=8. CR=0. - flat end mill)
(STOCK/BLOCK,60.,30.,12.,0.,0.,12.)
G21 G90 G17 G94 G54
T1 M6
S6000 M3
G0 X-10. Y15. Z30. B0.
G0 Z-3.
G1 X30. Y15. B10. F400.
X70. B0.
G0 Z30.
M5
M30
