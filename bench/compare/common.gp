# What both pictures share. Blocks of points in `data`, each named in its first line.
set terminal svg size 820,560 dynamic background rgb "#faf9f6" font "sans,13" fontscale 1 linewidth 1.2
set logscale xy
set format y "10^{%L}"
set grid xtics ytics linecolor rgb "#dddad2"
set border 3 linecolor rgb "#555555"
set tics nomirror
set key outside right top reverse Left
set ylabel "milliseconds a view, one thread"
stats data using 0 nooutput
blocks = STATS_blocks
