(a helix of two turns around a boss, in the plane G17)
(T1 D=8. CR=0. - flat end mill)
(STOCK/BLOCK,50.,50.,20.,25.,25.,20.)
G21 G90 G17 G94 G54
T1 M6
S5000 M3
G0 X19. Y0. Z2.
G1 Z0. F200.
G2 X19. Y0. Z-4. I-19. J0. P2 F600.
G2 X19. Y0. I-19. J0.
G1 X32.
G0 Z20.
M5
M30
