#macro Again(N) Again(N + 1) #end
Again(0)
