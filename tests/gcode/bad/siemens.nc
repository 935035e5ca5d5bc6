; 4:1: error: SLOT2 is not read; the program is stopped here [not-read]
WORKPIECE(,,,"BOX",112,0,-20,-80,0,0,100,100)
CYCLE800()
SLOT2(10,0,2,15,40,50)
G1 X1
