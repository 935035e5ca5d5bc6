(HAAS: G150 clears an L of any width, strokes along Y; strokes that would cross the corner are lifted)
(T1 D=6. CR=0. - flat end mill)
(4 mm deep: 40 x 30 - 20 x 15 - five corners of 9 - 9 pi / 4, 3561.4 mm3)
G21 G90 G54
T1 M6
S8000 M3
G0 X9. Y9. Z20.
G150 P100 X9. Y9. Z-4. R1. G42 D1 F500. J2.5
G40 G0 Z20.
M30
N100 G1 X20. Y0.
X40.
Y15.
X20.
Y30.
X0.
Y0.
X20.
M99
