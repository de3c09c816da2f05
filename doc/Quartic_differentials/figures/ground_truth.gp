# Errors under refinement, from the numbers that benchmark_ground_truth writes with --data:
#   gnuplot -e "data='ground_truth.dat'; picture='ground_truth.svg'" ground_truth.gp
set terminal svg size 1100,460 font "Helvetica,13" background rgb "white"
set output picture
# the triangulations of the first five have automorphisms that make Π exact
symmetric = 5
surfaces = "'y^2 = x^6 - 1' 'y^2 = x^{12} - 1' 'y^2 = x^{22} - 1' 'regular 8-gon' 'L of three squares' \
            'y^2 = x^6 - 1, split at random' 'L of three squares, split at random' 'cover, 6 real points' \
            'cover, y^2 = x^5 - x' 'cover, 8 complex points' 'torus of revolution'"
plain(name) = system("echo '".name."' | tr -d '{}'")   # as the block of the data is called

colours = "#1f4e9e #3f8fd0 #7cc4e8 #c05a00 #f0a030 #202020 #9a9a20 #b01050 #e05090 #8050b0 #108050"
do for [k = 1:words(colours)] { set linetype k lc rgb word(colours, k) pt k ps 0.7 lw 1.5 }

set logscale xy
set format xy "10^{%T}"
set grid lc rgb "#dddddd"
set xlabel "triangles"
set xrange [50:3e5]
slope(p, c, x) = c * (x / 1000.0)**(-p / 2.0)   # errors of order p: the size of a triangle is h^2

set multiplot
set lmargin at screen 0.07
set rmargin at screen 0.35
set title "Dirichlet products S"
set ylabel "relative error"
unset key
plot for [k = 1:words(surfaces)] data index plain(word(surfaces, k)) using 1:2 with linespoints lt k, \
     slope(1, 0.9, x) with lines lc rgb "#888888" dt 2, slope(2, 4e-3, x) with lines lc rgb "#888888" dt 4

set lmargin at screen 0.41
set rmargin at screen 0.69
set title "period matrix Π"
unset ylabel
set key at screen 0.70, 0.92 left top vertical Left reverse samplen 2 spacing 1.15
plot for [k = 1:symmetric] keyentry with linespoints lt k title word(surfaces, k), \
     for [k = symmetric + 1:words(surfaces)] data index plain(word(surfaces, k)) using 1:3 \
       with linespoints lt k title word(surfaces, k), \
     slope(1, 3e-2, x) with lines lc rgb "#888888" dt 2 title "order 1", \
     slope(2, 2e-6, x) with lines lc rgb "#888888" dt 4 title "order 2"
unset multiplot
