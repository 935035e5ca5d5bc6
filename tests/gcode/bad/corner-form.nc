; 5:8: error: ,R needs lines that are long enough for it; the corner is left sharp [corner-form]
%
O1003
G21 G90 G54 G0 X0 Y0 Z5. F100
G1 X10.,R4.
Y3.
M30
%
