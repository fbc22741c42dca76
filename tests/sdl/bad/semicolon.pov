#declare A = 3

#declare B = 4;
sphere { A*x, B }
