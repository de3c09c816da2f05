# Time by stage against size, from the numbers that benchmark_pipeline writes with --data:
#   gnuplot -e "data='times.dat'; picture='times.svg'" times.gp
set terminal svg size 1000,560 font "Helvetica,13" background rgb "white"
set output picture
stages = "'read' 'homology' 'refinement' 'holomorphic_forms' 'period_matrix' 'legalization' 'cone_metric' 'holonomy' \
          'immersion' 't_mesh' 'quads' 'splines' 'floor'"
colours = "#8a8a8a #1f4e9e #3f8fd0 #108050 #9a9a20 #c05a00 #b01050 #e05090 #8050b0 #7a3b10 #f0a030 #40b0a0 #202020"
do for [k = 1:words(colours)] { set linetype k lc rgb word(colours, k) pt k ps 0.7 lw 1.5 }

set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set grid lc rgb "#dddddd"
set xrange [4e3:2e6]
set xlabel "triangles"
set ylabel "seconds of the processor"
set key outside right top Left reverse samplen 2 spacing 1.2
set datafile missing "nan"
plot for [k = 1:words(stages)] data using "faces":word(stages, k) with linespoints lt k \
       title system("echo '".word(stages, k)."' | tr _ ' '"), \
     data using "faces":"file to T-mesh" with lines lc rgb "#000000" lw 3 title "file to T-mesh", \
     x * 2e-5 with lines lc rgb "#888888" dt 2 lw 1 title "linear", \
     (x / 1e6)**1.3 * 20 with lines lc rgb "#888888" dt 4 lw 1 title "exponent 1.3"
