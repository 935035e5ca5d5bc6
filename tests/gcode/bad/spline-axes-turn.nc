; 2:1: error: G5 moves linear axes only, so A is not followed [spline-axes]
G5 X1 Y0 I1 J1 P-1 Q1 A90 F1
