%
(the comment has another tool than --tool)
(STOCK/BLOCK,100.,60.,20.,50.,30.,20.)
G21 G90 G17 G54 G40 G49 G80 G94
G91 G28 Z0.
G90
T1 M6
S3000 M3
(T1 D=6. CR=0. - flat end mill)
G0 X-60. Y0.
G43 H1 Z10.
Z-3.
G1 X60. F900.
G0 Z100.
M5
G91 G28 Z0.
G90
M30
%
