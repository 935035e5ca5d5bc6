; 3:1: error: the cutter cannot reach this inside corner without gouging [compensation-gouge]
G41.1 D10 G1 X20 F100
Y3
X0
