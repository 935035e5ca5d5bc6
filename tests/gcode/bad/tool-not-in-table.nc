; strict: 2:5: error: the tool table has no tool 9 [tool-not-in-table]
G42 D9
M2
