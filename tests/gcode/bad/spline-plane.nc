; 2:5: error: G5 works in the XY plane (G17) only [spline-plane]
G18 G5 X1 I1 J1 P1 Q1 F1
