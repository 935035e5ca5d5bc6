; 2:1: error: this is a program for Heidenhain controls: BEGIN PGM (line 2), TOOL CALL (line 3), FMAX (line 4), R0 F (line 4), lines like L X+10 and CC X+10 (line 4); it is not read here: post it for a control with G-code, such as LinuxCNC's or Fanuc's, or, if it is that already, name the control (--dialect) [foreign-program]
0 BEGIN PGM TEST MM
1 TOOL CALL 1 Z S1000
2 L X+10 Y+10 R0 FMAX
