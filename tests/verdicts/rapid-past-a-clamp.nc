%
(a slanting rapid passes a clamp, and axis by axis it does not)
(STOCK/BLOCK,100.,60.,20.,50.,30.,20.)
G21 G90 G17 G54 G40 G49 G80 G94
G91 G28 Z0.
G90
T1 M6
S3000 M3
G0 X-30. Y-25.
G43 H1 Z30.
G1 Z5. F500.
G0 X30. Y-8.
G1 Z-2.
G0 Z100.
M5
G91 G28 Z0.
G90
M30
%
