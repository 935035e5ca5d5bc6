; 0:1: error: there is no NC program in this file: no word of a letter and a number in it [no-program]
hello
