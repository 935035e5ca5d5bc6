; strict: 4:1: error: the move after G40 must be straight [compensation-exit]
F1 G41.1 D1 G1 X10
G40
G2 X20 I5
M2
