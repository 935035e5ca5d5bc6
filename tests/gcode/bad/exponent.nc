; 3:9: error: 'X1.2e-05' is no number of G-code, which has no exponents; write all digits, as in 0.000012 [exponent]
G21 G90 G0 X0 Y0 Z5
G1 F100 X1.2e-05 Y3
M2
