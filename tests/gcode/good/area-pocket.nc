(dialect: haas)
(a pocket of any shape: its outline is listened to, from the starting hole to M99)
G21 G90 G17 G54
G0 X0. Y0. Z10.
G150 P100 X20. Y15. Z-4. R1. Q3. J8. K1. G42 D1 F300.
G40 X0. Y0.
(a slot: back in the middle, and nowhere lifted)
G150 P200 X10. Y6. Z-1. R0.5 I8. G41 D1 F300.
G40 G0 Z10.
M30
N100 G1 X20. Y0.
X0. ,C8.
Y30.
G91 X40.
Y-30.
G90 X20.
M99
N200 G1 X10. Y0.
X20.
G3 Y12. J6.
G1 X0.
G3 Y0. R6.
G1 X10.
M99
