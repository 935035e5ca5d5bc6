%
(half a millimetre above a jaw with a clearance of 2 mm)
(STOCK/BLOCK,100.,60.,20.,50.,30.,20.)
G21 G90 G17 G54 G40 G49 G80 G94
G91 G28 Z0.
G90
T1 M6
S3000 M3
G0 X-60. Y-34.
G43 H1 Z10.
Z-7.5
G1 X60. F900.
G0 Z100.
M5
G91 G28 Z0.
G90
M30
%
