(G81, G82 and G83 on three holes; G98 goes back to the plane of the start)
(T1 D=5. - drill A118.)
(STOCK/BLOCK,40.,40.,15.,0.,0.,15.)
G21 G90 G17 G94 G54
T1 M6
S2000 M3
G0 X10. Y10. Z5.
G98 G81 X10. Y10. Z-6. R1. F150.
G82 X30. Y10. Z-6. R1. P0.5
G83 X30. Y30. Z-12. R1. Q4.
G80
G0 Z20.
M5
M30
