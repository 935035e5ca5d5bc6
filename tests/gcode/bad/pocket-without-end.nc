; 6:1: error: G150 needs larger increments (Q, I, J) [pocket-word]
(a sign of Haas: G187 P1)
G187 P1
G21 G90 G54 F100
G0 X5. Y5. Z5.
G150 P100 X5. Y5. Z-900. R1. Q0.01 I0.001 G41 D1
M30
N100 G1 X5. Y0.
X10.
Y10.
X0.
Y0.
X5.
M99
