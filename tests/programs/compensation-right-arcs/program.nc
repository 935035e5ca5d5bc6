(G42 along a contour of lines and tangent arcs)
(T1 D=6. CR=0. - flat end mill)
(STOCK/BLOCK,60.,40.,8.,0.,0.,8.)
G21 G90 G17 G94 G40 G54
T1 M6
S6000 M3
G0 X-10. Y10. Z5.
G0 Z-2.
G42 D1 G1 X5. Y10. F400.
X40.
G3 X50. Y20. R10.
G1 Y25.
G3 X40. Y35. R10.
G1 X-8.
G40 G1 Y48.
G0 Z20.
M5
M30
