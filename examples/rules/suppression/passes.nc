(STOCK/BLOCK,80.,40.,20.,40.,20.,20.)
G21 G90 G17 G54 (FROM/0.,0.,100.)
T1 M6
S8000 M3
G0 X-50. Y0. Z5.
G0 Z-2.
G1 X50. F500. (ncsim: ignore rapid-in-material)
G0 Z5.
M30
