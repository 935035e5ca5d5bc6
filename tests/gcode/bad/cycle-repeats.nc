; 2:15: error: the number of repeats must be 1 or more, and not without end [cycle-repeats]
G81 X1 Z-1 R1 L1000000 F1
