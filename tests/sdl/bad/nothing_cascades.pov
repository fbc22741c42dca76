#declare R = Typo * 2;
#declare S = R + 1;
sphere { S*x, R }
box { 0, R - S }
cylinder { 0, x, Second*1 }
