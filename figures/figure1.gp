# Figure 1: the chain at rest, with springs, dampers, stops and forcing: (a) of N masses, (b) of two
# masses, to the scale of the displacements. With the kind gif, (b) moves through two forcing periods
# of Figure 2; with the kind svg, every twentieth frame of this is a page of a second file.
load 'figures/style.gp'

chain = data.'/figure1.csv'
eval read(chain, 'amplitude').read(chain, 'side').read(chain, 'stop')
masses = STATS_records
array shift[9]; array action[9]
do for [i = 1:9] { shift[i] = 0; action[i] = '' }

# The masses stand on a floor, which goes beyond the place of the last mass by `right`. A spring and a
# damper join each to the one before, the first to a wall. Where `masses_left_out` is 1, dots stand for
# some masses before the last one.
distance = 2.4
half = 0.4  # of the width of a mass; the wall stands at this place, so that the links are equal
face(i, side) = i == 0 ? half : i * distance + shift[i] + side * half
along(i, part) = face(i - 1, 1) + part * (face(i, -1) - face(i - 1, 1))
face_of_stop(i) = i * distance + stop[i] + side[i] * half
subscript(i) = masses_left_out && i == masses ? 'N' : sprintf('%d', i)
dots_before(i) = masses_left_out && i == masses

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
dots(i) = sprintf("set label '{/*1.5 · · ·}' at %g, 0.62 center; ", along(i, 0.5))
colour_of(i) = action[i] eq 'sticks' ? '#e0a030' : masses_left_out ? '#e6e6e6' : i == 1 ? '#c9d6e6' : '#f3d3cb'
name_of_stop(i) = sprintf('{/:Italic s}_{%s}', subscript(i)).(masses_left_out ? '' : ' = '.number('%g', stop[i]))
body(i) = (dots_before(i) ? dots(i) : damper(i)).box(face(i, -1), 0, face(i, 1), 1, colour_of(i)). \
  box(face_of_stop(i), 0, face_of_stop(i) + side[i] * 0.07, 0.3, action[i] eq 'impact' ? '#d00000' : '#707070'). \
  sprintf("set label '{/:Italic m}_{%s}' at %g, 0.6 center front; ", subscript(i), i * distance + shift[i]). \
  sprintf("set label '{/*0.9 %s}' at %g, -0.14 center; ", name_of_stop(i), face_of_stop(i) - side[i] * 0.5 * abs(stop[i])). \
  sprintf("set label '%s' at %g, 1.2 center; ", action[i], i * distance)
ground(n) = box(half - 0.12, -0.06, half, 1.1, '#b0b0b0').box(half - 0.12, -0.06, n * distance + right, 0, '#b0b0b0')
set samples 401
# Draws the chain on a canvas or in a part of it.
draw_chain = "unset border; unset tics; unset xlabel; unset ylabel; set size ratio -1; ". \
  "eval ground(masses); do for [i = 1:masses] { eval body(i) }; ". \
  "set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0; set xrange [half - 0.25:masses * distance + right + 0.1]; ". \
  "plot for [i = 1:masses] [part = 0:1] '+' using (dots_before(i) ? NaN : along(i, $1)):(zigzag($1)) with lines lc rgb '#202020' dt solid; ". \
  "unset object; unset arrow; unset label"

# The symbols of each mass in Figure 1: its displacement, its forcing, its spring and damper, and its gap.
force(i) = masses_left_out ? sprintf('{/:Italic A}_{%s} cos Ω{/:Italic t}', subscript(i)) : \
  sprintf('{/:Italic A}_%d cos Ω{/:Italic t},  {/:Italic A}_%d = %g', i, i, amplitude[i])
arrow(i, y, width) = sprintf("set arrow from %g, %g to %g, %g lw %g; ", i * distance, y, i * distance + 0.4, y, width)
text_at(i, y, text) = sprintf("set label '%s' at %g, %g; ", text, i * distance + 0.46, y)
link(i) = sprintf("set label '{/:Italic k}_%d' at %g, %g center; ", i, along(i, 0.5), masses_left_out ? 1.08 : 1.02). \
  sprintf("set label '{/:Italic c}_%d' at %g, 0.22 center; ", i, along(i, 0.5))
gap(i) = sprintf("set arrow from %g, 0.15 to %g, 0.15 heads size 0.05, 20 lw 1 front; ", face(i, side[i]), face_of_stop(i))
named(i) = (dots_before(i) ? '' : link(i)).gap(i).arrow(i, 1.36, 1). \
  sprintf("set arrow from %g, 1.05 to %g, 1.66 nohead lt 3; ", i * distance, i * distance). \
  text_at(i, 1.36, sprintf('{/:Italic x}_{%s}', subscript(i))). \
  (masses_left_out || amplitude[i] > 0 ? arrow(i, 1.6, 2.5).text_at(i, 1.6, force(i)) : '')

