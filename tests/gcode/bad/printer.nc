; 2:1: error: this is a program for a 3-D printer: M140 heats a bed (line 2), M104 heats an extruder (line 3), G92 E (line 4); it is not read here: only milling is simulated; if it mills, name its control (--dialect) [foreign-program]
M140 S60
M104 S200
G92 E0
G1 X1 E1
