#version 3.7;
#declare F = function(a, b) { sin(a)*b + max(a, b, 2) };
#declare A = array[3] { 1, F(1, 2), <1, 2, 3>.y };
#macro M(N, V) #local I = 0; #while (I < N) box { V + I, V + I + 0.5 interior { ior A[0] + 0.5 } } #declare I = I + 1; #end #end
#for (K, 0, 1, 0.5) M(2, <2, K*9 + 2, 2>) #end
#switch (A[1]) #case (2) #warning concat("a", str(1, 3, 2)) #break #range (0, 9) #debug chr(65) #break #else #error "x" #end
#ifdef (A) camera { location <0, 0, -5 + vlength(A[0]*x)> look_at vnormalize(<1, 2, 3>) right image_width/image_height*x } #end
#declare T = transform { rotate 20*y scale <1, 2, 1> matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0> inverse }
union { M(1, 30*x) object { box { 20, 21 interior { ior 1.5 } } transform T } }
