; 2:1: error: there is no line N100 [line-not-found]
GOTO 100
