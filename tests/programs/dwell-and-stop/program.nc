(a dwell on the floor of a hole, a stop, and coolant)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,30.,30.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
M8
G0 X15. Y15. Z5.
G1 Z-4. F100.
G4 P0.5
G0 Z20.
M0
M9
M5
M30
