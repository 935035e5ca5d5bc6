; 2:8: error: the radius 2 does not reach: half the way to the end point is 5 [arc-radius-too-small]
G2 X10 R2 F100
