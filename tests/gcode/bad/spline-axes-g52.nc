; 3:1: error: G5.2 moves X and Y only, so Z is not followed [spline-axes]
F1 G5.2 X1 Y1 P1 L3
X2 Y2 Z-1
