; 2:5: error: O1234 is not in this program, and there is no file with its name, nor one file alone in which it begins [sub-not-found]
M98 P1234
