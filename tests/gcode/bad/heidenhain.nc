; 5:1: error: TCH PROBE is not read; the program is stopped here [klartext-verb]
0 BEGIN PGM TEST MM
1 TOOL CALL 1 Z S1000
2 L X+10 Y+10 R0 FMAX
TCH PROBE 400 BASIC ROTATION
