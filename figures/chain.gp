# Figure 1: the two masses at rest, with springs, dampers, stops and forcing, to the scale of the
# displacements. With the kind gif the same picture moves through two forcing periods of Figure 2.
load 'figures/style.gp'

chain = data.'/chain.csv'
eval read(chain, 'amplitude').read(chain, 'side').read(chain, 'stop')
masses = STATS_records
array shift[masses]; array action[masses]
do for [i = 1:masses] { shift[i] = 0; action[i] = '' }

# The masses stand on a floor. A spring and a damper join each to the one before, the first to a wall.
distance = 2.4
half = 0.4  # of the width of a mass; the wall stands at this place, so that the links are equal
face(i, side) = i == 0 ? half : i * distance + shift[i] + side * half
along(i, part) = face(i - 1, 1) + part * (face(i, -1) - face(i - 1, 1))
face_of_stop(i) = i * distance + stop[i] + side[i] * half

line(x0, y0, x1, y1) = sprintf("set arrow from %g, %g to %g, %g nohead lc rgb '#202020'; ", x0, y0, x1, y1)
box(x0, y0, x1, y1, colour) = sprintf("set object rectangle from %g, %g to %g, %g fc rgb '%s' ", \
  x0, y0, x1, y1, colour)."fs solid border rgb '#202020'; "
zigzag(part) = 0.8 + (abs(part - 0.5) > 0.35 ? 0 : 0.07 * asin(sin(2 * pi * 10 * (part - 0.15))))
# The cylinder of a damper keeps its length; the piston moves in it.
end_of_cylinder(i, side) = along(i, 0.5) + side * 0.25
cylinder(left, right) = line(left, 0.38, left, 0.62).line(left, 0.38, right, 0.38).line(left, 0.62, right, 0.62)
piston(i) = along(i, 0.5) + 0.25 * (face(i, -1) - face(i - 1, 1) - distance + 2 * half)
damper(i) = line(face(i - 1, 1), 0.5, end_of_cylinder(i, -1), 0.5). \
  cylinder(end_of_cylinder(i, -1), end_of_cylinder(i, 1)). \
  line(piston(i), 0.5, face(i, -1), 0.5).line(piston(i), 0.41, piston(i), 0.59)
colour_of(i) = action[i] eq 'sticks' ? '#e0a030' : i == 1 ? '#c9d6e6' : '#f3d3cb'
body(i) = damper(i).box(face(i, -1), 0, face(i, 1), 1, colour_of(i)). \
  box(face_of_stop(i), 0, face_of_stop(i) + side[i] * 0.07, 0.3, action[i] eq 'impact' ? '#d00000' : '#707070'). \
  sprintf("set label '{/:Italic m}_%d' at %g, 0.6 center front; ", i, i * distance + shift[i]). \
  sprintf("set label '%s' at %g, 1.2 center; ", action[i], i * distance)
ground = box(half - 0.12, -0.06, half, 1.1, '#b0b0b0').box(half - 0.12, -0.06, masses * distance + 1, 0, '#b0b0b0')
set samples 401
# Draws the chain on a canvas or in a part of it.
draw_chain = "unset border; unset tics; unset xlabel; unset ylabel; set size ratio -1; ". \
  "eval ground; do for [i = 1:masses] { eval body(i) }; ". \
  "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0; set xrange [half - 0.25:masses * distance + 1.1]; ". \
  "plot for [i = 1:masses] [part = 0:1] '+' using (along(i, $1)):(zigzag($1)) with lines lc rgb '#202020' dt solid; ". \
  "unset object; unset arrow; unset label"

if (kind ne 'gif') {
  eval opened('chain', 1400, 520)
  set yrange [-0.2:1.75]
  do for [i = 1:masses] {
    set label sprintf('{/:Italic k}_%d', i) at along(i, 0.5), 1.02 center
    set label sprintf('{/:Italic c}_%d', i) at along(i, 0.5), 0.22 center
    set arrow from i * distance, 1.05 to i * distance, 1.66 nohead lt 3
    set arrow from i * distance, 1.36 to i * distance + 0.4, 1.36 lw 1
    set label sprintf('{/:Italic x}_%d', i) at i * distance + 0.46, 1.36
    if (amplitude[i] > 0) {
      set arrow from i * distance, 1.6 to i * distance + 0.4, 1.6 lw 2.5
      set label sprintf('force %g cos Ω{/:Italic t}', amplitude[i]) at i * distance + 0.46, 1.6
    }
    set arrow from face(i, side[i]), 0.15 to face_of_stop(i), 0.15 heads size 0.05, 20 lw 1 front
    set label sprintf('{/*0.85 s_%d = %g}', i, stop[i]) at 0.5 * (face(i, side[i]) + face_of_stop(i)), -0.14 center
  }
  eval draw_chain
} else {
  set terminal gif animate delay 8 loop 0 optimize size 800,420 font 'Liberation Serif,15' background rgb '#ffffff'
  set output data.'/motion.gif'
  motion = data.'/chain_motion.csv'
  stats motion using 't' nooutput
  begin = STATS_min; end = STATS_max; frames = STATS_records
  # A gif keeps the colours of its first frame, under which passes 1 and 2 draw all that appear later.
  do for [k = 1:frames] {
    set multiplot
    do for [pass = (k == 1 ? 1 : 3):3] {
      stats [*:*] [*:*] motion every ::k::k using (now = pass == 3 ? $1 : end, shift[1] = $2, shift[2] = $3, \
        action[1] = word('sticks impact '.strcol(4), pass), action[2] = word('sticks impact '.strcol(5), pass), 0) nooutput
      set origin 0, 0; set size noratio 1, 1; clear
      set origin 0, 0.48; set size 1, 0.52; set yrange [-0.1:1.35]
      eval draw_chain
      set origin 0, 0; set size noratio 1, 0.48
      set border; set xtics 5; set ytics 0.2; set xlabel 'Time'; set ylabel 'Displacement'
      set lmargin 8; set rmargin 3; set tmargin 0.5; set bmargin 3.2
      set xrange [begin:end]; set yrange [-0.55:0.4]
      plot for [i = 1:masses] stop[i] lt 3, \
        for [i = 1:masses] motion using 't':($1 <= now ? stuck(column('x'.i), stop[i]) : NaN) with lines lt 7 lw 8, \
        for [i = 1:masses] motion using 't':($1 <= now ? column('x'.i) : NaN) with lines lt i dt solid lw 2, \
        for [i = 1:masses] '+' using (now):(shift[i]) every ::::0 with points pt 7 lt i
    }
    unset multiplot
  }
}
unset output
