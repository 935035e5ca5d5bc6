(three passes of a ball end mill side by side leave ridges)
(T1 D=6. CR=3. - ball end mill)
(STOCK/BLOCK,40.,20.,10.,0.,0.,10.)
G21 G90 G17 G94 G54
T1 M6
S9000 M3
G0 X-5. Y6. Z5.
G0 Z-2.
G1 X45. F800.
G0 Y10.
G1 X-5.
G0 Y14.
G1 X45.
G0 Z20.
M5
M30
