# What both pictures share. Blocks of points in `data`, each named in its first line.
set terminal svg size 820,560 dynamic background rgb "#faf9f6" font "sans,13" fontscale 1 linewidth 1.2
set logscale xy
set yrange [1e-3:*]
set format y "10^{%L}"
set grid xtics ytics linecolor rgb "#dddad2"
set border 3 linecolor rgb "#555555"
set tics nomirror
set key outside right top reverse Left
set ylabel "milliseconds a view, one thread"
stats data using 0 nooutput
blocks = STATS_blocks
# Ours comes first, in black; the floor, a ray a vertex of the map, last, in grey.
array colours[12] = ["#111111", "#c8102e", "#f4a259", "#e8c547", "#8cb369", "#4f9d69", "#2a9d8f", "#457b9d", "#7b6db0", \
                     "#b56576", "#6d597a", "#355070"]
colour(i) = i == blocks - 1 ? 0xaaaaaa : int("0x" . substr(colours[i % 12 + 1], 2, 7))
