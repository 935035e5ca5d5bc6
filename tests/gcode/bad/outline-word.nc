; 8:6: error: the outline of G150 needs lines and arcs (G1, G2, G3) alone [pocket-word]
(a sign of Haas: G187 P1)
G187 P1
G21 G90 G54 F100
G0 X5. Y5. Z5.
G150 P100 X5. Y5. Z-1. R1. I2. G41 D1
M30
N100 G81 X5. Y0. Z-3. R1.
M99
