(a steep groove: the rim leaves its floor higher than a cylinder, so it stays facets)
(T1 D=4. CR=0. - flat end mill)
G21 G90 G17 G94 G54
T1 M6
S8000 M3
G0 X5. Y0. Z15. A0.
G1 Z8. F100.
G1 X35. A240. F600.
G0 Z20.
M5
M30
