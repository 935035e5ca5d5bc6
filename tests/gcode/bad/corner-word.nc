; 3:7: error: ,R (a corner rounded or chamfered, a line by its angle) is not simulated; the block is left out [corner-word]
G21 G90 F100 G0 X0 Y0 Z0 (LinuxCNC)
G1 X10,R2
