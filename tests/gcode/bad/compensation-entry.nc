; strict: 2:11: error: the first move with cutter compensation must be longer than the cutter radius [compensation-entry]
G41.1 D10 G1 X2 F100
