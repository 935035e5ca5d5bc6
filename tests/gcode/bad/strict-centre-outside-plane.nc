; strict: 2:14: error: K lies outside the plane of G2; it is passed over [centre-outside-plane]
F1 G2 X1 I.5 K0
