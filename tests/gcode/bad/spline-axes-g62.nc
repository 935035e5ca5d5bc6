; 2:4: error: G6.2 moves X and Y only, so Z is not followed [spline-axes]
F1 G6.2 P3 K0 X3 Y0 R1 Z-3
