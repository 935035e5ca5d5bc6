; 2:1: error: G150 is a cycle or a move that is not simulated; the block is left out, and its cut is missing [not-simulated]
G150 X1 Y2
