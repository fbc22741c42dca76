#macro Check(N)
  #if (N > 3)
    #error "too many"
  #end
#end
Check(5)
sphere { 0, Foo*1 }
