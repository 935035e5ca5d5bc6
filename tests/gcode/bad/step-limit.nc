; 3:1: error: the program runs on and on; it is stopped here [step-limit]
o1 while [1]
o1 endwhile
