; 2:1: error: this is a program for Siemens controls: WORKPIECE (line 2), CYCLE800 (line 3); it is not read here: post it for a control with G-code, such as LinuxCNC's or Fanuc's, or, if it is that already, name the control (--dialect) [foreign-program]
WORKPIECE(,,,"BOX",112,0,-20,-80,0,0,100,100)
CYCLE800()
G1 X1
