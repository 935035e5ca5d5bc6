; 3:1: error: the cutter does not fit into this arc [compensation-arc]
G41.1 D10 G1 X20 F100
G3 X20 Y4 R2
