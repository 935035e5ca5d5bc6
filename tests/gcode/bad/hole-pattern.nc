; 5:1: error: G70 needs a drilling cycle that is on, such as G81 [hole-pattern]
%
O1001
G21 G90 G54 G0 X0 Y0 Z5. F100
G70 I5. J0. L4
M30
%
