; 2:1: error: Onowhere is not in this program and there is no file with its name [sub-not-found]
o<nowhere> call
