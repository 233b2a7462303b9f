# gnuplot -e "folder='DIR'" complexity.gp: time against visible complexity.
data = folder . "/complexity.dat"
load ARG0[1:strlen(ARG0) - strlen("complexity.gp")] . "common.gp"
set output folder . "/complexity.svg"
set title "Time of a view against what is to be seen, every view of every scene"
set xlabel "vertices of the exact map"
plot for [i = 0:blocks - 1] data index i using 1:2 with points pointtype 7 pointsize 0.4 linecolor rgb colour(i) \
     title columnheader(1)
