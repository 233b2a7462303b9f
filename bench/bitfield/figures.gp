# gnuplot -e "folder='DIR'" figures.gp: what is culled, gained and missed against the number of samples.
data = folder . "/curves.dat"
bars = folder . "/histograms.dat"
set terminal pngcairo size 640,400 background rgb "#faf9f6" font "sans,11" linewidth 1.4
set grid xtics ytics linecolor rgb "#dddad2"
set border 3 linecolor rgb "#555555"
set tics nomirror
set key outside right top reverse Left
stats data using 1 nooutput
blocks = STATS_blocks
array colours[6] = ["#c8102e", "#457b9d", "#4f9d69", "#f4a259", "#7b6db0", "#111111"]
colour(i) = int("0x" . substr(colours[i % 6 + 1], 2, 7))
set xlabel "samples"
set xtics (6, 14, 25, 55)
set output folder . "/culled.png"
set ylabel "culled, per cent of the polygons"
set yrange [0:100]
plot for [i = 0:blocks - 1] data index i using 1:2 with linespoints pointtype 7 pointsize 0.7 linecolor rgb colour(i) title columnheader(1)
set output folder . "/speed_up.png"
set ylabel "time of the whole model / time of the list"
set yrange [0:*]
plot for [i = 0:blocks - 1] data index i using 1:3 with linespoints pointtype 7 pointsize 0.7 linecolor rgb colour(i) title columnheader(1)
set output folder . "/missed.png"
set ylabel "missed pixels of 255 x 255, mean"
set logscale y
set yrange [0.1:*]
plot for [i = 0:blocks - 1] data index i using 1:4 with linespoints pointtype 7 pointsize 0.7 linecolor rgb colour(i) title columnheader(1)
unset logscale
set yrange [0:*]
set output folder . "/histogram.png"
set xlabel "difference of grey"
set xtics auto
set ylabel "missed pixels a view, 25 samples"
plot for [i = 0:blocks - 1] bars index i using 1:2 with histeps linewidth 2 linecolor rgb colour(i) title columnheader(1)
