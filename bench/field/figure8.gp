# gnuplot -e "folder='DIR'" figure8.gp: marked cells, time and wrong pixels of `turtles` against look-ups.
data = folder . "/figure8.dat"
set terminal pngcairo size 1500,560 background rgb "#faf9f6" font "sans,11"
set output folder . "/figure8.png"
array colours[4] = ["#111111", "#c8102e", "#2a6bb0", "#4f9d45"]
colour(i) = i == 12 ? "#999999" : colours[i % 4 + 1]
dash(i) = i == 12 ? 1 : int(i / 4) + 1
point(i) = i == 12 ? 2 : (int(i / 4) == 0 ? 7 : (int(i / 4) == 1 ? 5 : 9))
set multiplot layout 1,3 margins 0.05,0.87,0.12,0.9 spacing 0.055,0
set logscale x
set xrange [0.8:125]
set xtics (1, 4, 9, 25, 100)
set grid xtics ytics linecolor rgb "#dddad2"
set border 3 linecolor rgb "#555555"
set tics nomirror
set xlabel "one pixel of so many is looked up"
unset key
set yrange [0:*]
set title "marked cells"
plot for [i = 0:12] data index i using 1:2 with linespoints linecolor rgb colour(i) dashtype dash(i) pointtype point(i)
set logscale y
set yrange [*:*]
set title "time: looking up and drawing, % of drawing all"
plot for [i = 0:12] data index i using 1:3 with linespoints linecolor rgb colour(i) dashtype dash(i) pointtype point(i)
set key outside right top Left reverse
set title "pixels that differ from the picture of everything, %"
plot for [i = 0:12] data index i using 1:4 with linespoints linecolor rgb colour(i) dashtype dash(i) pointtype point(i) \
     title columnheader(1)
unset multiplot
