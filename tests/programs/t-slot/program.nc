(a slot is widened at its floor with a T-slot cutter)
(T1 D=6. CR=0. - flat end mill)
(T2 D=12. - T-slot cutter)
(STOCK/BLOCK,40.,30.,15.,0.,0.,15.)
G21 G90 G17 G94 G54
T1 M6
S6000 M3
G0 X-8. Y15. Z5.
G0 Z-10.
G1 X48. F400.
G0 Z20.
M5
T2 M6
S3000 M3
G0 X-10. Y15. Z5.
G0 Z-10.
G1 X50. F200.
G0 Z20.
M5
M30
