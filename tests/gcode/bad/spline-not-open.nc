; 2:1: error: G5.3 closes a curve that no G5.2 opened [spline-not-open]
G5.3 F1
