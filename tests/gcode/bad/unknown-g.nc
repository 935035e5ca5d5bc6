; 2:1: error: G199 is not known: it may move the tool or change what other words mean; the block is left out. If it is harmless, say so with --allow G199 [unknown-g]
G199 P1
