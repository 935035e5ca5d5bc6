; 2:1: error: this is a program for a 3-D printer, which is not read here: M140 heats a bed (line 2), M104 heats an extruder (line 3), G92 E (line 4) [foreign-program]
M140 S60
M104 S200
G92 E0
G1 X1 E1
