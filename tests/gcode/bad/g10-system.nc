; 2:5: error: G10 P must name a coordinate system, 0 to 9 [g10-system]
G10 P-1 L2 X1
