; 9:1: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
(a sign of Haas: G187 P1)
G187 P1
G21 G90 G54 F100
G0 X5. Y5. Z5.
G150 P100 X5. Y5. Z-1. R1. I2. G41 D1
M30
N100 G1 X5. Y0.
G2 X10.
Y10.
X0.
Y0.
X5.
M99
