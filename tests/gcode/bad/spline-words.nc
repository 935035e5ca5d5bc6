; 2:1: error: G5 needs P and Q [spline-words]
G5 X1 F1
