; strict: 2:4: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
F1 G2 X1
M2
