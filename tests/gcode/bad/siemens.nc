; 2:1: error: this is a program for Siemens controls, which is not read here: WORKPIECE (line 2), CYCLE800 (line 3) [foreign-program]
WORKPIECE(,,,"BOX",112,0,-20,-80,0,0,100,100)
CYCLE800()
G1 X1
