; strict: 2:4: error: G81 cannot turn rotary axes [cycle-rotary]
F1 G81 X1 A1 Z-1 R1
M2
