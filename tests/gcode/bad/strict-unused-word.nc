; strict: 2:7: error: no code of this block uses H [word-unused]
G0 X1 H1
M2
