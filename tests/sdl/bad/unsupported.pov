#fopen Log "log.txt" write
#declare S = sphere { 0, 1 }
#declare P = trace(S, <0,0,-5>, z);
#declare F = function { internal(75) }
#declare Q = F(1, 2, 3);