if (kind ne 'gif') {
  eval opened('figure1', 1400, 850).'; set multiplot'
  set yrange [-0.2:1.75]
  do for [part = 1:2] {
    masses_left_out = part == 1
    right = part == 1 ? 1.5 : 1
    if (part == 1) { masses = 3; array stop[3] = [-0.3, 0.2, 0.25]; array side[3] = [-1, 1, 1] }
    if (part == 2) { masses = 2; eval read(chain, 'side').read(chain, 'stop') }
    set size noratio 1, part == 1 ? 0.4 : 0.57
    set origin 0, part == 1 ? 0.6 : 0
    set label 1 part == 1 ? '(a)  {/:Italic N} masses' : '(b)  two masses' at graph 0.01, graph 0.95
    do for [i = 1:masses] { eval named(i) }
    eval draw_chain
  }
  unset multiplot
}
if (kind eq 'gif' || kind eq 'svg') {
  motion = data.'/figure1_motion.csv'
  right = 1; masses_left_out = 0
  stats [*:*] [*:*] motion using 't' nooutput
  begin = STATS_min; end = STATS_max; frames = STATS_records
  eval scenes('figure1')
  if (kind eq 'gif') {
    set terminal gif animate delay 10 loop 0 optimize size 720,420 font 'Liberation Serif,15' background rgb '#ffffff'
    set output data.'/motion.gif'
  }
  if (kind eq 'svg') {
    set terminal svg size 720,420 font 'Liberation Serif,15'
    set output data.'/figure1_motion.svg'
  }
  # Mass 2 is dashed, which the terminal gif cannot do by itself: these are the pieces of its curve in
  # every other stretch of 0.6 units of time. Frames are 0.2 or 0.6 apart.
  from(t, x) = (last_t = from_t, last_x = from_x, from_t = t, from_x = x, \
    t <= now && int((last_t - begin) / 0.6 + 0.1) % 2 == 0 ? last_t : NaN)
  # A gif keeps the colours of its first frame, under which passes 1 and 2 draw all that appear later.
  do for [k = 1:frames:(kind eq 'gif' ? 1 : 20)] {
    set multiplot
    do for [pass = (k == 1 && kind eq 'gif' ? 1 : 3):3] {
      stats [*:*] [*:*] motion every ::k::k using (now = pass == 3 ? $1 : end, shift[1] = $2, shift[2] = $3, \
        action[1] = word('sticks impact '.strcol(4), pass), action[2] = word('sticks impact '.strcol(5), pass), 0) nooutput
      do for [i = 1:masses] { if (action[i] eq '-') { action[i] = '' } }
      set origin 0, 0; set size noratio 1, 1; clear
      set label 1 'Figure 2 in motion:  '.known('Ω', omega[1], 'Ω').',  '.known('r', r[1], '').sprintf(',  force %g cos Ω{/:Italic t} on mass 1', amplitude[1]) at screen 0.02, 0.965
      set label 2 sprintf('{/:Italic t} = %.2f', now) at screen 0.2, 0.42 center
      set origin 0, 0.46; set size 1, 0.48; set yrange [-0.2:1.35]
      eval draw_chain
      set origin 0, 0; set size noratio 1, 0.46
      set border; set xtics 5; set ytics 0.2; set xlabel time; set ylabel 'Displacement'
      set lmargin 8; set rmargin 5; set tmargin 2; set bmargin 3.2
      set xrange [begin:end]; set yrange [-0.55:0.4]
      set key horizontal maxrows 1 samplen 2 at graph 0.82, graph 1.32 right
      set label 9 '– –  mass 2' at graph 0.98, graph 1.2 right textcolor lt 2
      do for [i = 1:masses] { set label i sprintf('{/:Italic s}_%d', i) at graph 1.01, first stop[i] }
      plot for [i = 1:masses] stop[i] lt 3, \
        for [i = 1:masses] motion using 't':($1 <= now ? stuck(column('x'.i), stop[i]) : NaN) with lines lt 7 lw 8 title (i == 1 ? 'sticks' : ''), \
        motion using 't':($1 <= now ? column('x1') : NaN) with lines lt 1 lw 2 title 'mass 1', \
        from_t = begin, from_x = NaN, '' using (from(column('t'), column('x2'))):(last_x):($1 - last_t):(column('x2') - last_x) \
          with vectors nohead lt 2 dt solid lw 2, \
        for [i = 1:masses] '+' using (now):(shift[i]) every ::::0 with points pt 7 lt i
      unset label; unset key
    }
    unset multiplot
  }
}
unset output
