; 5:1: error: G13 needs an increment of the radius (Q) above 0 [pocket-word]
%
O1002
G21 G90 G54 G0 X0 Y0 Z5. F100
G13 I4. K12. Z-2. D1
M30
%
