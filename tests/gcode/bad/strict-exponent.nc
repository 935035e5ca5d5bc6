; strict: 2:9: error: no code of this block uses E [word-unused]
F1 G1 X1E3
M2
