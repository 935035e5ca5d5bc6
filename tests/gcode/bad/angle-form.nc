; 5:9: error: ,A needs a direction that reaches its end; the line is left out [angle-form]
%
O1009
G21 G90 G54 G0 X0. Y0. Z5. F100
G1 X10. ,A90.
M30
%
