(LinuxCNC: a square by distance and angle)
(T1 D=4. CR=0. - flat end mill)
(STOCK/BLOCK,50.,50.,6.,25.,25.,6.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 @20 ^45 Z2.
G1 Z-1. F200.
G1 @20 ^135 F500.
@20 ^225
@20 ^315
@20 ^45
G0 Z20.
M5
M2
