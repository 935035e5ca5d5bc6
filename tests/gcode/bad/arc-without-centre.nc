; 2:1: error: G2 needs a centre (I J) or a radius (R) [arc-without-centre]
G2 X10 F100
