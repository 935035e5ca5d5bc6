; 3:1: error: G154 needs the number of a coordinate system (P), 1 to 300 [offset-number]
G0 X0
G154 X0
