; 2:1: error: '#5=1.5e2' is no number of G-code, which has no exponents; write all digits, as in 0.000012 [exponent]
#5=1.5e2
G21 G90 G0 X#5 Y0 Z5
M2
