#declare I = 0;
#while (I < Count)
  sphere { I*x, 1 }
  #declare I = I + 1;
#end
#for (K, 0, 3, 0) box { 0, K } #end
