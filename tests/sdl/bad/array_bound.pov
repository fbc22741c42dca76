#declare A = array[3] { 1, 2, 3 }
#declare B = A[3];
#declare C = A[-1];
sphere { B*x, C }
