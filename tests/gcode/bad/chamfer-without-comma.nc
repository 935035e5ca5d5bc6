; 5:9: error: C behind a straight line may mean the corner to the next (,C); the block is left out. Write the comma, or begin with C0. if it is an axis [corner-word]
%
O1008
G21 G90 G54 G0 X0. Y0. Z5. F100
G1 X10. C4.
Y10. C2.
X0.
M30
%
