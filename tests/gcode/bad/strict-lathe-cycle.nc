; strict: 3:1: error: G76 is a cycle for lathes, which is not simulated; the program is stopped here [lathe-cycle]
G0 X1
G76 P1 Z-1 I-1 J1 K1
M2
