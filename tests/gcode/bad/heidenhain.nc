; 2:1: error: this is a program for Heidenhain controls, which is not read here: BEGIN PGM (line 2), TOOL CALL (line 3), FMAX (line 4), R0 F (line 4) [foreign-program]
0 BEGIN PGM TEST MM
1 TOOL CALL 1 Z S1000
2 L X+10 Y+10 R0 FMAX
