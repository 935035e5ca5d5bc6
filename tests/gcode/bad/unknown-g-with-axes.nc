; 2:1: error: G150 is not known, so nobody can say where its axis words lead; the block is left out [unknown-g-with-axes]
G150 X1 Y2
