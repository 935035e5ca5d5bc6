; 5:4: error: ,A needs one coordinate of its end, or a next line with both and its own ,A (G90); the line is left out [angle-form]
%
O1010
G21 G90 G54 G0 X0. Y0. Z5. F100
G1 ,A90.
X10. Y10.
M30
%
