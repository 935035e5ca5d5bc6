; 1:1: error: this is a program for a lathe: a comment speaks of a lathe (line 1), a comment speaks of turning (line 1), G50 S (line 2), tools like T0101 (line 3), constant surface speed (G96) (line 4), turning cycles from P to Q (line 6); it is not read here: only milling is simulated; if it mills, name its control (--dialect) [foreign-program]
G50 S2000
T0101
G96 S200
G0 X50 Z2
G71 P10 Q20 U1 W1
