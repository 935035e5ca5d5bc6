; 2:1: error: ATAN wants two values: ATAN[y]/[x] [atan-form]
Xpow[1]
