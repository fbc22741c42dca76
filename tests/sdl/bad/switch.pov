#switch (1) #else #end
#switch (2)
  #case (1) sphere { 0, 1 } #break
  #case (Foo) sphere { 0, 2 } #break
#end
#break
#case (3)
