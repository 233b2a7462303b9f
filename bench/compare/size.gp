# gnuplot -e "folder='DIR'" size.gp: time against scene size.
data = folder . "/size.dat"
load ARG0[1:strlen(ARG0) - strlen("size.gp")] . "common.gp"
set output folder . "/size.svg"
set title "Median time of a view of a building against its size"
set xlabel "polygons of the scene"
set format x "10^{%L}"
plot for [i = 0:blocks - 1] data index i using 1:2 with linespoints pointtype 7 pointsize 0.6 linecolor rgb colour(i) \
     title columnheader(1)
