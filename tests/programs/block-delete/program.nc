(a block that starts with a slash is skipped)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,30.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X-5. Y15. Z5.
G0 Z-2.
/G0 Z-4.
G1 X45. F500.
G0 Z20.
M5
M30
