; strict: 2:4: error: G28 and a motion in one block both want the axis words [two-codes-use-axes]
G0 G28 Z0
