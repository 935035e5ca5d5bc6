; 5:9: error: R behind a straight line may mean the corner to the next (,R); the block is left out. Write the comma [corner-word]
%
O1007
G21 G90 G54 G0 X0. Y0. Z5. F100
G1 X10. R2.
Y10.
M30
%
