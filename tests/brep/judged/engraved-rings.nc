(engraving with a ball at one depth: a ring, a second ring that crosses it, an arc and two lines)
(T1 D=3. CR=1.5 - ball end mill)
(STOCK/BLOCK,50.,30.,6.,25.,15.,6.)
G90 G94 G17 G21 G54
T1 M6
S12000 M3
G0 X4 Y0 Z5
G1 Z-1.2 F300
G3 X4 Y0 I-9 J0 F800
G0 Z5
X14 Y0
G1 Z-1.2 F300
G2 X14 Y0 I-9 J0 F800
G0 Z5
X-20 Y-2
G1 Z-1.2 F300
G1 X20 Y4 F800
G0 Z5
X-16 Y9
G1 Z-1.2 F300
G2 X16 Y9 I16 J-20 F800
G0 Z5
M30
