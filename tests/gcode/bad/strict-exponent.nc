; strict: 2:7: error: 'X1E3' is no number of G-code, which has no exponents; write all digits, as in 0.000012 [exponent]
F1 G1 X1E3
M2
