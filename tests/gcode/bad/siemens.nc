; 4:1: error: CYCLE79 is not read; the program is stopped here [not-read]
WORKPIECE(,,,"BOX",112,0,-20,-80,0,0,100,100)
CYCLE800()
CYCLE79(10,0,2,15,40,50)
G1 X1
