## motion = scara_held (MOTION, D): a motion with a rest of D seconds at its end.

function motion = scara_held (motion, d)
  coefs = reshape (motion.coefs, 4, motion.pieces, motion.order);
  rest = zeros (4, 1, motion.order);
  rest(:,1,end) = ppval (motion, motion.breaks(end));
  motion = mkpp ([motion.breaks, motion.breaks(end) + d], cat (2, coefs, rest), 4);
endfunction
