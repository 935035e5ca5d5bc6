(a spiral of a ball end mill around a bar)
(T2 D=6. CR=3. - ball end mill)
G90 G94 G17 G21 G54
T2 M6
S9000 M3
G0 X-6 Y0 A0
Z24
G1 Z18 F500
X18 A1440 F3000
G0 Z40
M30
