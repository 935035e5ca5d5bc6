; strict: 2:1: error: G81 needs R [cycle-word-missing]
G81 X1 Z-1 F1
M2
