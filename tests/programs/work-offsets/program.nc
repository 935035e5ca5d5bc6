(the same slot in G54 and in G55, which G10 moves by 20 mm in Y)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,40.,40.,10.,0.,0.,10.)
G21 G90 G17 G94
G10 L2 P1 X0 Y0 Z0
G10 L2 P2 X0 Y20. Z0
G54
T1 M6
S8000 M3
G0 X-5. Y10. Z5.
G0 Z-2.
G1 X45. F500.
G0 Z5.
G55
G0 X-5. Y10.
G0 Z-2.
G1 X45.
G0 Z20.
M5
M30
