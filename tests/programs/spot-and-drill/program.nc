(two tools: a spot drill, then a drill through the part)
(T1 D=8. - spot drill A90.)
(T2 D=5. - drill A118.)
(STOCK/BLOCK,30.,30.,8.,0.,0.,8.)
G21 G90 G17 G94 G54
T1 M6
S2500 M3
G0 X15. Y15. Z5.
G81 X15. Y15. Z-3. R1. F200.
G80 G0 Z20.
M5
T2 M6
S3000 M3
G0 X15. Y15. Z5.
G83 X15. Y15. Z-10. R1. Q3. F150.
G80
G0 Z20.
M5
M30
