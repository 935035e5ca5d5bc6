(a bar is milled to 18 mm radius along a spiral)
(T1 D=12. CR=0. - flat end mill)
G90 G94 G17 G21 G54
T1 M6
S12000 M3
G0 X-19. Y0. A0.
Z40.
Z24.
G1 Z18. F600.
X19. A1735. F3000.
G0 Z40.
M5
M30
