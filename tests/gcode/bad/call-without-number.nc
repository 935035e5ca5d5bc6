; 2:1: error: M98 needs the number of a program (P) [call-without-number]
M98
