; strict: 2:18: error: the number of repeats must be 1 or more, and not without end [cycle-repeats]
F1 G81 X1 Z-1 R1 L0
M2
