; strict: 2:10: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
F1 G90.1 G2 X10 I5
M2
